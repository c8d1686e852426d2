straightedge_add_test(NAME devices_simulated
  SOURCES devices/angle_plan_test.cpp devices/closed_loop_test.cpp devices/hall_probe_test.cpp
    devices/simulated_bench_test.cpp
  LIBRARIES straightedge::devices
  LABELS devices)
straightedge_join_tests(devices_simulated)

straightedge_add_test(NAME devices_capture
  SOURCES devices/capture_control_test.cpp devices/capture_test.cpp devices/reference_zero_test.cpp
    devices/stream_capture_test.cpp
  LIBRARIES straightedge::devices
  LABELS devices threads)
straightedge_join_tests(devices_capture)

add_executable(kill_child devices/kill_child.cpp)
target_link_libraries(kill_child PRIVATE straightedge::devices)
straightedge_add_test(NAME devices_kill
  SOURCES devices/kill_test.cpp
  LIBRARIES straightedge::devices
  LABELS devices)
add_dependencies(devices_kill kill_child)

straightedge_add_test(NAME devices_serial
  SOURCES devices/transport/dialogue_test.cpp devices/transport/serial_port_test.cpp
  LIBRARIES straightedge::devices
  LABELS devices)
straightedge_join_tests(devices_serial)

find_package(nlohmann_json 3.11 REQUIRED)
straightedge_add_test(NAME devices_instruments
  SOURCES devices/instruments/field_drivers_test.cpp
    devices/instruments/line_parser_test.cpp
    devices/instruments/meter_drivers_test.cpp
    devices/instruments/profile_test.cpp
    devices/instruments/qsb_test.cpp
  LIBRARIES straightedge::devices nlohmann_json::nlohmann_json
  LABELS devices)
straightedge_join_tests(devices_instruments)

include(app/cli/capture.cmake)

straightedge_add_test(NAME devices_field_capture
  SOURCES devices/field_capture_test.cpp
  LIBRARIES straightedge::devices
  LABELS devices threads)

straightedge_add_test(NAME devices_field_kill
  SOURCES devices/field_kill_test.cpp
  LIBRARIES straightedge::devices
  LABELS devices)

straightedge_add_test(NAME devices_field_coverage
  SOURCES devices/field_coverage_test.cpp
  LIBRARIES straightedge::core straightedge::devices
  LABELS devices)
