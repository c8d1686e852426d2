# Bench link and the steps Connect, Capture and Review; one program, so that it links once.
straightedge_add_qt_test(NAME gui_steps_capture
  SOURCES
    app/gui/steps_capture/main.cpp
    app/gui/steps_capture/bench_link_test.cpp
    app/gui/steps_capture/capture_presenter_test.cpp
    app/gui/steps_capture/connect_presenter_test.cpp
    app/gui/steps_capture/live_trace_test.cpp
    app/gui/steps_capture/review_test.cpp
    app/gui/steps_capture/step_pages_test.cpp
  LIBRARIES straightedge::window
  LABELS "gui;threads")
