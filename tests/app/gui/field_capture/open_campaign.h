// A new field calibration with a fast simulated bench, and a small plan, as most tests here begin.
#pragma once

#include "app/gui/document/field_bench_link.h"
#include "app/gui/document/field_document.h"
#include "app/gui/jobs/job_runner.h"

#include <QSignalSpy>
#include <QTest>

#include <atomic>
#include <memory>

namespace straightedge::gui {

inline constexpr int captureWaitMs = 120000; ///< only a failing test waits so long

inline devices::SimulatedFieldSettings fastField(bool byHand = false) {
  devices::SimulatedFieldSettings settings;
  settings.realTime = false;
  settings.byHand = byHand;
  return settings;
}

/// All stages with few rows, or only those of some steps.
inline devices::FieldPlan smallCampaign(std::vector<field::CampaignStep> steps = {}) {
  devices::FieldPlanShape shape;
  shape.steps = std::move(steps);
  shape.fieldsT = {-2.0, -1.5, -1.0, -0.5, -0.1, 0.1, 0.5, 1.0, 1.5, 2.0};
  shape.rows = 3;
  shape.sweepRows = 20;
  shape.rowS = 6.0;
  return devices::makeFieldPlan(shape);
}

/// Two stages, both in the magnet: +x along the field, then −x.
inline devices::FieldPlan twoOrientations() {
  devices::FieldPlan plan = smallCampaign({field::CampaignStep::Orientation});
  plan.stages.resize(2);
  return plan;
}

/// A simulated bench whose teslameter fails from some reading on until it is mended.
class FailingFieldBench {
public:
  explicit FailingFieldBench(int goodReadings) : m_simulated(fastField()), m_probe(*m_simulated.bench().probe) {
    m_probe.left = goodReadings;
  }
  devices::FieldBench bench() {
    devices::FieldBench bench = m_simulated.bench();
    bench.name = "Failing bench";
    bench.probe = &m_probe;
    return bench;
  }
  void mend() { m_probe.left = 1'000'000'000; }
  /// From now on a reading waits until letGo(): what happens in the middle of a campaign is not left to speed.
  void hold() { m_probe.held = true; }
  void letGo() {
    m_probe.held = false;
    m_probe.held.notify_all();
  }

private:
  struct Probe : devices::FieldProbe {
    explicit Probe(devices::FieldProbe& behind) : probe(behind) {}
    devices::InstrumentIdentity identity() const override { return probe.identity(); }
    Result<devices::FieldReading> readT() override {
      held.wait(true);
      if (left.fetch_sub(1) <= 0) {
        left = 0;
        return fail(ErrorKind::Instrument, "the teslameter was switched off", "switch it on, then resume",
                    "teslameter");
      }
      return probe.readT();
    }
    devices::FieldProbe& probe;
    std::atomic<int> left = 0;
    std::atomic<bool> held = false;
  };

  devices::SimulatedFieldBench m_simulated;
  Probe m_probe;
};

struct OpenCampaign {
  JobRunner jobs;
  FieldDocument document{jobs};
  FieldBenchLink bench{document};

  OpenCampaign() {
    if (const Result<void> created = document.createScratch(); !created) {
      qFatal("%s", created.error().message().c_str());
    }
  }
  ~OpenCampaign() { jobs.cancelAll(); }
  OpenCampaign(const OpenCampaign&) = delete;
  OpenCampaign& operator=(const OpenCampaign&) = delete;

  bool connectFast(bool byHand = false) { return bench.connectSimulated(fastField(byHand)).has_value(); }
  /// Waits for the capture's end; false where it was not reached.
  bool captureToTheEnd(const devices::FieldPlan& plan, session::SweepRole role = session::SweepRole::Calibration,
                       bool resume = false) {
    QSignalSpy ended(&bench, &FieldBenchLink::captureEnded);
    return bench.startCapture(plan, role, resume).has_value() && (ended.count() > 0 || ended.wait(captureWaitMs));
  }
  bool waitsFor(const char* instruction) {
    return QTest::qWaitFor([&] { return bench.progress().waitingFor == instruction; }, captureWaitMs);
  }
  std::vector<session::FieldSample> stored(session::SweepRole role = session::SweepRole::Calibration) {
    return document.session()->fieldSamples(role).value_or(std::vector<session::FieldSample>{});
  }
};

} // namespace straightedge::gui
