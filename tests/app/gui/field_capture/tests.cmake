# Bench link and the steps Connect and Capture of a field calibration; one program, so that it links once.
straightedge_add_qt_test(NAME gui_field_capture
  SOURCES
    app/gui/field_capture/main.cpp
    app/gui/field_capture/field_bench_link_test.cpp
    app/gui/field_capture/field_capture_pages_test.cpp
    app/gui/field_capture/field_capture_presenter_test.cpp
    app/gui/field_capture/field_plan_shape_test.cpp
  LIBRARIES straightedge::window
  LABELS "gui;threads")
add_dependencies(gui_field_capture straightedge-cli)
