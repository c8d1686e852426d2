#include "app/cli/batch_run.h"

#include "app/cli/messages.h"
#include "app/cli/sweep_input.h"
#include "core/angle/sweep_csv.h"
#include "core/base/csv_table.h"
#include "core/base/file_output.h"
#include "core/base/number_text.h"
#include "core/export/calibration_json.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace straightedge::cli {

namespace {

std::string rowsOf(const BatchInput& input, const angle::AngleCalibration& calibration) {
  std::string rows;
  for (std::size_t i = 0; i < calibration.models.size(); ++i) {
    const angle::Model& model = calibration.models[i];
    const angle::ModelErrors& errors = model.errors;
    rows += csvCell(input.path) + "," + csvCell(input.resultName) + "," + model.name.text() + "," +
            std::to_string(model.name.storageEntries()) + "," + std::to_string(model.name.storageBytes()) + "," +
            std::to_string(calibration.source.points);
    for (const double value : {errors.maxCurveDeg, errors.rmsCurveDeg, errors.maxPointsDeg, errors.rmsPointsDeg,
                               calibration.leaveOneOutRmsDeg, calibration.uncertainty[i].expandedDeg}) {
      rows += "," + formatDouble(value);
    }
    rows += "," + std::to_string(calibration.warnings.size()) + ",\n";
  }
  return rows;
}

BatchOutcome rejected(const BatchInput& input, Error error) {
  constexpr const char* noFigures = ",,,,,,,,,,,,";
  return {csvCell(input.path) + noFigures + csvCell(error.message()) + "\n", std::move(error), 0};
}

BatchOutcome calibrateOne(const BatchInput& input, const BatchOptions& options) {
  const auto loaded = loadSweep(input.path, session::SweepRole::Calibration);
  if (!loaded) {
    return rejected(input, loaded.error());
  }
  const angle::Sweep* sweep = &loaded->sweep;
  auto run = angle::calibrate(*sweep, options.calibration, completed(options.traceability, loaded->traceability));
  if (!run) {
    return rejected(input, withPath(run.error(), sweep->source.file, input.path));
  }
  run->result.created = options.created;
  const std::string json = exporting::calibrationToJson(run->result);
  if (auto written = writeFileWhole(options.out + "/" + input.resultName, json, Durability::Cached); !written) {
    return rejected(input, written.error());
  }
  return {rowsOf(input, run->result), std::nullopt, run->result.warnings.size()};
}

} // namespace

std::string summaryHeader() {
  return "file,result,model,storage_entries,bytes,points,max_error_curve_deg,rms_error_curve_deg,max_error_points_deg,"
         "rms_error_points_deg,leave_one_out_rms_deg,expanded_uncertainty_deg,warnings,error\n";
}

std::vector<BatchOutcome> runBatch(const std::vector<BatchInput>& inputs, const BatchOptions& options,
                                   const std::function<void(std::size_t, std::size_t)>& progress) {
  std::vector<BatchOutcome> outcomes(inputs.size());
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> done{0};
  std::atomic<std::size_t> rejectedCount{0};
  std::mutex mutex;
  std::condition_variable ended;
  unsigned running = std::max(1U, options.jobs);
  const auto work = [&] {
    for (std::size_t i = next++; i < inputs.size(); i = next++) {
      outcomes[i] = calibrateOne(inputs[i], options);
      if (outcomes[i].problem) {
        ++rejectedCount;
        if (outcomes[i].problem->kind == ErrorKind::Storage) {
          next = inputs.size();
        }
      }
      ++done;
    }
    const std::scoped_lock lock(mutex);
    --running;
    ended.notify_one();
  };
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < std::max(1U, options.jobs); ++i) {
    threads.emplace_back(work);
  }
  std::unique_lock lock(mutex);
  while (!ended.wait_for(lock, std::chrono::milliseconds(200), [&] { return running == 0; })) {
    progress(done, rejectedCount);
  }
  lock.unlock();
  progress(done, rejectedCount);
  return outcomes;
}

} // namespace straightedge::cli
