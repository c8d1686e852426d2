# The whole way by mouse and keyboard, and the program on a private X server (exit code 77: no Xvfb here, skipped).
straightedge_add_qt_test(NAME gui_end_to_end
  SOURCES app/gui/end_to_end/whole_way_test.cpp app/gui/end_to_end/window_driver.cpp
  LIBRARIES straightedge::window
  LABELS gui)

straightedge_add_qt_test(NAME gui_field_end_to_end
  SOURCES app/gui/end_to_end/field_whole_way_test.cpp app/gui/end_to_end/window_driver.cpp
  LIBRARIES straightedge::window
  LABELS gui)

straightedge_add_qt_test(NAME gui_under_xvfb
  SOURCES app/gui/end_to_end/under_xvfb_test.cpp
  LIBRARIES straightedge::build_flags
  LABELS gui-xvfb)
add_dependencies(gui_under_xvfb straightedge)
set_tests_properties(gui_under_xvfb PROPERTIES ENVIRONMENT "" SKIP_RETURN_CODE 77)

straightedge_add_qt_test(NAME gui_field_program
  SOURCES app/gui/end_to_end/field_program_test.cpp
  LIBRARIES straightedge::build_flags
  LABELS gui)
add_dependencies(gui_field_program straightedge straightedge-cli)
