// Which points were taken at the same encoder angle of the shaft, whatever the turn or direction.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace straightedge::angle {

struct EncoderGroups {
  std::vector<std::size_t> ofPoint; ///< group of each point, 0 … count−1, ascending with the encoder angle
  std::size_t count = 0;
};

/// Points share a group where their encoder angles are equal, or within 0.02° and at the same time ten times nearer to
/// each other than groups are to their neighbours (a stage that returns to the same place only nearly).
/// Encoder angles in [0, 360), any order. Where more than `most` groups would result, the circle is cut into `most`
/// equal sectors instead; empty ones do not count.
EncoderGroups groupEncoderAngles(const Eigen::VectorXd& encoderDeg, std::size_t most = static_cast<std::size_t>(-1));

} // namespace straightedge::angle
