// The simulated teslameter knows its truth: what it shows leads back to the field, and its campaigns look like the
// paper's.
#include "core/field/chain.h"
#include "devices/simulated/hall_campaign.h"
#include "devices/simulated/quantised.h"

#include <Eigen/QR>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace straightedge::devices {
namespace {

using field::CampaignRow;
using field::CampaignStep;

Eigen::Vector3d someField(NoiseSource& random) {
  return {1.2 * std::tanh(random.standardNormal()), 1.2 * std::tanh(random.standardNormal()),
          1.2 * std::tanh(random.standardNormal())};
}

class HallProbeTest : public testing::TestWithParam<int> {};

TEST_P(HallProbeTest, ReadingLeadsBackToTheField) {
  HallProbeSettings settings = variedHallCampaign(static_cast<std::uint64_t>(GetParam())).probe;
  NoiseSource random(5);
  for (const HallCurve curve : {HallCurve::RawOverField, HallCurve::FieldOverRaw}) {
    for (const double planar : {0.0, 2e-3}) {
      settings.curve = curve;
      settings.axes[0].planarHallPerT = planar;
      settings.axes[2].planarHallPerT = -planar;
      const HallProbe probe(settings);
      for (int i = 0; i < 100; ++i) {
        const Eigen::Vector3d field = someField(random);
        const double probeC = 24.0 + 5.0 * random.standardNormal();
        const double electronicsC = 24.0 + 5.0 * random.standardNormal();
        const Eigen::Vector3d raw = probe.idealReadingT(field, probeC, electronicsC);
        EXPECT_LT((probe.trueFieldT(raw, probeC, electronicsC) - field).norm(), 1e-14);
        EXPECT_GT((raw - field).norm(), 1e-4) << "there is something to correct";
      }
    }
  }
}

TEST_P(HallProbeTest, TheTrueChainIsTheTruth) {
  HallProbeSettings settings = variedHallCampaign(static_cast<std::uint64_t>(GetParam())).probe;
  settings.curve = HallCurve::FieldOverRaw;
  const HallProbe probe(settings);
  const auto chain = field::AppliedChain::prepare(probe.trueChain());
  ASSERT_TRUE(chain) << chain.error().message();
  NoiseSource random(6);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d field = someField(random);
    const double probeC = 24.0 + 5.0 * random.standardNormal();
    const double electronicsC = 24.0 + 5.0 * random.standardNormal();
    const Eigen::Vector3d raw = probe.idealReadingT(field, probeC, electronicsC);
    const field::Reading reading{probe.idealPt100Ohm(probeC), electronicsC, {raw.x(), raw.y(), raw.z()}};
    EXPECT_LT((chain->correct(reading) - field).norm(), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, HallProbeTest, testing::Range(1, 4));

TEST(HallProbeNoiseTest, IsAsLargeAsSaidAndOnTheInstrumentsSteps) {
  const HallProbe probe{HallProbeSettings()};
  NoiseSource noise(7);
  const Eigen::Vector3d field(0.5, -0.25, 1.0);
  const Eigen::Vector3d ideal = probe.idealReadingT(field, 30.0, 20.0);
  double squares = 0.0;
  constexpr int readings = 4000;
  for (int i = 0; i < readings; ++i) {
    const Eigen::Vector3d raw = probe.readingT(field, 30.0, 20.0, noise);
    squares += (raw - ideal).squaredNorm();
    EXPECT_NEAR(std::remainder(raw.x(), 1e-7), 0.0, 1e-14);
    EXPECT_EQ(std::remainder(probe.electronicsReadingC(20.0, noise), 0.0625), 0.0);
  }
  EXPECT_NEAR(std::sqrt(squares / (3 * readings)), 5e-6, 0.15e-6);
}

/// Largest error over an axis' plateau means, in percent of full scale; order 0: before any fit.
double maxErrorPercent(const field::Campaign& campaign, field::Axis axis, int order) {
  std::vector<double> raw;
  std::vector<double> reference;
  int count = 0;
  for (const CampaignRow& row : campaign.rows) {
    if (row.step != CampaignStep::Nonlinearity || row.axis != axis || !row.locked) {
      continue;
    }
    if (count == 0 || std::abs(row.referenceT - reference.back() / count) > 0.01) {
      if (count > 0) {
        raw.back() /= count;
        reference.back() /= count;
      }
      raw.push_back(0.0);
      reference.push_back(0.0);
      count = 0;
    }
    raw.back() += row.rawT[static_cast<std::size_t>(axis)];
    reference.back() += row.referenceT;
    ++count;
  }
  raw.back() /= count;
  reference.back() /= count;
  const Eigen::Map<const Eigen::VectorXd> x(raw.data(), static_cast<Eigen::Index>(raw.size()));
  const Eigen::Map<const Eigen::VectorXd> y(reference.data(), static_cast<Eigen::Index>(reference.size()));
  if (order == 0) {
    return 50.0 * (x - y).cwiseAbs().maxCoeff();
  }
  Eigen::MatrixXd powers(x.size(), order + 1);
  for (int k = 0; k <= order; ++k) {
    powers.col(k) = x.array().pow(k);
  }
  const Eigen::VectorXd fitted = powers * powers.householderQr().solve(y);
  return 50.0 * (fitted - y).cwiseAbs().maxCoeff();
}

TEST(QuantisedTest, HasNoNegativeZero) {
  EXPECT_FALSE(std::signbit(quantised(-4e-8, 1e-7)));
  EXPECT_EQ(quantised(-6e-8, 1e-7), -1e-7);
  EXPECT_EQ(quantised(109.24391, 1e-4), 109.2439);
}

TEST(HallCampaignTest, LooksLikeThePapers) {
  const field::Campaign campaign = makeHallCampaign(HallCampaignSettings());
  EXPECT_GT(campaign.rows.size(), 12000U);
  EXPECT_LT(campaign.rows.size(), 14500U);
  // Percent of 2 T, of the reference campaign that Straightedge's issue gives: before, orders 1 to 6.
  constexpr std::array<std::array<double, 7>, 3> expected = {{
      {2.05597, 3.16069, 3.16126, 0.18657, 0.18526, 0.01043, 0.01023},
      {2.06554, 3.1814, 3.18226, 0.15663, 0.15472, 0.01031, 0.01000},
      {1.95905, 3.00496, 3.0056, 0.22482, 0.22364, 0.01179, 0.01155},
  }};
  for (const field::Axis axis : field::allAxes) {
    for (std::size_t order = 0; order < 7; ++order) {
      const double percent = expected.at(static_cast<std::size_t>(axis)).at(order);
      EXPECT_NEAR(maxErrorPercent(campaign, axis, static_cast<int>(order)), percent, 0.05 * percent) << order;
    }
  }
}

TEST(HallCampaignTest, FollowsTheInstrumentsChainRowByRow) {
  HallCampaignSettings settings = variedHallCampaign(3);
  settings.referenceScalePpm = 0.0;
  const HallProbe probe(settings.probe);
  const field::Campaign campaign = makeHallCampaign(settings);
  std::set<CampaignStep> steps;
  double before = -1.0;
  std::int64_t line = 1;
  for (const CampaignRow& row : campaign.rows) {
    steps.insert(row.step);
    EXPECT_GT(row.timeS, before);
    before = row.timeS;
    EXPECT_EQ(row.line, ++line);
    EXPECT_EQ(row.locked, !std::isnan(row.referenceT)) << row.line;
    if (row.locked) {
      EXPECT_GE(std::abs(row.referenceT), 0.0429);
      const double probeC = (row.pt100Ohm - settings.probe.pt100OhmAt0C) / settings.probe.pt100OhmPerC;
      const Eigen::Vector3d truth = probe.trueFieldT({row.rawT[0], row.rawT[1], row.rawT[2]}, probeC, row.electronicsC);
      const auto axis = row.orientation ? static_cast<int>(*row.orientation) / 2 : static_cast<int>(*row.axis);
      Eigen::Vector3d expected = Eigen::Vector3d::Zero();
      expected[axis] = row.referenceT;
      ASSERT_LT((truth - expected).norm(), 8e-5) << "noise of readings and temperatures, line " << row.line;
    }
  }
  EXPECT_EQ(steps.size(), 8U);
}

TEST(HallCampaignTest, TheProbeLagsTheChamber) {
  HallCampaignSettings settings;
  settings.probe.pt100NoiseOhm = 0.0;
  const auto widest = [](const HallCampaignSettings& made) {
    double most = 0.0;
    for (const CampaignRow& row : makeHallCampaign(made).rows) {
      if (row.step == CampaignStep::ProbeTemperature) {
        most = std::max(most, std::abs((row.pt100Ohm - 100.0) / 0.3851 - row.chamberC));
      }
    }
    return most;
  };
  // A sine of amplitude 10 °C and period 400 s behind a lag of 12 s: 10·ωτ/√(1 + ω²τ²) = 1.85 °C
  EXPECT_NEAR(widest(settings), 1.85, 0.1) << "about 2 °C, as in Figure 7";
  settings.lagS = 0.0;
  EXPECT_LT(widest(settings), 0.002);
}

TEST(HallCampaignTest, RepeatsWithItsSeedAndVariesWithAnother) {
  const field::Campaign one = makeHallCampaign(quickHallCampaign(11));
  const field::Campaign again = makeHallCampaign(quickHallCampaign(11));
  const field::Campaign other = makeHallCampaign(quickHallCampaign(12));
  ASSERT_EQ(one.rows.size(), again.rows.size());
  EXPECT_LT(one.rows.size(), 2500U);
  for (std::size_t i = 0; i < one.rows.size(); ++i) {
    ASSERT_EQ(one.rows[i].rawT, again.rows[i].rawT);
  }
  EXPECT_NE(one.rows.front().rawT, other.rows.front().rawT);
}

} // namespace
} // namespace straightedge::devices
