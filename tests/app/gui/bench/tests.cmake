# Real instruments in the window: presenters and panel on a pretended desk, the window on emulated USB; one program, so
# that it links once. `gui_bench --pictures FOLDER` writes pictures for the eye.
straightedge_add_qt_test(NAME gui_bench
  SOURCES
    app/gui/bench/main.cpp
    app/gui/bench/bench_draft_test.cpp
    app/gui/bench/bench_panel_test.cpp
    app/gui/bench/bench_presenter_test.cpp
    app/gui/bench/bench_window_test.cpp
    app/gui/end_to_end/window_driver.cpp
  LIBRARIES straightedge::window emulated_usb
  LABELS "gui;threads")
set_tests_properties(gui_bench PROPERTIES
  ENVIRONMENT "${STRAIGHTEDGE_QT_TEST_ENVIRONMENT};LD_PRELOAD=${STRAIGHTEDGE_USB_PRELOAD}")

# The program itself as a child process, by keyboard on a private X server (exit code 77: no Xvfb or no xdotool here,
# skipped).
straightedge_add_qt_test(NAME gui_bench_program
  SOURCES app/gui/bench/bench_program_test.cpp
  LIBRARIES straightedge::devices straightedge::core emulated_usb
  LABELS gui-xvfb)
add_dependencies(gui_bench_program straightedge)
set_tests_properties(gui_bench_program PROPERTIES
  ENVIRONMENT "QTEST_FUNCTION_TIMEOUT=${STRAIGHTEDGE_TEST_LIMIT_S}000;LD_PRELOAD=${STRAIGHTEDGE_USB_PRELOAD}"
  SKIP_RETURN_CODE 77)
