// Residual of a field calibration over field and temperature, in three dimensions.
#pragma once

#include "app/gui/plots/scene_spec.h"
#include "core/field/verification.h"

#include <cstdint>

namespace straightedge::gui {

enum class CorrectionState : std::uint8_t { Before, After };

enum class SurfaceScale : std::uint8_t {
  Shared, ///< heights and colours reach as far as those of before and after: the two can be compared
  Own,    ///< as far as there is something to see
};

/// Error of one axis in percent of full scale, as heights over reference field and probe temperature; blue below zero,
/// red above, equally far. The readings are not on a grid: fields within 10 mT of their neighbours count as one,
/// temperatures within a twentieth of their span too (of a sweep without gaps, eight equal bands), and a height is the
/// mean of the readings in its cell; a cell without readings is a hole. Empty where the readings cover fewer than two
/// fields or temperatures.
SurfaceSpec residualSurface(const field::AxisErrors& errors, double fullScaleT, double referenceTemperatureC,
                            CorrectionState state, SurfaceScale scale = SurfaceScale::Shared);

} // namespace straightedge::gui
