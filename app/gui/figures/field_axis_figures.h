// Directions of the probe's axes against the package as plots (Electronics 2020, 9, 151, section 7).
#pragma once

#include "app/gui/plots/plot_spec.h"

#include <Eigen/Core>

namespace straightedge::gui {

/// Angle of every probe axis out of its package axis, towards the other two, in degrees. `matrix` is S of the chain.
PlotSpec axisTiltsFigure(const Eigen::Matrix3d& matrix);

/// Angles between two probe axes (x and y, x and z, y and z) and between a probe axis and its package axis, degrees.
Eigen::Vector3d anglesBetweenAxesDeg(const Eigen::Matrix3d& matrix);
Eigen::Vector3d axisTiltsDeg(const Eigen::Matrix3d& matrix);

} // namespace straightedge::gui
