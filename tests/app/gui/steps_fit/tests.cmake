# Presenters without widgets, then the four steps driven by mouse and keyboard.
foreach(part fit_presenter compare_presenter verify_export_presenter steps_fit step_pictures)
  straightedge_add_qt_test(NAME gui_${part}
    SOURCES app/gui/steps_fit/${part}_test.cpp
    LIBRARIES straightedge::window
    LABELS gui)
endforeach()
