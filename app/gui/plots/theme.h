// Colours and type of plots, light and dark: roles instead of fixed colours, told apart also by colour-blind eyes.
#pragma once

#include "app/gui/plots/plot_spec.h"
#include "app/gui/plots/plot_view.h"

#include <QColor>
#include <QFont>

namespace straightedge::gui {

/// Series colours follow Okabe and Ito ("Color Universal Design", 2008), darkened or lightened until each has a
/// contrast of at least 3:1 against the background (WCAG 2.1, graphical objects); text has at least 4.5:1.
struct PlotColors {
  QColor background;
  QColor text;     ///< titles, hover text
  QColor softText; ///< tick labels, notes
  QColor axis;
  QColor grid;
  QColor minorGrid;
  QColor card;       ///< background of hover text and labels
  QColor cardBorder; ///< their outline
  QColor selection;  ///< rubber band

  static PlotColors of(PlotTheme theme);
  static QColor series(SeriesColor role, PlotTheme theme);
};

/// Marker shapes differ as well as colours, for print without colour.
enum class MarkerShape : std::uint8_t { Circle, Square, Diamond, Triangle, Cross, Plus };
MarkerShape markerOf(SeriesColor role);

/// The interface's font in logical pixels, so that screen and files have one layout.
struct PlotFonts {
  QFont title, axisTitle, label, note;
  static PlotFonts standard();
};

/// (L1 + 0.05) / (L2 + 0.05) of relative luminances, 1 to 21 (WCAG 2.1).
double contrastRatio(const QColor& a, const QColor& b);

} // namespace straightedge::gui
