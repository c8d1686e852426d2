#include "app/gui/plots/theme.h"

#include <QFontInfo>
#include <QGuiApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace straightedge::gui {
namespace {

constexpr std::size_t roleCount = 10;
using RoleColors = std::array<QRgb, roleCount>;

// In the order of SeriesColor: Reference, First … Sixth, Muted, Good, Bad.
constexpr RoleColors lightRoles = {0xff33383f, 0xff0068a8, 0xffd05000, 0xff008a64, 0xffa8478c,
                                   0xff9a6e00, 0xff2a8fc4, 0xff868c96, 0xff1a7f47, 0xffc4162a};
constexpr RoleColors darkRoles = {0xffe6e8eb, 0xff4ea6ea, 0xfff5884a, 0xff2fc295, 0xffd98bc0,
                                  0xffe3b341, 0xff86cdf5, 0xff8d95a0, 0xff53c47f, 0xffff6b70};

double luminance(const QColor& color) {
  const auto linear = [](double c) { return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(static_cast<double>(color.redF())) + 0.7152 * linear(static_cast<double>(color.greenF())) +
         0.0722 * linear(static_cast<double>(color.blueF()));
}

} // namespace

PlotColors PlotColors::of(PlotTheme theme) {
  if (theme == PlotTheme::Dark) {
    return {.background = QColor(0x1e, 0x21, 0x26),
            .text = QColor(0xe6, 0xe8, 0xeb),
            .softText = QColor(0xb4, 0xba, 0xc3),
            .axis = QColor(0x7d, 0x85, 0x91),
            .grid = QColor(0x35, 0x3a, 0x42),
            .minorGrid = QColor(0x2a, 0x2e, 0x35),
            .card = QColor(0x2b, 0x30, 0x38, 240),
            .cardBorder = QColor(0x59, 0x61, 0x6d),
            .selection = QColor(0x4e, 0xa6, 0xea, 60)};
  }
  return {.background = QColor(0xff, 0xff, 0xff),
          .text = QColor(0x1d, 0x21, 0x27),
          .softText = QColor(0x4c, 0x54, 0x60),
          .axis = QColor(0x7b, 0x83, 0x8f),
          .grid = QColor(0xe3, 0xe6, 0xea),
          .minorGrid = QColor(0xf1, 0xf3, 0xf5),
          .card = QColor(0xff, 0xff, 0xff, 245),
          .cardBorder = QColor(0xa9, 0xb0, 0xba),
          .selection = QColor(0x00, 0x68, 0xa8, 40)};
}

QColor PlotColors::series(SeriesColor role, PlotTheme theme) {
  const auto& roles = theme == PlotTheme::Dark ? darkRoles : lightRoles;
  return QColor::fromRgb(roles.at(static_cast<std::size_t>(role)));
}

MarkerShape markerOf(SeriesColor role) {
  switch (role) {
  case SeriesColor::Second:
    return MarkerShape::Square;
  case SeriesColor::Third:
    return MarkerShape::Diamond;
  case SeriesColor::Fourth:
    return MarkerShape::Triangle;
  case SeriesColor::Fifth:
    return MarkerShape::Cross;
  case SeriesColor::Sixth:
    return MarkerShape::Plus;
  default:
    return MarkerShape::Circle;
  }
}

PlotFonts PlotFonts::standard() {
  QFont base = QGuiApplication::font();
  const int pixels = std::clamp(QFontInfo(base).pixelSize(), 12, 15);
  const auto sized = [&base](int size, QFont::Weight weight) {
    QFont font = base;
    font.setPixelSize(size);
    font.setWeight(weight);
    return font;
  };
  return {.title = sized(pixels + 1, QFont::DemiBold),
          .axisTitle = sized(pixels, QFont::Normal),
          .label = sized(pixels - 1, QFont::Normal),
          .note = sized(pixels - 1, QFont::Normal)};
}

double contrastRatio(const QColor& a, const QColor& b) {
  double bright = luminance(a);
  double dark = luminance(b);
  if (bright < dark) {
    std::swap(bright, dark);
  }
  return (bright + 0.05) / (dark + 0.05);
}

} // namespace straightedge::gui
