# Tests of the window: each folder below lists its own. Qt Test or GoogleTest, always on the offscreen platform.
foreach(room plots figures document jobs shell steps steps_capture steps_fit window)
  if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/app/gui/${room}/tests.cmake)
    include(app/gui/${room}/tests.cmake)
  endif()
endforeach()
