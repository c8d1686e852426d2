// Directions of a field calibration in three dimensions: the probe's axes, and the orientations that were measured.
#pragma once

#include "app/gui/plots/scene_spec.h"
#include "core/field/axis_matrix.h"
#include "core/field/campaign.h"

#include <Eigen/Core>

#include <vector>

namespace straightedge::gui {

/// Rows of the step orientation that count, direction by direction, all six: locked, and switched on (an empty
/// `enabled` means all are).
std::vector<field::OrientationCoverage> orientationsCovered(const field::Campaign& campaign,
                                                            const std::vector<bool>& enabled = {});

/// The six directions of the package on a sphere: which of them pointed along the field, with how many rows and what
/// fields. Empty where none did.
SphereSpec orientationSphere(const std::vector<field::OrientationCoverage>& covered);

/// The probe's axes as arrows against those of the package, `matrix` being S of the chain: tilts in degrees beside
/// them, the angles between them below the title. Tilts of a degree cannot be seen, so they are drawn larger by a
/// factor that is stated: 1, 2 or 5 · 10ⁿ, such that the largest tilt is drawn as 10° to 25°.
DirectionsSpec axisDirections(const Eigen::Matrix3d& matrix);

} // namespace straightedge::gui
