// How far the field of a single corrected reading may be from the true one (GUM, JCGM 100:2008, sections 4.3, 5.1.2,
// 6.2 and F.2.4.5), over field and temperature.
//
// The interval is for one reading and for each component of the field by itself: B_i ± U_i holds the true B_i in 95 of
// 100 cases. A reading's error has two parts.
// - What the chain leaves on purpose: a polynomial of order 5 cannot follow the instrument to its noise. This residual
//   is known, since the campaign shows it: chain − closest fit (closest_fit.h) at that reading. It is no random
//   quantity; the chain keeps it because the coefficients have to fit into a microcontroller.
// - What is not known, normally distributed with the standard deviation u: the reading's own scatter (raw reading and
//   both temperatures), the coefficients of the closest fit, what that leaves beyond noise, and the reference.
// U is the half width that an error of residual ± u stays within with a probability of 95 %: 1.96·u where the residual
// is small, |residual| + 1.645·u where it dominates.
//
// Left out, because the chain does not show it: what blocks that are off would correct; the PT100's line, whose error
// slope, offset and nonlinearity have taken up; gradients between reference and probe; ageing.
#pragma once

#include "core/base/error.h"
#include "core/field/chain.h"
#include "core/field/joint_fit.h"
#include "core/field/reading_noise.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>

namespace straightedge::field {

struct FieldUncertaintyInputs {
  /// Standard uncertainty of the reference's scale, relative. Default: ±5 ppm, taken as rectangular (NMR teslameter
  /// PT2025 of the paper, section 5).
  double referenceRelative = 2.9e-6;
};

/// One reading. Tesla; x, y, z. Standard uncertainties but for the residual and the last.
struct ReadingUncertainty {
  Eigen::Vector3d fieldT = Eigen::Vector3d::Zero();    ///< through the chain
  Eigen::Vector3d residualT = Eigen::Vector3d::Zero(); ///< known: chain − closest fit
  Eigen::Vector3d repeatabilityT = Eigen::Vector3d::Zero();
  Eigen::Vector3d probeTemperatureT = Eigen::Vector3d::Zero();
  Eigen::Vector3d electronicsTemperatureT = Eigen::Vector3d::Zero();
  Eigen::Vector3d coefficientsT = Eigen::Vector3d::Zero();
  Eigen::Vector3d modelT = Eigen::Vector3d::Zero(); ///< what the closest fit leaves beyond noise
  Eigen::Vector3d referenceT = Eigen::Vector3d::Zero();
  Eigen::Vector3d combinedT = Eigen::Vector3d::Zero();
  Eigen::Vector3d expandedT = Eigen::Vector3d::Zero(); ///< U, 95 %
};

/// Temperatures that the campaign covers, minus the reference temperature; 0 where none was swept.
struct TemperatureRange {
  double probeLowC = 0.0, probeHighC = 0.0;
  double electronicsLowC = 0.0, electronicsHighC = 0.0;
};

/// Half width of the interval about 0 that a normal quantity of this mean and deviation lies in with 95 %.
double halfWidth95(double mean, double sigma);

/// Immutable; any thread. at() takes microseconds.
class FieldUncertainty {
public:
  /// Of `chain`, however fitted, from the campaign it was fitted to.
  /// Errors (Input): those of fitJointly() for the closest fit, and of AppliedChain::prepare().
  static Result<FieldUncertainty> of(const CampaignParts& parts, const CorrectionChain& chain,
                                     const FieldUncertaintyInputs& inputs, const std::string& name);

  /// Of another chain fitted to the same campaign with the same PT100 line: the closest fit stays.
  /// Errors: those of AppliedChain::prepare().
  Result<FieldUncertainty> forChain(const CorrectionChain& chain) const;

  ReadingUncertainty at(const Reading& reading) const;

  /// The reading that the closest fit has for a field at temperatures in °C (not minus reference).
  Reading readingFor(const Eigen::Vector3d& fieldT, double probeC, double electronicsC) const;

  const CorrectionChain& chain() const { return m_chain; }
  const JointReport& closest() const { return m_closest; }
  const ReadingNoise& noise() const { return m_noise; }
  const FieldUncertaintyInputs& inputs() const { return m_inputs; }
  const TemperatureRange& range() const { return m_range; }

private:
  FieldUncertainty(CorrectionChain chain, AppliedChain applied, JointReport closest, const ReadingNoise& noise,
                   const FieldUncertaintyInputs& inputs, const TemperatureRange& range);

  CorrectionChain m_chain;
  AppliedChain m_applied;
  JointReport m_closest;
  ReadingNoise m_noise;
  FieldUncertaintyInputs m_inputs;
  TemperatureRange m_range;
  Eigen::Matrix3d m_inverse; ///< of the closest fit's S
};

} // namespace straightedge::field
