include(fakes/usb/fakes.cmake)

straightedge_add_usb_test(NAME devices_usb
  SOURCES devices/usb/access_remedy_test.cpp devices/usb/usb_bus_test.cpp devices/usb/usb_child_test.cpp devices/usb/usb_serial_test.cpp
    devices/usb/usbtmc_dialogue_test.cpp devices/usb/usbtmc_fault_test.cpp
  LIBRARIES straightedge::devices
  LABELS devices)
straightedge_join_tests(devices_usb
  devices/usb/access_remedy_test.cpp devices/usb/usb_bus_test.cpp devices/usb/usb_serial_test.cpp)
add_executable(usb_child devices/usb/usb_child.cpp)
target_link_libraries(usb_child PRIVATE straightedge::devices)
add_dependencies(devices_usb usb_child)

straightedge_add_test(NAME devices_usb_machine
  SOURCES devices/usb/usb_machine_test.cpp
  LIBRARIES straightedge::devices
  LABELS devices)
