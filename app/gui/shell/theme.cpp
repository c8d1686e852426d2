#include "app/gui/shell/theme.h"

#include <QApplication>
#include <QGuiApplication>
#include <QStyle>
#include <QStyleFactory>
#include <QToolTip>

namespace straightedge::gui {

namespace {

struct Colors {
  QColor window, base, alternate, text, muted, button, border, accent, onAccent, link, tipBase;
};

QPalette paletteOf(const Colors& c) {
  QPalette palette;
  palette.setColor(QPalette::Window, c.window);
  palette.setColor(QPalette::WindowText, c.text);
  palette.setColor(QPalette::Base, c.base);
  palette.setColor(QPalette::AlternateBase, c.alternate);
  palette.setColor(QPalette::Text, c.text);
  palette.setColor(QPalette::PlaceholderText, c.muted);
  palette.setColor(QPalette::Button, c.button);
  palette.setColor(QPalette::ButtonText, c.text);
  palette.setColor(QPalette::BrightText, Qt::white);
  palette.setColor(QPalette::Highlight, c.accent);
  palette.setColor(QPalette::HighlightedText, c.onAccent);
  palette.setColor(QPalette::Link, c.link);
  palette.setColor(QPalette::LinkVisited, c.link);
  palette.setColor(QPalette::ToolTipBase, c.tipBase);
  palette.setColor(QPalette::ToolTipText, c.text);
  palette.setColor(QPalette::Light, c.base.lighter(108));
  palette.setColor(QPalette::Midlight, c.border.lighter(108));
  palette.setColor(QPalette::Mid, c.border);
  palette.setColor(QPalette::Dark, c.border.darker(125));
  palette.setColor(QPalette::Shadow, QColor(0, 0, 0, 90));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText}) {
    palette.setColor(QPalette::Disabled, role, c.muted);
  }
  palette.setColor(QPalette::Disabled, QPalette::Highlight, c.border);
  return palette;
}

bool desktopIsDark() {
  // What the desktop hands out before any palette of ours is set.
  static const bool dark = QGuiApplication::palette().color(QPalette::Window).lightness() < 128;
  return dark;
}

/// Fusion frames check boxes darker than the window, which nobody sees on a dark one.
QString darkCheckBoxes(const QPalette& palette) {
  const auto rule = [](const QString& state, const QString& look) {
    return QStringLiteral("QCheckBox::indicator%1, QAbstractItemView::indicator%1 { %2 }").arg(state, look);
  };
  const QString frame = palette.color(QPalette::PlaceholderText).name();
  const QString accent = palette.color(QPalette::Highlight).name();
  const QString faint = palette.color(QPalette::Mid).name();
  return rule({}, QStringLiteral("width: 13px; height: 13px; border: 1px solid %1; border-radius: 3px; background: %2;")
                      .arg(frame, palette.color(QPalette::Base).name())) +
         rule(QStringLiteral(":checked"),
              QStringLiteral("background: %1; border-color: %1; image: url(:/theme/check.svg);").arg(accent)) +
         rule(QStringLiteral(":disabled"), QStringLiteral("border-color: %1;").arg(faint)) +
         rule(QStringLiteral(":checked:disabled"), QStringLiteral("background: %1;").arg(faint)) +
         QStringLiteral("QCheckBox::indicator:focus { border-color: %1; }").arg(palette.color(QPalette::Text).name());
}

} // namespace

QPalette lightPalette() {
  return paletteOf({.window = QColor(0xf3, 0xf4, 0xf7),
                    .base = QColor(0xff, 0xff, 0xff),
                    .alternate = QColor(0xf7, 0xf8, 0xfa),
                    .text = QColor(0x1b, 0x22, 0x2c),
                    .muted = QColor(0x6b, 0x75, 0x83),
                    .button = QColor(0xfa, 0xfb, 0xfc),
                    .border = QColor(0xd2, 0xd7, 0xde),
                    .accent = QColor(0x1f, 0x62, 0xb8),
                    .onAccent = QColor(0xff, 0xff, 0xff),
                    .link = QColor(0x1a, 0x5a, 0xad),
                    .tipBase = QColor(0xff, 0xff, 0xff)});
}

QPalette darkPalette() {
  return paletteOf({.window = QColor(0x20, 0x24, 0x2b),
                    .base = QColor(0x17, 0x1a, 0x20),
                    .alternate = QColor(0x1d, 0x21, 0x28),
                    .text = QColor(0xe3, 0xe7, 0xed),
                    .muted = QColor(0x93, 0x9d, 0xab),
                    .button = QColor(0x2b, 0x31, 0x3a),
                    .border = QColor(0x3c, 0x44, 0x50),
                    .accent = QColor(0x3d, 0x84, 0xdf),
                    .onAccent = QColor(0xff, 0xff, 0xff),
                    .link = QColor(0x7a, 0xb4, 0xff),
                    .tipBase = QColor(0x2b, 0x31, 0x3a)});
}

QString themeName(ThemeChoice choice) {
  switch (choice) {
  case ThemeChoice::Light:
    return QStringLiteral("light");
  case ThemeChoice::Dark:
    return QStringLiteral("dark");
  case ThemeChoice::System:
    break;
  }
  return QStringLiteral("system");
}

ThemeChoice themeFromName(const QString& name) {
  if (name == "light") {
    return ThemeChoice::Light;
  }
  return name == "dark" ? ThemeChoice::Dark : ThemeChoice::System;
}

void applyTheme(QApplication& application, ThemeChoice choice) {
  const bool systemDark = desktopIsDark();
  const bool dark = choice == ThemeChoice::Dark || (choice == ThemeChoice::System && systemDark);
  if (application.style()->objectName() != "fusion") {
    QApplication::setStyle(QStyleFactory::create("Fusion"));
  }
  const QPalette palette = dark ? darkPalette() : lightPalette();
  QApplication::setPalette(palette);
  QToolTip::setPalette(palette);
  const QString border = palette.color(QPalette::Mid).name();
  application.setStyleSheet(QStringLiteral("QToolTip { border: 1px solid %1; padding: 3px 5px; }"
                                           "QStatusBar::item { border: none; }"
                                           "QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }"
                                           "QMenu::separator { height: 1px; background: %1; margin: 4px 8px; }")
                                .arg(border) +
                            (dark ? darkCheckBoxes(palette) : QString()));
}

} // namespace straightedge::gui
