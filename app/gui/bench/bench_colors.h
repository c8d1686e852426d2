// Colours of what the bench's widgets draw themselves, for light and dark palettes.
#pragma once

#include <QColor>
#include <QPalette>

namespace straightedge::gui {

inline bool isDark(const QPalette& palette) { return palette.color(QPalette::Window).lightness() < 128; }

inline QColor quietColor(const QPalette& palette) {
  return isDark(palette) ? QColor(0xa0, 0xa8, 0xb2) : QColor(0x5b, 0x64, 0x70);
}
inline QColor warningColor(const QPalette& palette) {
  return isDark(palette) ? QColor(0xf0, 0xb4, 0x4c) : QColor(0x8f, 0x55, 0x00);
}
inline QColor faultColor(const QPalette& palette) {
  return isDark(palette) ? QColor(0xff, 0x7b, 0x72) : QColor(0xc4, 0x2b, 0x1c);
}

} // namespace straightedge::gui
