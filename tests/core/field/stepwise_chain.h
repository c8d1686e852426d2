// The chain of a campaign fitted block by block, as far as its steps go: what the joint fit starts from.
#pragma once

#include "core/field/axis_matrix.h"
#include "core/field/chain_stages.h"
#include "core/field/names.h"
#include "core/field/nonlinearity.h"
#include "core/field/probe_temperature.h"
#include "core/field/sensitivity.h"
#include "core/field/zero_field_line.h"

#include <array>

namespace straightedge::testing {

inline field::CorrectionChain stepwiseChain(const field::CampaignParts& parts, int order = 5) {
  using namespace field;
  const std::string name = "campaign";
  CorrectionChain chain;
  if (const auto pt100 = fitProbeTemperature(parts.of(CampaignStep::ProbeTemperature), 24.0, name)) {
    chain.pt100 = pt100->line;
  }
  for (const Axis axis : allAxes) {
    AxisChain& blocks = chain.axes[indexOf(axis)];
    blocks.nonlinearity =
        fitNonlinearity(findPlateaus(parts.of(CampaignStep::Nonlinearity, axis), 2.0), {order, 2.0}, name)
            ->coefficients;
    if (const auto offset = fitTemperatureOffset(parts.of(CampaignStep::Offset), chain, axis, name)) {
      blocks.offsetT = offset->offsetT;
    }
    if (const auto sensitivity = fitSensitivity(parts.of(CampaignStep::Sensitivity, axis), chain, axis, name)) {
      blocks.sensitivitySlope = sensitivity->slope;
      blocks.sensitivityIntercept = sensitivity->intercept;
    }
    if (const auto offset = fitElectronicsOffset(parts.of(CampaignStep::Electronics), chain, axis, name)) {
      blocks.electronicsT = offset->offsetT;
    }
    if (const auto sensitivity =
            fitElectronicsSensitivity(parts.of(CampaignStep::ElectronicsSensitivity, axis), chain, axis, name)) {
      blocks.electronicsSensitivity = sensitivity->coefficients;
    }
  }
  if (const auto matrix = fitAxisMatrix(parts.of(CampaignStep::Orientation), chain, name)) {
    chain.axisMatrix = matrix->matrix;
  }
  return chain;
}

/// Largest |V5 − reference| over the verification, in percent of full scale.
inline std::array<double, 3> verificationPeaks(const field::CampaignParts& parts, const field::CorrectionChain& chain) {
  using namespace field;
  std::array<double, 3> peaks{};
  for (const Axis axis : allAxes) {
    const StepRows& rows = parts.of(CampaignStep::Verification, axis);
    peaks[indexOf(axis)] =
        (axisValuesT(chain, axis, rows, ChainStage::ElectronicsSensitivity) - rows.referenceT).cwiseAbs().maxCoeff() /
        chain.fullScaleT * 100.0;
  }
  return peaks;
}

} // namespace straightedge::testing
