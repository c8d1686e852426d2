// Residual of a field calibration over field and temperature, for SurfaceView.
#pragma once

#include "app/gui/plots/surface_spec.h"
#include "core/field/verification.h"

#include <cstdint>

namespace straightedge::gui {

enum class CorrectionState : std::uint8_t { Before, After };

/// Error of one axis in percent of full scale, as heights over reference field and probe temperature. The readings are
/// not on a grid: fields within 10 mT of their neighbours count as one, temperatures within a twentieth of their span
/// too (of a sweep without gaps, eight equal bands), and a height is the mean of the readings in its cell; a cell
/// without readings is a hole. Empty where the readings cover fewer than two fields or temperatures.
SurfaceSpec residualSurface(const field::AxisErrors& errors, double fullScaleT, double referenceTemperatureC,
                            CorrectionState state);

} // namespace straightedge::gui
