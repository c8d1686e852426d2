# Presenters of a field calibration's steps without widgets, then the pages.
foreach(part field_presenters field_pages)
  straightedge_add_qt_test(NAME gui_${part}
    SOURCES app/gui/field_steps/${part}_test.cpp
    LIBRARIES straightedge::window
    LABELS gui)
endforeach()
