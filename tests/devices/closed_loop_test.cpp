// From the simulated bench through capture, session and fit: the known truth comes back within the stated limit.
#include "core/angle/angles.h"
#include "core/angle/calibration.h"
#include "core/angle/session_sweep.h"
#include "core/angle/verification.h"
#include "devices/capture/angle_capture.h"
#include "devices/simulated/simulated_angle_bench.h"
#include "tests/core/session/session_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace straightedge {
namespace {

using devices::FieldGeometry;

struct LoopCase {
  const char* name;
  FieldGeometry geometry;
  bool decreasing;
  double sampleRateHz;
  double limitDeg; ///< of the error that is left against the truth
};

class ClosedLoopTest : public testing::TestWithParam<LoopCase> {};

void capture(devices::SimulatedAngleBench& bench, session::Session& session, session::SweepRole role,
             const devices::AnglePlan& plan) {
  auto sink = session.angleSink(role);
  ASSERT_TRUE(sink);
  devices::AngleCapture capture(bench.bench(), **sink);
  ASSERT_TRUE(capture.start(plan));
  capture.waitUntilDone();
  ASSERT_EQ(capture.progress().state, devices::CaptureState::Finished);
}

TEST_P(ClosedLoopTest, TheTruthComesBack) {
  const LoopCase& loop = GetParam();
  const tests::TemporaryFolder folder;
  devices::SimulatedAngleSettings settings;
  settings.realTime = false;
  settings.geometry = loop.geometry;
  settings.decreasing = loop.decreasing;
  devices::SimulatedAngleBench bench(settings);
  const devices::AnglePlan plan{.pointsPerTurn = 64,
                                .turns = 2,
                                .bothDirections = true,
                                .startDeg = 3.0,
                                .averages = 4,
                                .sampleRateHz = loop.sampleRateHz};
  {
    auto session = session::Session::create(folder / "a.sedge", session::SessionKind::Angle);
    ASSERT_TRUE(session);
    capture(bench, **session, session::SweepRole::Calibration, plan);
    capture(bench, **session, session::SweepRole::Verification, {.pointsPerTurn = 50, .startDeg = 1.7});
    ASSERT_TRUE((*session)->close());
  }
  const auto sweep = angle::readSessionSweep(folder / "a.sedge", session::SweepRole::Calibration);
  ASSERT_TRUE(sweep) << sweep.error().message();
  angle::CalibrationOptions options;
  options.models = {*angle::parseModelName("harmonic:8"), *angle::parseModelName("linear:128")};
  const auto run = angle::calibrate(sweep->sweep, options, sweep->traceability);
  ASSERT_TRUE(run) << run.error().message();
  EXPECT_EQ(run->result.direction,
            loop.decreasing ? angle::SensorDirection::Decreasing : angle::SensorDirection::Increasing);
  if (loop.sampleRateHz == 0.0) {
    ASSERT_TRUE(run->result.passes.hysteresisRmsDeg);
    EXPECT_NEAR(*run->result.passes.hysteresisRmsDeg, settings.hysteresisDeg, 0.01);
  }
  for (const angle::Model& model : run->result.models) {
    double worst = 0.0;
    for (int i = 0; i < 3600; ++i) {
      const double reading = 0.1 * i;
      worst =
          std::max(worst, std::abs(angle::wrap180(model.correctionDeg(reading) - bench.trueCorrectionDeg(reading))));
    }
    EXPECT_LT(worst, loop.limitDeg) << model.name.text();
    const auto fresh = angle::readSessionSweep(folder / "a.sedge", session::SweepRole::Verification);
    ASSERT_TRUE(fresh);
    const auto report = angle::verify(run->result, model, fresh->sweep, 0.2);
    ASSERT_TRUE(report) << report.error().message();
    EXPECT_TRUE(report->met) << model.name.text() << ": " << report->maxErrorDeg;
    EXPECT_GT(report->maxErrorBeforeDeg, 1.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Benches, ClosedLoopTest,
                         testing::Values(LoopCase{"OnAxis", FieldGeometry::OnAxis, false, 0.0, 0.03},
                                         LoopCase{"SideShaft", FieldGeometry::SideShaft, false, 0.0, 0.05},
                                         LoopCase{"SideShaftUpsideDown", FieldGeometry::SideShaft, true, 0.0, 0.05},
                                         LoopCase{"SideShaftFreeRunning", FieldGeometry::SideShaft, false, 2000.0,
                                                  0.05}),
                         [](const auto& tested) { return tested.param.name; });

} // namespace
} // namespace straightedge
