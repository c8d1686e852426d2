// The PT100's line behind a lag, on simulated campaigns with known truth and on the example that is shipped.
#include "core/field/campaign_csv.h"
#include "core/field/probe_temperature.h"
#include "devices/simulated/hall_campaign.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace straightedge::field {
namespace {

Result<ProbeTemperatureReport> reportOf(const Campaign& campaign) {
  return fitProbeTemperature(CampaignParts(campaign).of(CampaignStep::ProbeTemperature), 24.0, campaign.name);
}

/// Largest error of the line over the resistances that were swept, in °C.
double largestErrorC(const ProbeTemperatureReport& report, const devices::HallProbeSettings& truth) {
  double largest = 0.0;
  for (const double ohm : {report.ohm.minCoeff(), report.ohm.maxCoeff()}) {
    const double aboveC = (ohm - truth.pt100OhmAt0C) / truth.pt100OhmPerC - 24.0;
    largest = std::max(largest, std::abs(report.line.interceptC + report.line.slopeCPerOhm * ohm - aboveC));
  }
  return largest;
}

TEST(ProbeLag, VariedCampaignsGiveTheTrueLineWithinItsUncertainty) {
  int lags = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const devices::HallCampaignSettings settings = devices::quickHallCampaign(seed);
    const auto report = reportOf(devices::makeHallCampaign(settings));
    ASSERT_TRUE(report) << report.error().message();
    ASSERT_TRUE(report->lagS) << seed << ": " << report->lagText;
    EXPECT_NEAR(*report->lagS, settings.lagS, 0.05 * settings.lagS) << seed;
    EXPECT_LT(largestErrorC(*report, settings.probe), 2.0 * report->standardUncertaintyC) << seed;
    EXPECT_LT(report->standardUncertaintyC, 0.1) << seed;
    EXPECT_LT(std::abs(report->loopLeftC.value()), 0.05) << seed;
    ++lags;
  }
  EXPECT_EQ(lags, 60);
}

TEST(ProbeLag, FastSweepIsStillRightAndIsSaid) {
  devices::HallCampaignSettings settings;
  settings.probeTemperature.rows = 60; // two cycles of half a minute, the probe behind them by 12 s
  const auto report = reportOf(devices::makeHallCampaign(settings));
  ASSERT_TRUE(report && report->lagS);
  EXPECT_NEAR(*report->lagS, 12.0, 0.6);
  EXPECT_LT(largestErrorC(*report, settings.probe), 3.0 * report->standardUncertaintyC);
  EXPECT_GT(report->standardUncertaintyC, report->block.residuals.sigma);
  EXPECT_GT(std::abs(*report->hysteresisC), wideLoop * report->spanC);
  EXPECT_NE(report->lagText.find("sweep the chamber more slowly"), std::string::npos) << report->lagText;
}

TEST(ProbeLag, ExampleThatIsShipped) {
  const auto campaign = readCampaignCsv(STRAIGHTEDGE_EXAMPLES "/hall_probe_campaign.csv");
  ASSERT_TRUE(campaign) << campaign.error().message();
  const auto report = reportOf(*campaign);
  ASSERT_TRUE(report) << report.error().message();
  // Worked out from the file by a script of its own.
  EXPECT_NEAR(report->hysteresisC.value(), 1.921649847, 1e-8);
  EXPECT_NEAR(report->lagS.value(), 12.019, 2e-3);
  EXPECT_NEAR(report->line.slopeCPerOhm, 2.5941037, 5e-6);
  EXPECT_NEAR(report->loopLeftC.value(), 0.0014417, 1e-4);
  // What it was simulated with.
  EXPECT_NEAR(*report->lagS, 12.0, 0.2);
  EXPECT_LT(largestErrorC(*report, devices::HallProbeSettings()), 2.0 * report->standardUncertaintyC);
  EXPECT_EQ(report->lagText.find("more slowly"), std::string::npos);
}

} // namespace
} // namespace straightedge::field
