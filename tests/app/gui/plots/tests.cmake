straightedge_add_qt_test(NAME gui_plot_gallery
  SOURCES app/gui/plots/figures.cpp app/gui/plots/plot_gallery.cpp
  LIBRARIES straightedge::plots
  LABELS gui)
