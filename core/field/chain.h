// The chain of a field calibration applied: one reading at a time, or many at once.
#pragma once

#include "core/base/error.h"
#include "core/field/calibration.h"
#include "core/field/chain_coefficients.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <span>

namespace straightedge::field {

/// What the instrument shows at one moment.
struct Reading {
  double pt100Ohm = 0.0;
  double electronicsC = 0.0;
  std::array<double, 3> rawT = {0.0, 0.0, 0.0};
};

/// One axis after each of its blocks, in tesla (V1 to V5 of CorrectionChain). A block that is off changes nothing.
struct AxisStages {
  double nonlinearityT = 0.0;
  double offsetT = 0.0;
  double sensitivityT = 0.0;
  double electronicsT = 0.0;
  double electronicsSensitivityT = 0.0;
};

/// `probeC`, `electronicsC`: minus the reference temperature; 0 where a temperature is not known.
AxisStages axisStages(const AxisChain& axis, double rawT, double probeC, double electronicsC);

/// The PT100's line; 0 (the reference temperature) where there is none.
double probeAboveReference(const CorrectionChain& chain, double pt100Ohm);

/// Many readings, one span a column, all of the same length. A temperature that no block needs may be left empty.
struct ReadingColumns {
  std::span<const double> pt100Ohm;
  std::span<const double> electronicsC;
  std::array<std::span<const double>, 3> rawT;
};

/// As long as the readings; may be the readings' own memory.
struct FieldColumns {
  std::array<std::span<double>, 3> fieldT;
};

/// A chain made ready: blocks that are off have become coefficients of zero, S has been inverted once.
/// Immutable; any thread. Not a number in a reading makes the whole field of that reading not a number, except in a
/// temperature that no block needs.
class AppliedChain {
public:
  /// Errors (Input): a matrix of axes that cannot be inverted; a block over probe temperature without the PT100's line;
  /// more coefficients than mostChainCoefficients; a coefficient that is no number.
  static Result<AppliedChain> prepare(const CorrectionChain& chain);

  bool needsProbeTemperature() const { return m_needsProbe; }
  bool needsElectronicsTemperature() const { return m_needsElectronics; }

  /// The plain formula in IEEE double arithmetic without fused operations: polynomials by Horner's rule from the
  /// highest power down, the blocks in the order of CorrectionChain, the matrix's rows as (m0·x + m1·y) + m2·z.
  Eigen::Vector3d correct(const Reading& reading) const;
  /// The same, one reading after the other: the measure for the fast one.
  void correctPlainly(const ReadingColumns& readings, const FieldColumns& fields) const;
  /// Several readings at a time with the widest instructions that this processor has (AVX2 and FMA, or what every
  /// processor of its kind has). A reading's result does not depend on its neighbours. Differs from the plain formula
  /// by the rounding of fused operations: at most 1e-15 of full scale.
  void correct(const ReadingColumns& readings, const FieldColumns& fields) const;

private:
  AppliedChain() = default;
  ChainCoefficients m_coefficients;
  bool m_needsProbe = false;
  bool m_needsElectronics = false;
};

/// "AVX2 and FMA" or "baseline": what correct() of many readings uses here; for reports of speed.
const char* chainInstructions();

} // namespace straightedge::field
