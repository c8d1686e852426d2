// Plots as files: PNG in any scale, SVG and PDF with real text and lines, all by the code that paints the screen.
#pragma once

#include <QImage>
#include <QRectF>
#include <QString>

#include <functional>

class QPainter;

namespace straightedge::gui {

using PaintPlot = std::function<void(QPainter&, const QRectF& area)>;

/// `size` in logical pixels; the image has size · scale pixels and says so by its device pixel ratio.
QImage paintToImage(const QSize& size, double scale, const PaintPlot& paint);

/// .png (twice the logical size), .svg, .pdf (one page of the plot's size, 96 pixels to the inch), chosen by extension.
/// Written under a temporary name and renamed, so that nothing half-written is left. False with a sentence in
/// `problem`.
bool paintToFile(const QString& file, const QSize& size, const QString& title, const PaintPlot& paint,
                 QString* problem);

} // namespace straightedge::gui
