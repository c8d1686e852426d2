#include "app/gui/figures/field_render.h"

#include "core/field/campaign_csv.h"
#include "core/field/chain.h"

#include <algorithm>
#include <cmath>

namespace straightedge::gui {

namespace {

/// Steps whose blocks are off in the calibration: by choice in the window, or because they could not be used.
bool isStepUsed(const field::CorrectionChain& chain, field::CampaignStep step) {
  const auto some = [&chain](auto has) { return std::ranges::any_of(chain.axes, has); };
  using field::AxisChain;
  switch (step) {
  case field::CampaignStep::ProbeTemperature:
    return chain.pt100.has_value();
  case field::CampaignStep::Offset:
    return some([](const AxisChain& axis) { return axis.offsetT.has_value(); });
  case field::CampaignStep::Sensitivity:
    return some([](const AxisChain& axis) { return axis.sensitivitySlope.has_value(); });
  case field::CampaignStep::Electronics:
    return some([](const AxisChain& axis) { return axis.electronicsT.has_value(); });
  case field::CampaignStep::ElectronicsSensitivity:
    return some([](const AxisChain& axis) { return axis.electronicsSensitivity.has_value(); });
  case field::CampaignStep::Orientation:
    return chain.axisMatrix.has_value();
  case field::CampaignStep::Nonlinearity:
  case field::CampaignStep::Verification:
    return true;
  }
  return true;
}

field::Campaign usedRows(const field::Campaign& campaign, const field::CorrectionChain& chain) {
  field::Campaign used = campaign;
  std::erase_if(used.rows, [&chain](const field::CampaignRow& row) { return !isStepUsed(chain, row.step); });
  return used;
}

/// A campaign belongs to a calibration when it gives the same correction again, to a millionth of full scale at three
/// readings within the scale.
bool givesSameChain(const field::CorrectionChain& recomputed, const field::CorrectionChain& stated) {
  const auto one = field::AppliedChain::prepare(recomputed);
  const auto other = field::AppliedChain::prepare(stated);
  if (!one || !other) {
    return false;
  }
  constexpr double tolerance = 1e-6;
  constexpr double warmerOhm = 111.0; // some degrees above the reference temperature
  for (const double share : {-0.8, 0.1, 0.9}) {
    const double rawT = share * stated.fullScaleT;
    const field::Reading reading{warmerOhm, stated.referenceTemperatureC + 5.0, {rawT, -0.5 * rawT, 0.3 * rawT}};
    const Eigen::Vector3d differenceT = one->correct(reading) - other->correct(reading);
    if (!(differenceT.cwiseAbs().maxCoeff() <= tolerance * stated.fullScaleT)) {
      return false;
    }
  }
  return true;
}

} // namespace

Result<std::shared_ptr<FieldResults>> fieldResultsOf(field::FieldCalibration calibration,
                                                     const std::string& campaignFile) {
  auto results = std::make_shared<FieldResults>();
  results->calibration = std::move(calibration);
  if (campaignFile.empty()) {
    return results;
  }
  Result<field::Campaign> campaign = field::readCampaignCsv(campaignFile);
  if (!campaign) {
    return std::unexpected(campaign.error());
  }
  const field::FieldCalibration& stated = results->calibration;
  const field::FieldFitOptions options{stated.order, stated.method, stated.chain.fullScaleT,
                                       stated.chain.referenceTemperatureC};
  Result<field::FieldRun> run = field::calibrateField(usedRows(*campaign, stated.chain), options, stated.traceability);
  if (!run) {
    return std::unexpected(run.error());
  }
  if (!givesSameChain(run->result.chain, stated.chain)) {
    return fail(ErrorKind::Input, "the campaign is not the one that the calibration was made from",
                "give the campaign that calibration.json names under source, or leave out --campaign", campaignFile);
  }
  if (auto comparison = field::compareStorage(*run)) {
    results->comparison = std::make_shared<const field::StorageComparison>(*std::move(comparison));
  }
  results->campaign = std::make_shared<const field::Campaign>(*std::move(campaign));
  results->run = std::make_shared<const field::FieldRun>(*std::move(run));
  return results;
}

} // namespace straightedge::gui
