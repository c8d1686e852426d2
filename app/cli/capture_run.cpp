#include "app/cli/capture_run.h"

#include "app/cli/bench_run.h"
#include "core/angle/session_sweep.h"
#include "core/angle/sweep_csv.h"
#include "core/base/file_output.h"
#include "core/base/number_text.h"
#include "core/session/session.h"
#include "devices/capture/angle_capture.h"
#include "devices/simulated/simulated_settings_json.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace straightedge::cli {

namespace {

using session::SweepRole;

/// The names under which the window finds plan and bench of a captured sweep again.
const char* recordName(SweepRole role) { return role == SweepRole::Calibration ? "capture" : "verification-capture"; }

template <typename T, typename U>
void take(T& value, const std::optional<U>& given) {
  if (given) {
    value = static_cast<T>(*given);
  }
}

devices::AnglePlan withOptions(devices::AnglePlan plan, const CaptureRequest& request) {
  take(plan.pointsPerTurn, request.points);
  take(plan.turns, request.turns);
  take(plan.bothDirections, request.bothDirections);
  take(plan.settleS, request.settleS);
  take(plan.averages, request.averages);
  take(plan.startDeg, request.startDeg);
  take(plan.sampleRateHz, request.rateHz);
  take(plan.retries, request.retries);
  take(plan.pairing.maxAgeS, request.pairingMaxAgeS);
  if (request.pairing) {
    plan.pairing.kind = devices::pairingFromWord(*request.pairing).value_or(plan.pairing.kind);
  }
  return plan;
}

devices::SimulatedAngleSettings withOptions(devices::SimulatedAngleSettings settings, const CaptureRequest& request) {
  take(settings.seed, request.seed);
  take(settings.geometry, request.geometry);
  take(settings.decreasing, request.decreasing);
  take(settings.noiseDeg, request.noiseDeg);
  take(settings.hysteresisDeg, request.hysteresisDeg);
  take(settings.sensorBits, request.sensorBits);
  take(settings.mountingAngleDeg, request.mountingDeg);
  settings.realTime = request.realTime;
  return settings;
}

Result<void> checkSettings(const devices::SimulatedAngleSettings& settings) {
  const auto refuse = [](const char* option, const std::string& value, const char* range) {
    return fail(ErrorKind::Usage, std::string(option) + " is " + value, range);
  };
  if (!(settings.noiseDeg >= 0.0 && settings.noiseDeg <= 90.0)) {
    return refuse("--noise", formatDouble(settings.noiseDeg), "give 0 to 90 degrees");
  }
  if (!(settings.hysteresisDeg >= 0.0 && settings.hysteresisDeg <= 2.0)) {
    return refuse("--hysteresis", formatDouble(settings.hysteresisDeg), "give 0 to 2 degrees");
  }
  if (settings.sensorBits != 0 && (settings.sensorBits < 4 || settings.sensorBits > 32)) {
    return refuse("--bits", std::to_string(settings.sensorBits), "give 4 to 32, or 0 for no quantisation");
  }
  if (!(settings.mountingAngleDeg >= -360.0 && settings.mountingAngleDeg <= 360.0)) {
    return refuse("--mounting", formatDouble(settings.mountingAngleDeg), "give -360 to 360 degrees");
  }
  return {};
}

/// Everything that is settled before the first move.
struct PreparedRun {
  std::unique_ptr<session::Session> session;
  devices::AnglePlan plan;
  devices::SimulatedAngleSettings settings;
  std::vector<session::AngleSample> already;
};

Result<void> writeRecord(session::Session& session, SweepRole role, const devices::AnglePlan& plan,
                         const std::string& bench, bool finished) {
  const nlohmann::json record = {{"plan", devices::planToJson(plan)}, {"finished", finished}, {"bench", bench}};
  return session.setDocument(recordName(role), record.dump());
}

Result<devices::AnglePlan> storedPlan(const session::Session& session, SweepRole role) {
  const auto record = session.document(recordName(role));
  if (!record) {
    return std::unexpected(record.error());
  }
  const auto json = nlohmann::json::parse(*record, nullptr, false);
  if (!json.is_object() || !json.contains("plan") || !json.at("plan").is_string()) {
    return fail(ErrorKind::Input, "the session holds no sweep that was begun", "leave out --resume with a new file",
                session.file().string());
  }
  return devices::planFromJson(json.at("plan").get<std::string>());
}

Result<PreparedRun> prepareResumed(const CaptureRequest& request, SweepRole role, const BenchSource& source) {
  auto opened = session::Session::open(request.session);
  if (!opened) {
    return std::unexpected(std::move(opened.error()));
  }
  PreparedRun run{.session = *std::move(opened), .plan = {}, .settings = {}, .already = {}};
  auto plan = storedPlan(*run.session, role);
  if (!plan) {
    return std::unexpected(std::move(plan.error()));
  }
  run.plan = *plan;
  if (auto same = source.checkSame(*run.session, role); !same) {
    return std::unexpected(std::move(same.error()));
  }
  if (withOptions(run.plan, request) != run.plan) {
    return fail(ErrorKind::Usage, "the sweep was begun with another plan",
                "leave the plan's options out to go on with it", request.session);
  }
  auto already = run.session->angleSamples(role);
  if (!already) {
    return std::unexpected(std::move(already.error()));
  }
  run.already = *std::move(already);
  const auto stored = run.session->document("simulated-bench");
  if (!stored) {
    return std::unexpected(stored.error());
  }
  if (!stored->empty()) {
    auto settings = devices::simulatedSettingsFromJson(*stored);
    if (!settings) {
      return std::unexpected(std::move(settings.error()));
    }
    run.settings = *settings;
  }
  run.settings = withOptions(run.settings, request);
  // The noise goes on instead of repeating itself from the first point.
  run.settings.seed += 0x9E3779B97F4A7C15ULL * run.already.size();
  return run;
}

Result<PreparedRun> prepareNew(const CaptureRequest& request, SweepRole role, const devices::PairingRule& pairing) {
  PreparedRun run{.session = nullptr,
                  .plan = withOptions(devices::AnglePlan{.pairing = pairing}, request),
                  .settings = withOptions(devices::SimulatedAngleSettings{}, request),
                  .already = {}};
  if (auto checked = devices::checkPlan(run.plan); !checked) {
    return std::unexpected(std::move(checked.error()));
  }
  std::error_code ignored;
  const bool exists = std::filesystem::exists(request.session, ignored);
  if (exists && role == SweepRole::Calibration) {
    return fail(ErrorKind::Storage, "the file exists already", "give --resume to go on with it, or choose another name",
                request.session);
  }
  auto opened = exists ? session::Session::open(request.session)
                       : session::Session::create(request.session, session::SessionKind::Angle);
  if (!opened) {
    return std::unexpected(std::move(opened.error()));
  }
  run.session = *std::move(opened);
  const auto count = run.session->angleSampleCount(role);
  if (!count) {
    return std::unexpected(count.error());
  }
  if (*count > 0) {
    return fail(ErrorKind::Storage, "the session holds a verification sweep already",
                "give --resume to go on with it, or choose another file", request.session);
  }
  if (exists && request.verification) {
    // The same bench as the calibration's, with fresh noise.
    const auto stored = run.session->document("simulated-bench");
    if (stored && !stored->empty()) {
      if (auto settings = devices::simulatedSettingsFromJson(*stored)) {
        run.settings = withOptions(*settings, request);
        run.settings.seed = request.seed.value_or(settings->seed + 1);
      }
    }
  }
  return run;
}

Result<void> describe(PreparedRun& run, const CaptureRequest& request, SweepRole role, const devices::AngleBench& bench,
                      const BenchSource& source) {
  CaptureTraceability known{.device = {}, .reference = bench.reference->identity(), .ambientC = {}};
  if (bench.thermometer != nullptr) {
    const auto ambient = bench.thermometer->readC();
    if (!ambient) {
      return std::unexpected(ambient.error());
    }
    known.ambientC = ambient->value;
  }
  if (auto stored = storeTraceability(*run.session, request, known); !stored) {
    return stored;
  }
  if (run.already.empty()) {
    auto noted = source.note(*run.session, role);
    if (noted && source.isSimulated() && role == SweepRole::Calibration) {
      noted = run.session->setDocument("simulated-bench", devices::simulatedSettingsToJson(run.settings));
    }
    if (!noted) {
      return noted;
    }
  }
  if (auto noted = run.session->setDocument("plan", devices::planToJson(run.plan)); !noted) {
    return noted;
  }
  return writeRecord(*run.session, role, run.plan, bench.name, false);
}

Result<void> writeResults(const PreparedRun& run, const CaptureRequest& request, SweepRole role) {
  const auto samples = run.session->angleSamples(role);
  if (!samples) {
    return std::unexpected(samples.error());
  }
  if (request.csv.empty()) {
    return {};
  }
  return writeFileWhole(request.csv, angle::sweepToCsv(angle::sweepFromSamples(*samples)));
}

Result<void> captureOn(BenchSource& source, CaptureWatch& watch, const CaptureRequest& request) {
  if (auto checked = checkSettings(withOptions(devices::SimulatedAngleSettings{}, request)); !checked) {
    return checked;
  }
  const SweepRole role = request.verification ? SweepRole::Verification : SweepRole::Calibration;
  std::optional<Result<devices::AngleBench>> bench;
  if (source.instruments() != nullptr) {
    bench = source.instruments()->angleBench(); // before there is a session: without them it would only be in the way
    if (!*bench) {
      return std::unexpected(bench->error());
    }
  }
  auto run = request.resume ? prepareResumed(request, role, source) : prepareNew(request, role, source.pairing());
  if (!run) {
    return std::unexpected(std::move(run.error()));
  }
  std::optional<devices::SimulatedAngleBench> simulated;
  if (!bench) {
    bench = simulated.emplace(run->settings).bench();
  }
  if (auto described = describe(*run, request, role, **bench, source); !described) {
    return described;
  }
  devices::CaptureProgress progress;
  {
    auto sink = run->session->angleSink(role);
    if (!sink) {
      return std::unexpected(std::move(sink.error()));
    }
    devices::AngleCapture capture(**bench, **sink);
    if (auto started = capture.start(run->plan, run->already); !started) {
      return started;
    }
    progress = watch.follow(capture);
  }
  Result<void> outcome = captureOutcome(progress, request.session, "points");
  if (outcome) {
    outcome = writeRecord(*run->session, role, run->plan, (*bench)->name, true);
  }
  if (outcome) {
    outcome = writeResults(*run, request, role);
  }
  const auto closed = run->session->close();
  if (!outcome || !closed) {
    return outcome ? closed : outcome;
  }
  (request.csv == "-" ? std::cerr : std::cout)
      << request.session << ": " << progress.pointsPlanned << " points, "
      << run->already.size() + static_cast<std::size_t>(progress.samples) << " samples\n";
  return {};
}

} // namespace

Result<void> runCapture(const CaptureRequest& request) {
  return runOnBench(request,
                    [&request](BenchSource& source, CaptureWatch& watch) { return captureOn(source, watch, request); });
}

} // namespace straightedge::cli
