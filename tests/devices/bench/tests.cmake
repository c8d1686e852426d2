straightedge_add_test(NAME devices_bench
  SOURCES devices/bench/bench_check_test.cpp devices/bench/device_listing_test.cpp devices/bench/reading_pairing_test.cpp
    devices/bench/saved_bench_test.cpp
  LIBRARIES straightedge::devices
  LABELS devices)
straightedge_join_tests(devices_bench)

# The real program as a child process on emulated instruments.
straightedge_add_usb_test(NAME bench_cli
  SOURCES app/cli/child_process.cpp devices/bench/bench_capture_test.cpp
    devices/bench/bench_cli_test.cpp devices/bench/emulated_field_desk.cpp
    devices/bench/field_bench_capture_test.cpp
  LIBRARIES straightedge::core straightedge::devices nlohmann_json::nlohmann_json
  LABELS cli)
straightedge_join_tests(bench_cli)
add_dependencies(bench_cli straightedge-cli)

# Benches in the test's own process, on emulated instruments.
straightedge_add_usb_test(NAME bench_usb
  SOURCES devices/bench/bench_talk_test.cpp devices/bench/opened_bench_test.cpp
  LIBRARIES straightedge::core straightedge::devices
  LABELS devices)

# Streams of benches that are open in the test's own process.
straightedge_add_usb_test(NAME bench_streams
  SOURCES devices/bench/bench_stream_test.cpp
  LIBRARIES straightedge::core straightedge::devices
  LABELS devices)
