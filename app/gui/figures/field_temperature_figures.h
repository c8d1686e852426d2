// Probe and electronics over temperature as plots (Electronics 2020, 9, 151, Figures 7, 8 and 18).
#pragma once

#include "app/gui/plots/plot_spec.h"
#include "core/field/probe_temperature.h"
#include "core/field/zero_field_line.h"

#include <array>
#include <optional>

namespace straightedge::gui {

/// Figure 7: chamber temperature over the PT100's resistance, heating and cooling, with the line; where a lag was found
/// also the temperature as the probe felt it, which is what the line goes through.
PlotSpec probeLoopFigure(const field::ProbeTemperatureReport& report, double referenceTemperatureC);

/// What scatters about the line, with twice the standard uncertainty as a band: the recorded loop, or, where a lag was
/// found, what remains of it once the lag is taken away (a recorded loop many times as wide as the band says nothing of
/// the line).
PlotSpec probeResidualFigure(const field::ProbeTemperatureReport& report, double referenceTemperatureC);

enum class ZeroFieldOver : std::uint8_t { Probe, Electronics };

/// Figures 8 and 18: what the axes show in no field over a temperature, with the lines that are taken away.
PlotSpec zeroFieldFigure(const std::array<std::optional<field::ZeroFieldReport>, 3>& reports,
                         double referenceTemperatureC, ZeroFieldOver over);

} // namespace straightedge::gui
