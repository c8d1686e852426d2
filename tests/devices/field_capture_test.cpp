// Field capture on the simulated bench: what was planned is what the sink gets, and it can be steered.
#include "core/field/campaign_csv.h"
#include "core/field/names.h"
#include "core/field/session_campaign.h"
#include "devices/capture/field_course.h"
#include "tests/devices/field_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <map>
#include <thread>

namespace straightedge::devices {
namespace {

using field::CampaignRow;
using field::CampaignStep;
using testing::HasSubstr;

/// Waits for what the capture thread brings about; the deadline is never reached where it works.
template <typename Condition>
bool eventually(const Condition& condition) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!condition() && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return condition();
}

class FieldCaptureTest : public testing::Test {
protected:
  FieldPlan onlyStage(CampaignStep step, field::Axis axis = field::Axis::X) const {
    FieldPlan plan = tests::smallFieldPlan();
    std::erase_if(plan.stages,
                  [&](const FieldStage& stage) { return stage.step != step || (stage.axis && *stage.axis != axis); });
    return plan;
  }
  tests::FieldMemorySink m_sink;
};

TEST_F(FieldCaptureTest, EveryStageArrivesAsPlannedAndFollowsTheTruth) {
  SimulatedFieldBench bench(tests::virtualFieldBench());
  FieldCapture capture(bench.bench(), m_sink);
  const FieldPlan plan = tests::smallFieldPlan();
  ASSERT_EQ(plan.stages.size(), 21U);
  ASSERT_TRUE(capture.start(plan));
  capture.waitUntilDone();
  const FieldCaptureProgress progress = capture.progress();
  ASSERT_EQ(progress.state, CaptureState::Finished) << progress.error->message();
  EXPECT_EQ(progress.pointsDone, progress.pointsPlanned);
  EXPECT_EQ(*progress.remainingS, 0.0);

  const auto samples = m_sink.committed();
  std::map<std::pair<int, int>, int> counted;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(samples[i].sequence, static_cast<std::int64_t>(i));
    if (i > 0) {
      EXPECT_GT(samples[i].timeS, samples[i - 1].timeS);
    }
    const FieldStage& stage = plan.stages.at(static_cast<std::size_t>(samples[i].stage));
    counted[{samples[i].stage, samples[i].point}] += isSweep(stage) || samples[i].locked ? 1 : 0;
    EXPECT_EQ(samples[i].locked, samples[i].referenceT.has_value());
    EXPECT_EQ(samples[i].chamberC.has_value(), stage.step == CampaignStep::ProbeTemperature);
    if (stage.step == CampaignStep::Verification) {
      const FieldPoint point = plannedPoints(stage).at(static_cast<std::size_t>(samples[i].point));
      EXPECT_NEAR(*samples[i].electronicsC, *point.electronicsC, 0.3);
      EXPECT_NEAR((*samples[i].pt100Ohm - 100.0) / 0.3851, *point.probeC, 0.1);
    }
  }
  for (std::size_t i = 0; i < plan.stages.size(); ++i) {
    for (const FieldPoint& point : plannedPoints(plan.stages[i])) {
      EXPECT_EQ((counted[{static_cast<int>(i), point.index}]), plan.stages[i].rows)
          << stageTitle(plan.stages[i]) << " " << point.fieldT;
    }
  }
  EXPECT_EQ(capture.takeNewSamples().size(), samples.size());

  const auto campaign = field::campaignFromSamples(samples, "test");
  ASSERT_TRUE(campaign);
  const HallProbeSettings& probe = bench.settings().probe;
  for (const CampaignRow& row : campaign->rows) {
    if (!row.locked) {
      continue;
    }
    const double probeC = (row.pt100Ohm - probe.pt100OhmAt0C) / probe.pt100OhmPerC;
    const Eigen::Vector3d truth =
        bench.truth().trueFieldT({row.rawT[0], row.rawT[1], row.rawT[2]}, probeC, row.electronicsC);
    Eigen::Vector3d expected = Eigen::Vector3d::Zero();
    expected[row.orientation ? static_cast<int>(*row.orientation) / 2 : static_cast<int>(*row.axis)] = row.referenceT;
    ASSERT_LT((truth - expected).norm(), 8e-5) << field::stepName(row.step) << ", line " << row.line;
  }
}

TEST_F(FieldCaptureTest, TheCampaignReadsBackFromItsCsv) {
  SimulatedFieldBench bench(tests::virtualFieldBench());
  FieldCapture capture(bench.bench(), m_sink);
  ASSERT_TRUE(capture.start(tests::smallFieldPlan()));
  capture.waitUntilDone();
  const auto campaign = *field::campaignFromSamples(m_sink.committed(), "test");
  const std::string csv = field::campaignCsv(campaign);
  const auto read = field::parseCampaignCsv(csv, "campaign.csv", "campaign.csv");
  ASSERT_TRUE(read) << read.error().message();
  ASSERT_EQ(read->rows.size(), campaign.rows.size());
  EXPECT_EQ(field::campaignCsv(*read), csv);
}

TEST_F(FieldCaptureTest, BelowTheThresholdTheReferenceNeverLocksAndThePlateauIsGivenUp) {
  SimulatedFieldBench bench(tests::virtualFieldBench());
  FieldCapture capture(bench.bench(), m_sink);
  FieldPlan plan = onlyStage(CampaignStep::Nonlinearity);
  plan.stages[0].fieldsT = {0.1, 0.044, 0.042, -0.042, -0.044, -0.1};
  ASSERT_TRUE(capture.start(plan));
  capture.waitUntilDone();
  const FieldCaptureProgress progress = capture.progress();
  EXPECT_EQ(progress.state, CaptureState::Finished);
  EXPECT_EQ(progress.stages.at(0).pointsGivenUp, 2);
  std::map<int, int> locked;
  std::map<int, int> unlocked;
  for (const auto& sample : m_sink.committed()) {
    ++(sample.locked ? locked : unlocked)[sample.point];
    EXPECT_EQ(sample.locked, sample.referenceT.has_value());
  }
  EXPECT_EQ(locked[0], 4);
  EXPECT_EQ(locked[1], 4);
  EXPECT_EQ(locked[2], 0);
  EXPECT_EQ(locked[3], 0);
  EXPECT_EQ(locked[4], 4);
  EXPECT_EQ(unlocked[2], 5) << "for 30 s, every 6 s";
}

TEST_F(FieldCaptureTest, AReferenceThatNeverLocksInAStagePausesWithAReason) {
  SimulatedFieldSettings settings = tests::virtualFieldBench();
  settings.lockThresholdT = 5.0;
  SimulatedFieldBench bench(settings);
  FieldCapture capture(bench.bench(), m_sink);
  ASSERT_TRUE(capture.start(onlyStage(CampaignStep::Nonlinearity)));
  capture.waitUntilDone();
  const FieldCaptureProgress progress = capture.progress();
  ASSERT_EQ(progress.state, CaptureState::Paused);
  ASSERT_TRUE(progress.error);
  EXPECT_EQ(progress.error->kind, ErrorKind::Instrument);
  EXPECT_THAT(progress.error->message(), HasSubstr("never locked in stage 'nonlinearity, x'"));
  EXPECT_FALSE(m_sink.committed().empty()) << "what was recorded is kept";
}

TEST_F(FieldCaptureTest, TheProbeLagsItsChamber) {
  SimulatedFieldBench bench(tests::virtualFieldBench());
  FieldCapture capture(bench.bench(), m_sink);
  FieldPlan plan = onlyStage(CampaignStep::ProbeTemperature);
  plan.stages[0].rows = 800;
  plan.stages[0].rowS = 1.0;
  ASSERT_TRUE(capture.start(plan));
  capture.waitUntilDone();
  double widest = 0.0;
  for (const auto& sample : m_sink.committed()) {
    widest = std::max(widest, std::abs((*sample.pt100Ohm - 100.0) / 0.3851 - *sample.chamberC));
  }
  EXPECT_NEAR(widest, 1.85, 0.15) << "about 2 °C, as in Figure 7";
}

TEST_F(FieldCaptureTest, WaitsForAPersonWhereNobodyElsePlacesTheProbe) {
  SimulatedFieldSettings settings = tests::virtualFieldBench();
  settings.byHand = true;
  SimulatedFieldBench bench(settings);
  FieldCapture capture(bench.bench(), m_sink);
  FieldPlan plan = onlyStage(CampaignStep::Orientation);
  plan.stages.resize(2);
  ASSERT_TRUE(capture.start(plan));
  ASSERT_TRUE(eventually([&] { return !capture.progress().waitingFor.empty(); }));
  EXPECT_EQ(capture.progress().waitingFor, "place the probe with its +x axis along the field");
  EXPECT_EQ(capture.progress().state, CaptureState::Running);
  EXPECT_TRUE(m_sink.committed().empty());
  bench.placeByHand(ProbePlacement::PlusX);
  capture.confirm();
  EXPECT_NE(capture.progress().waitingFor, "place the probe with its +x axis along the field") << "no longer asked for";
  ASSERT_TRUE(
      eventually([&] { return capture.progress().waitingFor == "place the probe with its -x axis along the field"; }));
  EXPECT_EQ(capture.progress().stages.at(0).pointsDone, 3);
  capture.pause();
  ASSERT_TRUE(eventually([&] { return capture.progress().state == CaptureState::Paused; }));
  capture.resume();
  ASSERT_TRUE(eventually([&] { return !capture.progress().waitingFor.empty(); })) << "asked again";
  bench.placeByHand(ProbePlacement::MinusX);
  capture.confirm();
  capture.waitUntilDone();
  EXPECT_EQ(capture.progress().state, CaptureState::Finished);
  for (const auto& sample : m_sink.committed()) {
    if (sample.locked) {
      EXPECT_EQ(*sample.referenceT > 0.0, sample.stage == 0) << "the sign is that of the package's axis";
      EXPECT_EQ(sample.rawT[0] > 0.0, sample.stage == 0);
    }
  }
}

TEST_F(FieldCaptureTest, AStageThatWaitsMayBeSkippedAtOnce) {
  SimulatedFieldSettings settings = tests::virtualFieldBench();
  settings.byHand = true;
  SimulatedFieldBench bench(settings);
  FieldCapture capture(bench.bench(), m_sink);
  FieldPlan plan = onlyStage(CampaignStep::Orientation);
  plan.stages.resize(2);
  ASSERT_TRUE(capture.start(plan));
  ASSERT_TRUE(eventually([&] { return !capture.progress().waitingFor.empty(); }));
  capture.skip(0);
  ASSERT_TRUE(eventually([&] { return capture.progress().stage == 1; }));
  capture.skip(1);
  capture.waitUntilDone();
  EXPECT_EQ(capture.progress().state, CaptureState::Finished);
  EXPECT_TRUE(m_sink.committed().empty());
}

TEST_F(FieldCaptureTest, AStageBeingMeasuredIsLeftAtOnce) {
  SimulatedFieldBench bench(tests::virtualFieldBench());
  FieldCapture capture(bench.bench(), m_sink);
  FieldPlan plan = onlyStage(CampaignStep::Offset);
  plan.stages.front().rows = 1'000'000;
  ASSERT_TRUE(capture.start(plan));
  ASSERT_TRUE(eventually([&] { return capture.progress().rowsTaken > 0; }));
  capture.redo(0);
  ASSERT_TRUE(eventually([&] { return capture.progress().stages.at(0).attempt == 1; }));
  ASSERT_TRUE(eventually([&] { return capture.progress().rowsTaken > 0; }));
  capture.skip(0);
  capture.waitUntilDone();
  EXPECT_EQ(capture.progress().state, CaptureState::Finished);
  const auto samples = m_sink.committed();
  ASSERT_FALSE(samples.empty());
  EXPECT_LT(samples.size(), 1'000'000U);
  EXPECT_EQ(samples.back().attempt, 1);
}

TEST_F(FieldCaptureTest, TellsWhatItDoes) {
  struct FailingProbe : FieldProbe {
    FailingProbe(FieldProbe& behind, int readings) : probe(behind), left(readings) {}
    InstrumentIdentity identity() const override { return probe.identity(); }
    Result<FieldReading> readT() override {
      return left-- > 0 ? probe.readT() : fail(ErrorKind::Instrument, "off", "switch it on", "teslameter");
    }
    FieldProbe& probe;
    int left;
  };
  SimulatedFieldBench bench(tests::virtualFieldBench());
  FailingProbe probe(*bench.bench().probe, 5);
  FieldBench failing = bench.bench();
  failing.probe = &probe;
  const FieldPlan sweep = onlyStage(CampaignStep::Offset);
  {
    FieldCapture capture(failing, m_sink);
    ASSERT_TRUE(capture.start(sweep));
    capture.waitUntilDone(); // the fault pauses it
    EXPECT_EQ(capture.progress().action, FieldAction::SweepingProbe);
    EXPECT_EQ(capture.progress().rowsTaken, 5);
    EXPECT_EQ(capture.progress().target, sweepC(sweep.stages.front(), 5));
  }
  probe.left = 0;
  const FieldPlan plateaus = onlyStage(CampaignStep::Nonlinearity);
  {
    FieldCapture capture(failing, m_sink);
    ASSERT_TRUE(capture.start(plateaus));
    capture.waitUntilDone();
    EXPECT_EQ(capture.progress().action, FieldAction::WaitingForLock);
    EXPECT_EQ(capture.progress().target, -2.0);
    EXPECT_EQ(capture.progress().rowsTaken, 0);
    probe.left = 1000000;
    capture.resume();
    capture.waitUntilDone();
    EXPECT_EQ(capture.progress().state, CaptureState::Finished);
    EXPECT_EQ(capture.progress().action, FieldAction::TakingRows);
  }
  FieldBench byHand = failing;
  byHand.carrier = nullptr;
  FieldCapture capture(byHand, m_sink);
  ASSERT_TRUE(capture.start(plateaus));
  ASSERT_TRUE(eventually([&] { return !capture.progress().waitingFor.empty(); }));
  EXPECT_EQ(capture.progress().action, FieldAction::Placing);
}

TEST_F(FieldCaptureTest, AStageMeasuredAgainReplacesWhatItGaveBefore) {
  SimulatedFieldBench bench(tests::virtualFieldBench());
  FieldCapture capture(bench.bench(), m_sink);
  const FieldPlan plan = onlyStage(CampaignStep::Offset);
  ASSERT_TRUE(capture.start(plan));
  capture.waitUntilDone();
  capture.redo(0);
  capture.redo(77);
  capture.waitUntilDone();
  EXPECT_EQ(capture.progress().stages.at(0).attempt, 1);
  const auto samples = m_sink.committed();
  EXPECT_EQ(samples.size(), 80U);
  EXPECT_EQ(samples.back().attempt, 1);
  const auto campaign = *field::campaignFromSamples(samples, "test");
  ASSERT_EQ(campaign.rows.size(), 40U);
  EXPECT_EQ(campaign.rows.front().rawT, samples[40].rawT);
}

TEST_F(FieldCaptureTest, GoesOnAfterEveryCutWithoutRowsTwiceOrMissing) {
  FieldPlan plan = tests::smallFieldPlan();
  std::erase_if(plan.stages, [](const FieldStage& stage) {
    return stage.step != CampaignStep::Nonlinearity && stage.step != CampaignStep::Offset;
  });
  plan.stages.erase(plan.stages.begin() + 1, plan.stages.begin() + 3);
  std::vector<session::FieldSample> already;
  for (const std::size_t cut : {1U, 7U, 30U, 55U, 70U}) {
    SimulatedFieldBench bench(tests::virtualFieldBench());
    tests::FieldMemorySink sink;
    sink.failAfter(cut - already.size());
    FieldCapture capture(bench.bench(), sink);
    ASSERT_TRUE(capture.start(plan, already));
    capture.waitUntilDone();
    EXPECT_EQ(capture.progress().state, CaptureState::Failed);
    EXPECT_EQ(capture.progress().error->kind, ErrorKind::Storage);
    ASSERT_TRUE(sink.commit());
    const auto more = sink.committed();
    already.insert(already.end(), more.begin(), more.end());
    ASSERT_EQ(already.size(), cut);
  }
  SimulatedFieldBench bench(tests::virtualFieldBench());
  FieldCapture capture(bench.bench(), m_sink);
  ASSERT_TRUE(capture.start(plan, already));
  capture.waitUntilDone();
  ASSERT_EQ(capture.progress().state, CaptureState::Finished);
  const auto more = m_sink.committed();
  already.insert(already.end(), more.begin(), more.end());
  std::map<std::pair<int, int>, int> counted;
  for (std::size_t i = 0; i < already.size(); ++i) {
    EXPECT_EQ(already[i].sequence, static_cast<std::int64_t>(i));
    counted[{already[i].stage, already[i].point}] += already[i].stage == 1 || already[i].locked ? 1 : 0;
  }
  for (const auto& [point, rows] : counted) {
    EXPECT_EQ(rows, point.first == 1 ? 40 : 4) << point.first << "/" << point.second;
  }
  EXPECT_EQ(counted.size(), 11U);
}

TEST_F(FieldCaptureTest, SamplesOfAnotherPlanAreRefused) {
  session::FieldSample sample;
  sample.stage = 1;
  EXPECT_FALSE(FieldCourse::make(onlyStage(CampaignStep::Offset), {sample}));
  sample.stage = 0;
  const auto course = FieldCourse::make(onlyStage(CampaignStep::Offset), {sample});
  ASSERT_FALSE(course);
  EXPECT_EQ(course.error().kind, ErrorKind::Usage);
}

TEST_F(FieldCaptureTest, WhatNoInstrumentMeasuresStaysEmpty) {
  SimulatedFieldBench simulated(tests::virtualFieldBench());
  FieldBench bench = simulated.bench();
  bench.pt100 = nullptr;
  FieldCapture capture(bench, m_sink);
  ASSERT_TRUE(capture.start(onlyStage(CampaignStep::Nonlinearity)));
  capture.waitUntilDone();
  ASSERT_FALSE(m_sink.committed().empty());
  for (const auto& sample : m_sink.committed()) {
    EXPECT_FALSE(sample.pt100Ohm);
    EXPECT_FALSE(sample.chamberC);
    EXPECT_TRUE(sample.electronicsC);
  }
  bench.reference = nullptr;
  FieldCapture without(bench, m_sink);
  const auto started = without.start(onlyStage(CampaignStep::Nonlinearity));
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().kind, ErrorKind::Instrument);
}

TEST(FieldPlanTest, ComesBackFromItsJson) {
  FieldPlan plan = tests::smallFieldPlan();
  plan.stages[3].skipped = true;
  plan.settleS = 0.1;
  const auto read = fieldPlanFromJson(planToJson(plan));
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_TRUE(*read == plan);
  EXPECT_FALSE(fieldPlanFromJson("{}"));
  EXPECT_FALSE(fieldPlanFromJson(R"({"settle_s":1,"stages":[{"step":"guess","fields_T":[],"rows":3}]})"));
}

TEST(FieldPlanTest, RefusesWhatCannotBeMeasured) {
  const auto refused = [](const auto& change) {
    FieldPlan plan = tests::smallFieldPlan();
    change(plan);
    const auto checked = checkPlan(plan);
    return checked ? std::string() : checked.error().message();
  };
  EXPECT_EQ(refused([](FieldPlan&) {}), "");
  EXPECT_THAT(refused([](FieldPlan& plan) { plan.stages.clear(); }), HasSubstr("no stage to measure"));
  EXPECT_THAT(refused([](FieldPlan& plan) { plan.stages[0].fieldsT = {40.0}; }),
              HasSubstr("is 40 T; give -30 to 30 T"));
  EXPECT_THAT(refused([](FieldPlan& plan) { plan.stages[0].fieldsT = {}; }), HasSubstr("has no fields"));
  EXPECT_THAT(refused([](FieldPlan& plan) { plan.stages[0].rows = 0; }), HasSubstr("rows"));
  EXPECT_THAT(refused([](FieldPlan& plan) { plan.stages[3].highC = plan.stages[3].lowC; }), HasSubstr("highest"));
  EXPECT_THAT(refused([](FieldPlan& plan) { plan.settleS = std::nan(""); }), HasSubstr("settling time"));
}

TEST(FieldPlanTest, TheDefaultTakesHoursAndSaysSo) {
  const FieldPlan plan = makeFieldPlan();
  EXPECT_GT(expectedS(plan), 3.0 * 3600.0);
  EXPECT_LT(expectedS(plan), 12.0 * 3600.0);
  FieldPlan less = plan;
  less.stages[0].skipped = true;
  EXPECT_NEAR(expectedS(plan) - expectedS(less), expectedS(plan, plan.stages[0]), 1e-6);
}

TEST(SimulatedFieldBenchTest, SettingsComeBackFromTheirJson) {
  SimulatedFieldSettings settings = tests::virtualFieldBench();
  settings.seed = 99;
  settings.probe.axes[1].offsetT = {1e-6, 2e-6};
  settings.probe.axes[2].planarHallPerT = 0.001;
  settings.probe.axisMatrix(0, 2) = 0.123;
  settings.probe.curve = HallCurve::FieldOverRaw;
  const std::string json = simulatedFieldSettingsToJson(settings);
  const auto read = simulatedFieldSettingsFromJson(json);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(simulatedFieldSettingsToJson(*read), json);
  EXPECT_EQ(read->seed, 99U);
  EXPECT_EQ(read->probe.axisMatrix(0, 2), 0.123);
  EXPECT_FALSE(simulatedFieldSettingsFromJson("[]"));
}

TEST(SimulatedFieldBenchTest, TheNmrLosesTheLockWhileTheFieldChanges) {
  SimulatedFieldSettings settings = tests::virtualFieldBench();
  settings.searchS = 5.0; // on top of the 6.2 s until 0.1 T have come within 50 ppm
  SimulatedFieldBench simulated(settings);
  const FieldBench bench = simulated.bench();
  ASSERT_TRUE(bench.carrier->place(ProbePlacement::PlusX));
  ASSERT_TRUE(bench.magnet->setFieldT(-1.0));
  const auto lockedAfter = [&bench](double seconds) {
    FieldReferenceReading last;
    for (double passed = 0.0; passed < seconds; passed += 0.1) {
      last = *bench.reference->readT();
      bench.clock->sleepS(0.1);
    }
    return last;
  };
  EXPECT_FALSE(lockedAfter(2.0).locked);
  const FieldReferenceReading there = lockedAfter(20.0);
  ASSERT_TRUE(there.locked);
  EXPECT_NEAR(*there.fieldT, 1.0, 1e-5) << "magnitudes";
  ASSERT_TRUE(bench.magnet->setFieldT(-0.9));
  EXPECT_FALSE(lockedAfter(0.5).locked);
  EXPECT_FALSE(lockedAfter(9.0).locked) << "it searches";
  EXPECT_TRUE(lockedAfter(20.0).locked);
  ASSERT_TRUE(bench.magnet->setFieldT(-0.03));
  EXPECT_FALSE(lockedAfter(60.0).locked);
}

} // namespace
} // namespace straightedge::devices
