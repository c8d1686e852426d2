// Light and dark looks for the Fusion style: an own palette and a small style sheet; nothing is sized in device pixels.
#pragma once

#include <QPalette>
#include <QString>

#include <cstdint>

class QApplication;

namespace straightedge::gui {

enum class ThemeChoice : std::uint8_t { System, Light, Dark };

QPalette lightPalette();
QPalette darkPalette();
QString themeName(ThemeChoice choice); ///< as kept in the settings: "system", "light", "dark"
ThemeChoice themeFromName(const QString& name);

/// Sets style, palette and style sheet of the whole program. System follows the desktop's own palette.
void applyTheme(QApplication& application, ThemeChoice choice);

} // namespace straightedge::gui
