#include "app/gui/steps/step_colors.h"

#include "app/gui/steps/step_page.h"

namespace straightedge::gui {

QColor stepColor(const QWidget& widget, StepColor color) {
  const bool dark = plotThemeOf(widget) == PlotTheme::Dark;
  switch (color) {
  case StepColor::Faint:
    return dark ? QColor(0x4a, 0x50, 0x58) : QColor(0xc9, 0xce, 0xd6);
  case StepColor::Quiet:
    return dark ? QColor(0xa0, 0xa8, 0xb2) : QColor(0x5b, 0x64, 0x70);
  case StepColor::Reference:
    return dark ? QColor(0xd7, 0xdc, 0xe2) : QColor(0x3a, 0x41, 0x4b);
  case StepColor::Sensor:
    return dark ? QColor(0x5a, 0xa9, 0xff) : QColor(0x1f, 0x6f, 0xd1);
  case StepColor::Good:
    return dark ? QColor(0x52, 0xc4, 0x7a) : QColor(0x1d, 0x8a, 0x46);
  case StepColor::Warning:
    return dark ? QColor(0xf0, 0xb4, 0x4c) : QColor(0xb3, 0x6b, 0x00);
  case StepColor::Bad:
    return dark ? QColor(0xff, 0x7b, 0x72) : QColor(0xc4, 0x2b, 0x1c);
  }
  return {};
}

} // namespace straightedge::gui
