// Does the true field lie within the stated expanded uncertainty as often as stated? One field vector at arbitrary
// probe and electronics temperatures for each of 2,000 simulated campaigns, in which every parameter of the instrument
// differs. Counted is each component, as the interval is stated.
#include "core/field/field_fit.h"
#include "core/field/uncertainty.h"
#include "devices/simulated/hall_campaign.h"

#include <gtest/gtest.h>

#include <cmath>

namespace straightedge::devices {
namespace {

#ifdef STRAIGHTEDGE_SANITIZED
constexpr int campaigns = 100; // what is counted does not depend on the build: here only memory is watched
#else
constexpr int campaigns = 2000;
#endif

double uniform(NoiseSource& random, double low, double high) {
  return low + (high - low) * 0.5 * std::erfc(-random.standardNormal() / std::sqrt(2.0));
}

Eigen::Vector3d anyField(NoiseSource& random, double fullScaleT) {
  Eigen::Vector3d fieldT;
  do {
    for (double& component : fieldT) {
      component = uniform(random, -fullScaleT, fullScaleT);
    }
  } while (fieldT.norm() > fullScaleT);
  return fieldT;
}

/// How often errors lie within U, and within what a budget would say that is wrong by 30 % in u.
struct Count {
  int components = 0;
  int within = 0;
  int withinNarrow = 0;
  int withinWide = 0;
  double sumU = 0.0;

  void add(const field::ReadingUncertainty& u, const Eigen::Vector3d& trueT) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double error = std::abs(u.fieldT[axis] - trueT[axis]);
      ++components;
      within += error <= u.expandedT[axis] ? 1 : 0;
      withinNarrow += error <= field::halfWidth95(u.residualT[axis], 0.7 * u.combinedT[axis]) ? 1 : 0;
      withinWide += error <= field::halfWidth95(u.residualT[axis], 1.3 * u.combinedT[axis]) ? 1 : 0;
      sumU += u.expandedT[axis];
    }
  }
  double percent(int count) const { return 100.0 * count / components; }
  void expect(const char* method) const {
    ::testing::Test::RecordProperty(method, std::to_string(percent(within)));
    EXPECT_EQ(components, 3 * campaigns);
    if (campaigns < 2000) {
      return;
    }
    EXPECT_GE(percent(within), 93.0) << method;
    EXPECT_LE(percent(within), 97.0) << method;
    EXPECT_LT(percent(withinNarrow), 93.0) << method << ": the check would see a budget that is too small";
    EXPECT_GT(percent(withinWide), 97.0) << method << ": and one that is too large";
  }
};

TEST(FieldCoverage, of95PercentIntervalsLiesBetween93And97) {
  // The generator draws the reference's scale with 2 ppm; its certificate says so.
  const field::FieldUncertaintyInputs certificate{.referenceRelative = 2e-6};
  NoiseSource random(20260711);
  Count stepwise;
  Count joint;
  for (int i = 0; i < campaigns; ++i) {
    const HallCampaignSettings settings = quickHallCampaign(static_cast<std::uint64_t>(i) + 1);
    const auto run = field::calibrateField(makeHallCampaign(settings), {.method = field::FitMethod::Joint}, {});
    ASSERT_TRUE(run) << i << ": " << run.error().message();
    const auto ofJoint = field::FieldUncertainty::of(run->parts, run->result.chain, certificate, "campaign");
    ASSERT_TRUE(ofJoint) << i << ": " << ofJoint.error().message();
    const auto ofStepwise = ofJoint->forChain(run->joint->stepwiseChain);
    ASSERT_TRUE(ofStepwise) << i << ": " << ofStepwise.error().message();

    const HallProbe probe(settings.probe);
    const Eigen::Vector3d fieldT = anyField(random, settings.probe.fullScaleT);
    const double probeC = uniform(random, 17.0, 31.0);
    const double electronicsC = uniform(random, 17.0, 34.0);
    const Eigen::Vector3d rawT = probe.readingT(fieldT, probeC, electronicsC, random);
    const field::Reading reading{.pt100Ohm = probe.pt100Ohm(probeC, random),
                                 .electronicsC = probe.electronicsReadingC(electronicsC, random),
                                 .rawT = {rawT.x(), rawT.y(), rawT.z()}};
    joint.add(ofJoint->at(reading), fieldT);
    stepwise.add(ofStepwise->at(reading), fieldT);
  }
  stepwise.expect("stepwise");
  joint.expect("joint");
  EXPECT_LT(joint.sumU, stepwise.sumU) << "what the chain leaves is part of it";
}

} // namespace
} // namespace straightedge::devices
