// The program's icons: black line drawings in SVG, drawn in the colour of the text around them, sharp at any size.
#pragma once

#include <QIcon>
#include <QPalette>
#include <QString>

class QPainter;
class QRectF;

namespace straightedge::gui {

/// `name` is a file stem in resources/icons. The icon follows the program's palette when the theme changes.
QIcon lineIcon(const QString& name);

/// The drawing itself, in one colour.
void paintLineIcon(QPainter& painter, const QRectF& area, const QString& name, const QColor& color);

} // namespace straightedge::gui
