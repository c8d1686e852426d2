#include "app/cli/capture_run.h"

#include "app/cli/capture_watch.h"
#include "core/angle/session_sweep.h"
#include "core/angle/sweep_csv.h"
#include "core/base/file_output.h"
#include "core/base/number_text.h"
#include "core/session/session.h"
#include "devices/bench/opened_bench.h"
#include "devices/capture/angle_capture.h"
#include "devices/simulated/simulated_settings_json.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
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

/// The bench by its name: the simulated one, or a saved one with its instruments.
struct AngleBenchSource {
  std::optional<devices::SavedBench> saved; ///< none: simulated
  std::unique_ptr<devices::SimulatedAngleBench> simulated;
  std::unique_ptr<devices::OpenedBench> real;

  bool opened() const { return saved.has_value(); }
  devices::PairingRule pairing() const { return saved ? saved->pairing : devices::PairingRule{}; }

  Result<void> openInstruments() {
    if (!saved) {
      return {};
    }
    auto done = devices::OpenedBench::open(*saved, devices::readProfiles(devices::userProfileFolder()));
    if (!done) {
      return std::unexpected(std::move(done.error()));
    }
    real = *std::move(done);
    auto roles = real->angleBench();
    return roles ? Result<void>{} : std::unexpected(std::move(roles.error()));
  }

  Result<devices::AngleBench> bench(const devices::SimulatedAngleSettings& settings) {
    if (real) {
      return real->angleBench();
    }
    simulated = std::make_unique<devices::SimulatedAngleBench>(settings);
    return simulated->bench();
  }
};

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

Result<PreparedRun> prepareResumed(const CaptureRequest& request, SweepRole role) {
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
                      const AngleBenchSource& source) {
  auto traceability = run.session->traceability();
  if (!traceability) {
    return std::unexpected(std::move(traceability.error()));
  }
  const auto set = [](std::string& field, const std::string& value) { field = value.empty() ? field : value; };
  set(traceability->deviceSerial, request.serial);
  set(traceability->deviceModel, request.deviceModel);
  set(traceability->operatorName, request.operatorName);
  const devices::InstrumentIdentity encoder = bench.reference->identity();
  set(traceability->reference.model, encoder.model);
  set(traceability->reference.serial, encoder.serial);
  if (bench.thermometer != nullptr) {
    const auto ambient = bench.thermometer->readC();
    if (!ambient) {
      return std::unexpected(ambient.error());
    }
    traceability->ambientC = ambient->value;
  }
  if (auto set1 = run.session->setTraceability(*traceability); !set1) {
    return set1;
  }
  if (role == SweepRole::Calibration && run.already.empty()) {
    auto noted = source.opened()
                     ? run.session->setDocument("bench", devices::benchToJson(*source.saved))
                     : run.session->setDocument("simulated-bench", devices::simulatedSettingsToJson(run.settings));
    if (!noted) {
      return noted;
    }
  }
  if (auto noted = run.session->setDocument("plan", devices::planToJson(run.plan)); !noted) {
    return noted;
  }
  return writeRecord(*run.session, role, run.plan, bench.name, false);
}

Result<void> outcomeOf(const devices::CaptureProgress& progress, const std::string& session) {
  using devices::CaptureState;
  const std::string goOn = "go on with --resume";
  if (progress.error) {
    Error error = *progress.error;
    if (error.kind == ErrorKind::Instrument) {
      error.remedy += (error.remedy.empty() ? "" : ", or ") + goOn;
    }
    return std::unexpected(std::move(error));
  }
  if (progress.state == CaptureState::Finished) {
    return {};
  }
  return fail(ErrorKind::Cancelled,
              "stopped after " + std::to_string(progress.pointsDone) + " of " + std::to_string(progress.pointsPlanned) +
                  " points; everything taken is stored",
              goOn, session);
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

} // namespace

Result<void> runCapture(const CaptureRequest& request) {
  AngleBenchSource source;
  if (request.bench != "simulated") {
    auto saved = devices::readBench(request.bench);
    if (!saved) {
      return std::unexpected(std::move(saved.error()));
    }
    source.saved = *std::move(saved);
  }
  CaptureWatch watch(request.waitS); // before any thread is started; libusb starts one
  // Before there is a session: without its bench it would only be in the way of the next try.
  if (auto opened = source.openInstruments(); !opened) {
    return opened;
  }
  if (auto checked = checkSettings(withOptions(devices::SimulatedAngleSettings{}, request)); !checked) {
    return checked;
  }
  const SweepRole role = request.verification ? SweepRole::Verification : SweepRole::Calibration;
  auto run = request.resume ? prepareResumed(request, role) : prepareNew(request, role, source.pairing());
  if (!run) {
    return std::unexpected(std::move(run.error()));
  }
  const auto bench = source.bench(run->settings);
  if (!bench) {
    return std::unexpected(bench.error());
  }
  if (auto described = describe(*run, request, role, *bench, source); !described) {
    return described;
  }
  devices::CaptureProgress progress;
  {
    auto sink = run->session->angleSink(role);
    if (!sink) {
      return std::unexpected(std::move(sink.error()));
    }
    devices::AngleCapture capture(*bench, **sink);
    if (auto started = capture.start(run->plan, run->already); !started) {
      return started;
    }
    progress = watch.follow(capture);
  }
  Result<void> outcome = outcomeOf(progress, request.session);
  if (outcome) {
    outcome = writeRecord(*run->session, role, run->plan, bench->name, true);
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

} // namespace straightedge::cli
