# Figures as data need neither widgets nor a platform; the report and the files need fonts.
straightedge_add_test(NAME gui_figures
  SOURCES app/gui/figures/comparison_figures_test.cpp app/gui/figures/curve_figures_test.cpp
    app/gui/figures/sweep_figures_test.cpp
  LIBRARIES straightedge::figures
  LABELS gui)
straightedge_join_tests(gui_figures)

straightedge_add_qt_test(NAME gui_report
  SOURCES app/gui/figures/report_test.cpp
  LIBRARIES straightedge::figures
  LABELS gui)

straightedge_add_qt_test(NAME gui_field_figures
  SOURCES app/gui/figures/field_figures_test.cpp
  LIBRARIES straightedge::figures
  LABELS gui)
