// A new calibration with a fast simulated bench, as most tests here begin.
#pragma once

#include "app/gui/document/angle_document.h"
#include "app/gui/document/bench_link.h"
#include "app/gui/jobs/job_runner.h"

#include <QSignalSpy>
#include <QTest>

namespace straightedge::gui {

inline devices::SimulatedAngleSettings fastSettings() {
  devices::SimulatedAngleSettings settings;
  settings.realTime = false;
  return settings;
}

inline devices::AnglePlan planOf(int points, bool bothDirections = false, int averages = 1) {
  devices::AnglePlan plan;
  plan.pointsPerTurn = points;
  plan.bothDirections = bothDirections;
  plan.averages = averages;
  return plan;
}

struct OpenCalibration {
  JobRunner jobs;
  AngleDocument document{jobs};
  BenchLink bench{document};

  OpenCalibration() {
    const Result<void> created = document.createScratch();
    if (!created) {
      qFatal("%s", created.error().message().c_str());
    }
  }
  bool connectFast() { return bench.connectSimulated(fastSettings()).has_value(); }
  /// Waits for the capture's end; false where it was not reached.
  bool captureToTheEnd(const devices::AnglePlan& plan, session::SweepRole role = session::SweepRole::Calibration,
                       bool resume = false) {
    QSignalSpy ended(&bench, &BenchLink::captureEnded);
    return bench.startCapture(plan, role, resume).has_value() && (ended.count() > 0 || ended.wait(60000));
  }
};

} // namespace straightedge::gui
