straightedge_add_test(NAME devices_capture
  SOURCES devices/capture_test.cpp
  LIBRARIES straightedge::devices
  LABELS devices threads)
include(app/cli/capture.cmake)
