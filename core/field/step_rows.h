// The rows of a campaign sorted by step and axis, as columns that the blocks compute with.
#pragma once

#include "core/field/campaign.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace straightedge::field {

/// The rows of one step (and axis, where the step has one) that count, in the campaign's order. Columns of equal
/// length; a cell that was not recorded is NaN.
struct StepRows {
  CampaignStep step = CampaignStep::Nonlinearity;
  std::optional<Axis> axis;
  Eigen::VectorXd referenceT, chamberC, pt100Ohm, electronicsC, timeS;
  Eigen::Matrix<double, Eigen::Dynamic, 3> rawT;
  std::vector<Orientation> orientation; ///< of step orientation, else empty
  std::vector<std::int64_t> line;       ///< in the file; 0 where there is none
  /// First row of every run, in order: rows of one field, whose reference stays within 10 mT of the row before and
  /// that no row of another step or axis interrupts. Steps without a reference are one run.
  std::vector<Eigen::Index> runBegin;
  // Left out
  std::size_t recorded = 0;   ///< rows of this step and axis in the campaign
  std::size_t unlocked = 0;   ///< reference not locked, in steps that need it
  std::size_t incomplete = 0; ///< a value that the step needs is missing

  Eigen::Index size() const { return rawT.rows(); }
  bool empty() const { return size() == 0; }
  Eigen::Index runEnd(std::size_t run) const { return run + 1 < runBegin.size() ? runBegin[run + 1] : size(); }
};

/// Within this of the row before, the reference still shows the same field.
inline constexpr double plateauToleranceT = 0.010;

/// What the rows of a step must hold beside the raw readings.
struct StepNeeds {
  bool axis = false, orientation = false, reference = false, chamber = false, pt100 = false, electronics = false;
};
StepNeeds needsOf(CampaignStep step);

/// A campaign in parts. Immutable; any thread.
class CampaignParts {
public:
  /// One pass over the rows. Rows that are not locked are left out of steps that need the reference; the others
  /// have no reference to lock (a zero-field chamber). Counted per part.
  explicit CampaignParts(const Campaign& campaign);

  const StepRows& of(CampaignStep step, Axis axis) const; ///< of a step with an axis
  const StepRows& of(CampaignStep step) const;            ///< of a step without
  std::size_t recorded(CampaignStep step) const;          ///< rows of the step, all axes, left out or not

private:
  std::array<std::array<StepRows, 3>, 8> m_parts;
};

} // namespace straightedge::field
