// The 32-point side-shaft sweep, calibrated, compared and verified: what figures and reports are tested with.
#pragma once

#include "app/gui/figures/angle_figures.h"
#include "core/angle/sweep_csv.h"

#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>

namespace straightedge::gui::testing {

template <typename T>
T valueOf(Result<T> result) {
  if (!result) {
    std::cerr << result.error().message() << '\n';
    std::abort(); // the test's own data are broken
  }
  return std::move(*result);
}

inline std::string exampleFile() { return STRAIGHTEDGE_TEST_DATA "/angle/side_shaft_32.csv"; }

inline angle::Sweep exampleSweep() { return valueOf(angle::readSweepCsv(exampleFile())); }

inline angle::CalibrationRun exampleRun(const angle::CalibrationOptions& options = {}) {
  Traceability trace;
  trace.deviceModel = "S <42>";
  trace.deviceSerial = "0007";
  trace.operatorName = "A. Tester";
  trace.reference = {"E100", "11", "C-5", "2027-01-31", 0.002};
  auto run = valueOf(angle::calibrate(exampleSweep(), options, trace));
  run.result.created = "2026-01-02T03:04:05Z";
  return run;
}

inline std::shared_ptr<AngleResults> exampleResults() {
  auto results = std::make_shared<AngleResults>();
  results->sweep = std::make_shared<const angle::Sweep>(exampleSweep());
  results->run = std::make_shared<const angle::CalibrationRun>(exampleRun());
  results->calibration = results->run->result;
  results->comparison = std::make_shared<const angle::Comparison>(angle::compareQuick(results->run->curve));
  results->verification =
      valueOf(angle::verify(results->calibration, results->calibration.models.front(), *results->sweep, 1.0));
  results->selected = results->calibration.models.front().name;
  results->targetErrorDeg = 0.5;
  results->budgetEntries = 64;
  return results;
}

} // namespace straightedge::gui::testing
