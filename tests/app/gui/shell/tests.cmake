straightedge_add_qt_test(NAME gui_shell
  SOURCES app/gui/shell/main_window_test.cpp app/gui/shell/scripted_prompts.h
  LIBRARIES straightedge::window
  LABELS gui)
straightedge_add_qt_test(NAME gui_field_window
  SOURCES app/gui/shell/field_window_test.cpp app/gui/shell/scripted_prompts.h
  LIBRARIES straightedge::window
  LABELS gui)
straightedge_add_qt_test(NAME gui_shell_parts
  SOURCES app/gui/shell/shell_parts_test.cpp
  LIBRARIES straightedge::window
  LABELS gui)
straightedge_add_qt_test(NAME gui_shell_pictures
  SOURCES app/gui/shell/shell_pictures.cpp app/gui/shell/scripted_prompts.h
  LIBRARIES straightedge::window
  LABELS gui)
