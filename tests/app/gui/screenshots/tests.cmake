# Pictures of every step for the eye; not a test.
find_package(Qt6 6.4 REQUIRED COMPONENTS Test Widgets)
add_executable(screenshots EXCLUDE_FROM_ALL
  app/gui/screenshots/screenshots.cpp app/gui/end_to_end/window_driver.cpp)
target_link_libraries(screenshots PRIVATE straightedge::window Qt6::Test)
