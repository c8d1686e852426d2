// The chain block by block over the rows of a step: what each block sees when it is fitted, and what it leaves.
#pragma once

#include "core/field/calibration.h"
#include "core/field/step_rows.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>

namespace straightedge::field {

/// The value after a block: V1 to V5 of the chain (calibration.h); Raw is before all.
enum class ChainStage : std::uint8_t { Raw, Nonlinearity, Offset, Sensitivity, Electronics, ElectronicsSensitivity };
inline constexpr std::array<ChainStage, 6> allStages = {ChainStage::Raw,         ChainStage::Nonlinearity,
                                                        ChainStage::Offset,      ChainStage::Sensitivity,
                                                        ChainStage::Electronics, ChainStage::ElectronicsSensitivity};

/// Probe temperature minus reference temperature. 0 where the PT100 was not recorded or its block is off: a probe of
/// unknown temperature counts as one at the reference temperature.
Eigen::VectorXd probeTemperatureC(const CorrectionChain& chain, const StepRows& rows);

/// Electronics temperature minus reference temperature; 0 where it was not recorded.
Eigen::VectorXd electronicsTemperatureC(const CorrectionChain& chain, const StepRows& rows);

/// The values of one axis after block `stage`, blocks that are off passed over. Tesla.
Eigen::VectorXd axisValuesT(const CorrectionChain& chain, Axis axis, const StepRows& rows, ChainStage stage);

} // namespace straightedge::field
