#include "app/gui/steps/step_page.h"

#include <QPalette>

namespace straightedge::gui {

PlotTheme plotThemeOf(const QWidget& widget) {
  return widget.palette().color(QPalette::Base).lightness() < 128 ? PlotTheme::Dark : PlotTheme::Light;
}

} // namespace straightedge::gui
