// Probe and electronics over temperature as plots (Electronics 2020, 9, 151, Figures 7, 8 and 18).
#pragma once

#include "app/gui/plots/plot_spec.h"
#include "core/field/probe_temperature.h"
#include "core/field/zero_field_line.h"

#include <array>
#include <optional>

namespace straightedge::gui {

/// Figure 7: chamber temperature over the PT100's resistance, heating and cooling, with the line.
PlotSpec probeLoopFigure(const field::ProbeTemperatureReport& report, double referenceTemperatureC);

/// The same less the line, with twice its standard uncertainty as a band: the loop's width can be read off.
PlotSpec probeResidualFigure(const field::ProbeTemperatureReport& report, double referenceTemperatureC);

enum class ZeroFieldOver : std::uint8_t { Probe, Electronics };

/// Figures 8 and 18: what the axes show in no field over a temperature, with the lines that are taken away.
PlotSpec zeroFieldFigure(const std::array<std::optional<field::ZeroFieldReport>, 3>& reports,
                         double referenceTemperatureC, ZeroFieldOver over);

} // namespace straightedge::gui
