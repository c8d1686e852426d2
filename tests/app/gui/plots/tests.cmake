straightedge_add_qt_test(NAME gui_plot_gallery
  SOURCES app/gui/plots/figures.cpp app/gui/plots/plot_gallery.cpp
  LIBRARIES straightedge::plots
  LABELS gui)
straightedge_add_qt_test(NAME gui_plot_numbers
  SOURCES app/gui/plots/figures.cpp app/gui/plots/plot_numbers_test.cpp
  LIBRARIES straightedge::plots straightedge::core
  LABELS gui)
straightedge_add_qt_test(NAME gui_plot_view
  SOURCES app/gui/plots/figures.cpp app/gui/plots/plot_view_test.cpp
  LIBRARIES straightedge::plots
  LABELS gui)
straightedge_add_qt_test(NAME gui_plot_picture
  SOURCES app/gui/plots/figures.cpp app/gui/plots/plot_picture_test.cpp
  LIBRARIES straightedge::plots
  LABELS gui)
straightedge_add_qt_test(NAME gui_scene_view
  SOURCES app/gui/plots/scene_view_test.cpp
  LIBRARIES straightedge::plots
  LABELS gui)
