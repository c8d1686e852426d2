include(fakes/usb/fakes.cmake)

straightedge_add_usb_test(NAME devices_usb
  SOURCES devices/usb/usb_bus_test.cpp devices/usb/usbtmc_dialogue_test.cpp devices/usb/usbtmc_fault_test.cpp devices/usb/usb_serial_test.cpp
  LIBRARIES straightedge::devices
  LABELS devices)
