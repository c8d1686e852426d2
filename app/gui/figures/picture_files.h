// Plots as the bytes of picture files.
#pragma once

#include "app/gui/plots/plot_view.h"

#include <QByteArray>
#include <QSize>
#include <QString>

namespace straightedge::gui {

enum class PictureFormat : std::uint8_t { Png, Svg, Pdf };

QString suffixOf(PictureFormat format); ///< "png", "svg", "pdf"

/// Size of exported plots in logical pixels; PNG has `scale` times as many. Any thread.
inline constexpr QSize exportedPlotSize{960, 540};
QByteArray plotAsPng(const PlotSpec& spec, QSize size = exportedPlotSize, double scale = 2.0,
                     PlotTheme theme = PlotTheme::Light);
QByteArray plotAsSvg(const PlotSpec& spec, QSize size = exportedPlotSize, PlotTheme theme = PlotTheme::Light);
QByteArray plotAsPdf(const PlotSpec& spec, QSize size = exportedPlotSize, PlotTheme theme = PlotTheme::Light);
QByteArray plotAs(PictureFormat format, const PlotSpec& spec);

} // namespace straightedge::gui
