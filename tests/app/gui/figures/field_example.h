// The campaign of tests/data/field, calibrated: what figures and reports of field calibrations are tested with.
#pragma once

#include "app/gui/figures/field_figures.h"
#include "core/field/campaign_csv.h"
#include "core/field/uncertainty.h"
#include "tests/app/gui/figures/example_results.h"

#include <memory>
#include <string>

namespace straightedge::gui::testing {

inline std::string fieldExampleFile() { return STRAIGHTEDGE_TEST_DATA "/field/campaign.csv"; }

inline std::shared_ptr<FieldResults> makeFieldResults(const field::Campaign& campaign,
                                                      const field::FieldFitOptions& options = {}) {
  Traceability trace;
  trace.deviceModel = "MFC <3>";
  trace.deviceSerial = "0007";
  auto run = valueOf(field::calibrateField(campaign, options, trace));
  run.result.created = "2026-01-02T03:04:05Z";
  run.result.uncertainty = field::uncertaintyOf(run).value_or(field::UncertaintySummary{});
  auto results = std::make_shared<FieldResults>();
  results->calibration = run.result;
  results->campaign = std::make_shared<const field::Campaign>(campaign);
  results->run = std::make_shared<const field::FieldRun>(std::move(run));
  return results;
}

inline field::Campaign exampleCampaign() { return valueOf(field::readCampaignCsv(fieldExampleFile())); }

/// Everything, made once.
inline std::shared_ptr<const FieldResults> fieldExample() {
  static const std::shared_ptr<const FieldResults> example = [] {
    const field::Campaign campaign = exampleCampaign();
    auto results = makeFieldResults(campaign);
    results->comparison =
        std::make_shared<const field::StorageComparison>(valueOf(field::compareStorage(*results->run)));
    results->verification = valueOf(field::verifyField(results->calibration.chain, campaign, 0.05));
    return results;
  }();
  return example;
}

} // namespace straightedge::gui::testing
