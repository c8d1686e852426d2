#include "core/field/verification.h"

#include "core/field/chain_stages.h"
#include "core/field/messages.h"
#include "core/field/names.h"
#include "core/numerics/statistics.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace straightedge::field {

namespace {

ErrorFigures figuresOf(const Eigen::VectorXd& percent) {
  const double mean = percent.mean();
  return {mean, numerics::rootMeanSquare(percent.array() - mean), numerics::largestMagnitude(percent)};
}

bool needsProbe(const CorrectionChain& chain, Axis axis) {
  const AxisChain& blocks = chain.axes[indexOf(axis)];
  return chain.pt100 && (blocks.offsetT || blocks.sensitivitySlope);
}

bool needsElectronics(const CorrectionChain& chain, Axis axis) {
  const AxisChain& blocks = chain.axes[indexOf(axis)];
  return blocks.electronicsT || blocks.electronicsSensitivity;
}

/// The rows that have all temperatures the chain asks for.
StepRows completeRows(const CorrectionChain& chain, const StepRows& rows) {
  const auto asked = [&](auto needs) { return std::ranges::any_of(allAxes, [&](Axis a) { return needs(chain, a); }); };
  const bool probe = asked(needsProbe);
  const bool electronics = asked(needsElectronics);
  std::vector<Eigen::Index> chosen;
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    if ((!probe || !std::isnan(rows.pt100Ohm[i])) && (!electronics || !std::isnan(rows.electronicsC[i]))) {
      chosen.push_back(i);
    }
  }
  if (static_cast<Eigen::Index>(chosen.size()) == rows.size()) {
    return rows;
  }
  StepRows kept = rows;
  kept.incomplete += static_cast<std::size_t>(rows.size()) - chosen.size();
  kept.referenceT = rows.referenceT(chosen).eval();
  kept.pt100Ohm = rows.pt100Ohm(chosen).eval();
  kept.electronicsC = rows.electronicsC(chosen).eval();
  kept.rawT = rows.rawT(chosen, Eigen::all).eval();
  return kept;
}

VerificationRow rowOf(Axis axis, VerifiedState state, const Eigen::VectorXd& errorT, const Eigen::VectorXd& referenceT,
                      double fullScaleT) {
  VerificationRow row;
  row.axis = axis;
  row.state = state;
  row.points = static_cast<std::size_t>(errorT.size());
  row.ofFullScale = figuresOf(100.0 / fullScaleT * errorT);
  std::vector<double> ofReading;
  for (Eigen::Index i = 0; i < errorT.size(); ++i) {
    if (std::abs(referenceT[i]) >= leastOfReading * fullScaleT) {
      ofReading.push_back(100.0 * errorT[i] / std::abs(referenceT[i]));
    }
  }
  if (!ofReading.empty()) {
    row.ofReading =
        figuresOf(Eigen::Map<const Eigen::VectorXd>(ofReading.data(), static_cast<Eigen::Index>(ofReading.size())));
  }
  return row;
}

struct Stage {
  ChainStage stage;
  VerifiedState state;
  bool on;
};

std::vector<Stage> stagesOf(const CorrectionChain& chain, Axis axis) {
  const AxisChain& blocks = chain.axes[indexOf(axis)];
  return {{ChainStage::Raw, VerifiedState::Uncalibrated, true},
          {ChainStage::Nonlinearity, VerifiedState::Nonlinearity, !blocks.nonlinearity.empty()},
          {ChainStage::Offset, VerifiedState::Offset, blocks.offsetT.has_value()},
          {ChainStage::Sensitivity, VerifiedState::Sensitivity, blocks.sensitivitySlope.has_value()},
          {ChainStage::Electronics, VerifiedState::Electronics, blocks.electronicsT.has_value()},
          {ChainStage::ElectronicsSensitivity, VerifiedState::ElectronicsSensitivity,
           blocks.electronicsSensitivity.has_value()},
          {ChainStage::ElectronicsSensitivity, VerifiedState::Calibrated, true}};
}

void verifyAxis(const CorrectionChain& chain, Axis axis, const StepRows& rows, FieldVerification& result) {
  AxisErrors errors;
  errors.axis = axis;
  errors.referenceT = rows.referenceT;
  errors.probeC = probeTemperatureC(chain, rows);
  errors.electronicsC = electronicsTemperatureC(chain, rows);
  for (const Stage& stage : stagesOf(chain, axis)) {
    if (!stage.on) {
      continue;
    }
    const Eigen::VectorXd errorT = axisValuesT(chain, axis, rows, stage.stage) - rows.referenceT;
    result.rows.push_back(rowOf(axis, stage.state, errorT, rows.referenceT, chain.fullScaleT));
    if (stage.state == VerifiedState::Uncalibrated) {
      errors.beforeT = errorT;
    } else if (stage.state == VerifiedState::Calibrated) {
      errors.afterT = errorT;
    }
  }
  if (chain.axisMatrix) {
    const Eigen::Matrix3d inverse = chain.axisMatrix->inverse();
    Eigen::VectorXd along = -rows.referenceT;
    for (const Axis other : allAxes) {
      along += inverse(static_cast<Eigen::Index>(indexOf(axis)), static_cast<Eigen::Index>(indexOf(other))) *
               axisValuesT(chain, other, rows, ChainStage::ElectronicsSensitivity);
    }
    result.rows.push_back(rowOf(axis, VerifiedState::AxisMatrix, along, rows.referenceT, chain.fullScaleT));
  }
  result.errors.push_back(std::move(errors));
}

} // namespace

FieldVerification verifyChain(const CorrectionChain& chain, const CampaignParts& parts) {
  FieldVerification result;
  for (const Axis axis : allAxes) {
    const StepRows rows = completeRows(chain, parts.of(CampaignStep::Verification, axis));
    result.unlocked += rows.unlocked;
    result.incomplete += rows.incomplete;
    result.points += static_cast<std::size_t>(rows.size());
    if (!rows.empty()) {
      verifyAxis(chain, axis, rows, result);
    }
  }
  return result;
}

Result<LimitReport> verifyField(const CorrectionChain& chain, const Campaign& campaign, double limitPercent,
                                PercentOf of) {
  const CampaignParts parts(campaign);
  LimitReport report;
  report.of = of;
  report.limitPercent = limitPercent;
  report.verification = verifyChain(chain, parts);
  if (report.verification.points == 0) {
    const std::size_t recorded = parts.recorded(CampaignStep::Verification);
    return campaignFault(campaign.name, 0,
                         recorded == 0
                             ? "the campaign has no rows of the step verification"
                             : "none of the " + counted(recorded, "row") + " of the step verification can be used (" +
                                   std::to_string(report.verification.unlocked) + " not locked, " +
                                   std::to_string(report.verification.incomplete) + " incomplete)",
                         "record known fields at various temperatures in this step");
  }
  bool any = false;
  for (const VerificationRow& row : report.verification.rows) {
    if (of == PercentOf::Reading && !row.ofReading) {
      continue;
    }
    const double peak = of == PercentOf::FullScale ? row.ofFullScale.peak : row.ofReading->peak;
    if (row.state == VerifiedState::Uncalibrated) {
      report.peakBeforePercent = std::max(report.peakBeforePercent, peak);
    } else if ((row.state == VerifiedState::Calibrated || row.state == VerifiedState::AxisMatrix) &&
               (!any || peak > report.peakPercent)) {
      report.peakPercent = peak;
      report.worstAxis = row.axis;
      any = true;
    }
  }
  if (!any) {
    return campaignFault(campaign.name, 0,
                         "no field of the step verification reaches " + teslaText(leastOfReading * chain.fullScaleT) +
                             ", so that an error in percent of reading says nothing",
                         "verify in percent of full scale, or in larger fields");
  }
  report.met = report.peakPercent <= limitPercent;
  return report;
}

} // namespace straightedge::field
