straightedge_add_qt_test(NAME gui_document
  SOURCES app/gui/document/angle_document_test.cpp
  LIBRARIES straightedge::window
  LABELS gui)
straightedge_add_qt_test(NAME gui_field_document
  SOURCES app/gui/document/field_document_test.cpp
  LIBRARIES straightedge::window
  LABELS gui)
