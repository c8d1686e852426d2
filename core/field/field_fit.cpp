#include "core/field/field_fit.h"

#include "core/field/block_costs.h"
#include "core/field/block_names.h"
#include "core/field/messages.h"
#include "core/field/names.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace straightedge::field {

namespace {

/// Goes through the blocks in the chain's order, filling chain, reports and warnings.
class StepwiseFit {
public:
  StepwiseFit(const std::string& name, const FieldFitOptions& options, FieldRun& run)
      : m_name(name), m_options(options), m_run(run), m_chain(run.result.chain) {}

  Result<void> fitNonlinearities();
  void fitProbe();
  void fitOffsets();
  void fitSensitivities();
  void fitElectronics();
  void fitElectronicsSensitivities();
  void fitMatrix();
  /// The probe's temperature alone corrects nothing.
  bool anyBlockOn() const {
    return std::ranges::any_of(m_run.result.blocks,
                               [](const BlockSummary& summary) { return summary.block != Block::ProbeTemperature; });
  }
  const std::string& firstReason() const { return m_firstReason; }

private:
  AxisChain& chainOf(Axis axis) { return m_chain.axes[indexOf(axis)]; }
  void switchOff(Block block, const std::optional<Axis>& axis, const std::string& reason) {
    m_firstReason = m_firstReason.empty() ? reason : m_firstReason;
    m_run.result.warnings.push_back(switchedOff(block, axis, reason));
  }
  void summarise(Block block, const std::optional<Axis>& axis, const BlockReport& report);
  bool isMissing(Block block);
  bool lacksProbe(Block block);
  /// The report, or the block off with the fit's own words.
  template <typename Report>
  bool keep(Block block, const std::optional<Axis>& axis, Result<Report> report, std::optional<Report>& into);

  const std::string& m_name;
  const FieldFitOptions& m_options;
  FieldRun& m_run;
  CorrectionChain& m_chain;
  std::string m_firstReason;
};

void StepwiseFit::summarise(Block block, const std::optional<Axis>& axis, const BlockReport& report) {
  const BlockRows& rows = report.rows;
  m_run.result.blocks.push_back({block, axis, report.how, rows.used,
                                 rows.unlocked + rows.unsettled + rows.surplus + rows.incomplete,
                                 report.residuals.coefficients, report.residuals.sigma, report.residuals.largest});
}

bool StepwiseFit::isMissing(Block block) {
  const CampaignStep step = stepOf(block);
  if (m_run.parts.recorded(step) > 0) {
    return false;
  }
  switchOff(block, std::nullopt, "the campaign has no rows of the step " + std::string(stepName(step)));
  return true;
}

bool StepwiseFit::lacksProbe(Block block) {
  if (m_chain.pt100) {
    return false;
  }
  switchOff(block, std::nullopt, "it needs the probe's temperature, whose block is off");
  return true;
}

template <typename Report>
bool StepwiseFit::keep(Block block, const std::optional<Axis>& axis, Result<Report> report,
                       std::optional<Report>& into) {
  if (!report) {
    const Error& error = report.error();
    const bool lineKnown = error.where.starts_with(m_name + ":");
    switchOff(block, axis, error.what + (lineKnown ? " (line " + error.where.substr(m_name.size() + 1) + ")" : ""));
    return false;
  }
  summarise(block, axis, report->block);
  into = *std::move(report);
  return true;
}

Result<void> StepwiseFit::fitNonlinearities() {
  if (isMissing(Block::Nonlinearity)) {
    return {};
  }
  for (const Axis axis : allAxes) {
    const StepRows& rows = m_run.parts.of(CampaignStep::Nonlinearity, axis);
    if (rows.recorded == 0) {
      switchOff(Block::Nonlinearity, axis, "the step nonlinearity has no rows of this axis");
      continue;
    }
    auto report =
        fitNonlinearity(findPlateaus(rows, m_options.fullScaleT), {m_options.order, m_options.fullScaleT}, m_name);
    if (!report) {
      return std::unexpected(std::move(report.error()));
    }
    chainOf(axis).nonlinearity = report->coefficients;
    m_run.result.orderExplanation[indexOf(axis)] = report->explanation;
    for (const OrderResult& order : report->orders) {
      const auto finite = [](double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; };
      m_run.result.orders.push_back(
          {axis, order.order, order.maxErrorPercent, finite(order.crossMaxPercent), finite(order.crossRmsPercent)});
    }
    for (const RejectedPlateau& plateau : report->plateaus.rejected) {
      m_run.result.warnings.push_back(
          {Block::Nonlinearity, "Axis " + std::string(axisName(axis)) + ": the plateau at " +
                                    teslaText(plateau.referenceT) +
                                    (plateau.line > 0 ? " (line " + std::to_string(plateau.line) + ")" : "") +
                                    " is left out: " + plateau.reason + "."});
    }
    summarise(Block::Nonlinearity, axis, report->block);
    m_run.reports.nonlinearity[indexOf(axis)] = *std::move(report);
  }
  return {};
}

void StepwiseFit::fitProbe() {
  if (isMissing(Block::ProbeTemperature)) {
    return;
  }
  auto& report = m_run.reports.probeTemperature;
  if (keep(Block::ProbeTemperature, std::nullopt,
           fitProbeTemperature(m_run.parts.of(CampaignStep::ProbeTemperature), m_options.referenceTemperatureC, m_name),
           report)) {
    m_chain.pt100 = report->line;
    m_run.result.probe = ProbeQuality{report->standardUncertaintyC, report->hysteresisC, report->lagS, report->lagText};
  }
}

void StepwiseFit::fitOffsets() {
  if (isMissing(Block::Offset) || lacksProbe(Block::Offset)) {
    return;
  }
  for (const Axis axis : allAxes) {
    auto& report = m_run.reports.offset[indexOf(axis)];
    if (keep(Block::Offset, axis, fitTemperatureOffset(m_run.parts.of(CampaignStep::Offset), m_chain, axis, m_name),
             report)) {
      chainOf(axis).offsetT = report->offsetT;
    }
  }
}

void StepwiseFit::fitSensitivities() {
  if (isMissing(Block::Sensitivity) || lacksProbe(Block::Sensitivity)) {
    return;
  }
  for (const Axis axis : allAxes) {
    auto& report = m_run.reports.sensitivity[indexOf(axis)];
    if (keep(Block::Sensitivity, axis,
             fitSensitivity(m_run.parts.of(CampaignStep::Sensitivity, axis), m_chain, axis, m_name), report)) {
      chainOf(axis).sensitivitySlope = report->slope;
      chainOf(axis).sensitivityIntercept = report->intercept;
      if (!report->note.empty()) {
        m_run.result.warnings.push_back({Block::Sensitivity, report->note});
      }
    }
  }
}

void StepwiseFit::fitElectronics() {
  if (isMissing(Block::Electronics)) {
    return;
  }
  for (const Axis axis : allAxes) {
    auto& report = m_run.reports.electronics[indexOf(axis)];
    if (keep(Block::Electronics, axis,
             fitElectronicsOffset(m_run.parts.of(CampaignStep::Electronics), m_chain, axis, m_name), report)) {
      chainOf(axis).electronicsT = report->offsetT;
    }
  }
}

void StepwiseFit::fitElectronicsSensitivities() {
  if (isMissing(Block::ElectronicsSensitivity)) {
    return;
  }
  for (const Axis axis : allAxes) {
    auto& report = m_run.reports.electronicsSensitivity[indexOf(axis)];
    if (keep(Block::ElectronicsSensitivity, axis,
             fitElectronicsSensitivity(m_run.parts.of(CampaignStep::ElectronicsSensitivity, axis), m_chain, axis,
                                       m_name),
             report)) {
      chainOf(axis).electronicsSensitivity = report->coefficients;
    }
  }
}

void StepwiseFit::fitMatrix() {
  if (isMissing(Block::AxisMatrix)) {
    return;
  }
  auto& report = m_run.reports.axisMatrix;
  if (keep(Block::AxisMatrix, std::nullopt, fitAxisMatrix(m_run.parts.of(CampaignStep::Orientation), m_chain, m_name),
           report)) {
    m_chain.axisMatrix = report->matrix;
    for (const std::string& note : report->notes) {
      m_run.result.warnings.push_back({Block::AxisMatrix, note});
    }
  }
}

/// A full scale that the data exceed is a slip: every percentage would be of the wrong thing.
void checkFullScale(const FieldRun& run, std::vector<FieldWarning>& warnings) {
  double largestT = 0.0;
  for (const auto& report : run.reports.nonlinearity) {
    if (report) {
      largestT = std::max(largestT, report->plateaus.referenceT().cwiseAbs().maxCoeff());
    }
  }
  const double fullScaleT = run.result.chain.fullScaleT;
  constexpr double beyond = 1.05;
  constexpr double farBelow = 0.5;
  if (largestT > beyond * fullScaleT || (largestT > 0.0 && largestT < farBelow * fullScaleT)) {
    warnings.push_back({Block::Nonlinearity, "The plateaus reach " + teslaText(largestT) +
                                                 " while percentages are of a full scale of " + teslaText(fullScaleT) +
                                                 ": give --full-scale."});
  }
}

/// All blocks together from where the fit step by step ended, which stays in the run beside the result.
Result<void> refineJointly(FieldRun& run, const std::string& name) {
  auto report = fitJointly(run.parts, run.result.chain, {}, name);
  if (!report) {
    return std::unexpected(std::move(report.error()));
  }
  const CorrectionChain stepwise = std::exchange(run.result.chain, report->chain);
  run.result.method = FitMethod::Joint;
  run.result.jointHow = report->how;
  if (!report->converged()) {
    run.result.warnings.push_back({Block::Nonlinearity, "The joint fit stopped before it had converged: compare its "
                                                        "verification with that of the fit step by step."});
  }
  run.joint.emplace(FieldRun::Joint{*std::move(report), stepwise, verifyChain(stepwise, run.parts)});
  run.result.stepwiseVerification = run.joint->stepwiseVerification.rows;
  return {};
}

} // namespace

Result<FieldRun> calibrateField(const Campaign& campaign, const FieldFitOptions& options,
                                const Traceability& traceability) {
  FieldRun run{CampaignParts(campaign), {}, {}, {}, {}};
  run.result.software = "straightedge " STRAIGHTEDGE_VERSION;
  run.result.source = {campaign.name, campaign.sha256, static_cast<long long>(campaign.rows.size())};
  run.result.traceability = traceability;
  run.result.order = options.order;
  run.result.chain.fullScaleT = options.fullScaleT;
  run.result.chain.referenceTemperatureC = options.referenceTemperatureC;

  StepwiseFit fit(campaign.name, options, run);
  if (auto done = fit.fitNonlinearities(); !done) {
    return std::unexpected(std::move(done.error()));
  }
  fit.fitProbe();
  fit.fitOffsets();
  fit.fitSensitivities();
  fit.fitElectronics();
  fit.fitElectronicsSensitivities();
  fit.fitMatrix();
  if (!fit.anyBlockOn()) {
    return campaignFault(campaign.name, 0, "no step of the campaign can be used: " + fit.firstReason(),
                         "record at least the step nonlinearity");
  }
  if (options.method == FitMethod::Joint) {
    if (auto done = refineJointly(run, campaign.name); !done) {
      return std::unexpected(std::move(done.error()));
    }
  }
  checkFullScale(run, run.result.warnings);
  run.verification = verifyChain(run.result.chain, run.parts);
  run.result.verification = run.verification.rows;
  return run;
}

} // namespace straightedge::field
