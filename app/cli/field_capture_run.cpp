#include "app/cli/field_capture_run.h"

#include "app/cli/bench_run.h"
#include "app/cli/field_capture_plan.h"
#include "core/base/file_output.h"
#include "core/base/number_text.h"
#include "core/field/campaign_csv.h"
#include "core/field/session_campaign.h"
#include "core/session/session.h"
#include "devices/simulated/simulated_field_bench.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

namespace straightedge::cli {

namespace {

constexpr auto sweepRole = session::SweepRole::Calibration;

Result<devices::SimulatedFieldSettings> withOptions(devices::SimulatedFieldSettings settings,
                                                    const FieldCaptureRequest& request) {
  settings.seed = request.seed.value_or(settings.seed);
  settings.probe.noiseT = request.noiseT.value_or(settings.probe.noiseT);
  settings.probeLagS = request.probeLagS.value_or(settings.probeLagS);
  for (devices::HallAxis& axis : settings.probe.axes) {
    axis.planarHallPerT = request.planarHallPerT.value_or(axis.planarHallPerT);
  }
  settings.realTime = request.realTime;
  const auto check = [](const char* option, double value, double low, double high, const char* range) -> Result<void> {
    if (value >= low && value <= high) {
      return {};
    }
    return fail(ErrorKind::Usage, std::string(option) + " is " + formatDouble(value), range);
  };
  for (auto& checked : {check("--noise", settings.probe.noiseT, 0.0, 0.1, "give 0 to 0.1 T"),
                        check("--probe-lag", settings.probeLagS, 0.0, 3600.0, "give 0 to 3600 s"),
                        check("--planar-hall", settings.probe.axes[0].planarHallPerT, -0.1, 0.1, "give -0.1 to 0.1")}) {
    if (!checked) {
      return std::unexpected(checked.error());
    }
  }
  return settings;
}

/// Everything that is settled before the first placement.
struct PreparedFieldRun {
  std::unique_ptr<session::Session> session;
  devices::FieldPlan plan;
  devices::SimulatedFieldSettings settings;
  std::vector<session::FieldSample> already;
};

Result<void> writeRecord(session::Session& session, const devices::FieldPlan& plan, const std::string& bench,
                         bool finished) {
  const nlohmann::json record = {{"plan", devices::planToJson(plan)}, {"finished", finished}, {"bench", bench}};
  return session.setDocument("capture", record.dump());
}

/// The plan that the campaign was begun with. The document "plan" is where the window keeps the one for the next time.
Result<std::string> planOfCampaign(const session::Session& session) {
  const auto record = session.document("capture");
  if (record && !record->empty()) {
    const auto json = nlohmann::json::parse(*record, nullptr, false);
    if (json.is_object() && json.contains("plan") && json["plan"].is_string()) {
      return json["plan"].get<std::string>();
    }
  }
  return session.document("plan");
}

Result<void> readStored(PreparedFieldRun& run, const FieldCaptureRequest& request) {
  auto plan = planOfCampaign(*run.session);
  auto settings = run.session->document("simulated-bench");
  auto already = run.session->fieldSamples(sweepRole);
  if (!plan || !settings || !already) {
    return std::unexpected(!plan ? plan.error() : !settings ? settings.error() : already.error());
  }
  if (run.session->kind() != session::SessionKind::Field || plan->empty()) {
    return fail(ErrorKind::Input, "the session holds no campaign that was begun", "leave out --resume with a new file",
                request.session);
  }
  auto parsed = devices::fieldPlanFromJson(*plan);
  auto stored = devices::simulatedFieldSettingsFromJson(settings->empty() ? "{}" : *settings);
  if (!parsed || !stored) {
    return std::unexpected(!parsed ? parsed.error() : stored.error());
  }
  run.plan = *std::move(parsed);
  run.settings = *stored;
  run.already = *std::move(already);
  return {};
}

Result<PreparedFieldRun> prepareResumed(const FieldCaptureRequest& request, const BenchSource& source) {
  if (changesPlan(request)) {
    return fail(ErrorKind::Usage, "a campaign is resumed with the plan it was begun with",
                "leave the plan's options out to go on with it", request.session);
  }
  auto opened = session::Session::open(request.session);
  if (!opened) {
    return std::unexpected(std::move(opened.error()));
  }
  PreparedFieldRun run{.session = *std::move(opened), .plan = {}, .settings = {}, .already = {}};
  if (auto read = readStored(run, request); !read) {
    return std::unexpected(std::move(read.error()));
  }
  if (auto same = source.checkSame(*run.session, sweepRole); !same) {
    return std::unexpected(std::move(same.error()));
  }
  auto settings = withOptions(run.settings, request);
  if (!settings) {
    return std::unexpected(std::move(settings.error()));
  }
  run.settings = *std::move(settings);
  run.settings.byHand = false; // the window can lay the simulated probe by hand; nobody does so here
  // The noise goes on instead of repeating itself from the first row.
  run.settings.seed += 0x9E3779B97F4A7C15ULL * run.already.size();
  return run;
}

/// `instruments`: of a saved bench; null for the simulated one, which has everything.
Result<PreparedFieldRun> prepareNew(const FieldCaptureRequest& request, const BenchSource& source,
                                    const devices::FieldBench* instruments) {
  auto plan = requestedPlan(request);
  auto settings = withOptions({}, request);
  if (!plan || !settings) {
    return std::unexpected(!plan ? plan.error() : settings.error());
  }
  std::error_code ignored;
  if (std::filesystem::exists(request.session, ignored)) {
    return fail(ErrorKind::Storage, "the file exists already", "give --resume to go on with it, or choose another name",
                request.session);
  }
  if (instruments != nullptr) {
    if (auto fits = fitToBench(*plan, *instruments, !request.stages.empty()); !fits) {
      return std::unexpected(std::move(fits.error()));
    }
  }
  auto created = session::Session::create(request.session, session::SessionKind::Field);
  if (!created) {
    return std::unexpected(std::move(created.error()));
  }
  PreparedFieldRun run{
      .session = *std::move(created), .plan = *std::move(plan), .settings = *std::move(settings), .already = {}};
  auto noted = source.note(*run.session, sweepRole);
  if (noted && source.isSimulated()) {
    noted = run.session->setDocument("simulated-bench", devices::simulatedFieldSettingsToJson(run.settings));
  }
  if (noted) {
    noted = run.session->setDocument("plan", devices::planToJson(run.plan));
  }
  if (!noted) {
    return std::unexpected(std::move(noted.error()));
  }
  return run;
}

Result<void> describe(PreparedFieldRun& run, const FieldCaptureRequest& request, const devices::FieldBench& bench,
                      const BenchSource& source) {
  CaptureTraceability known;
  if (bench.reference != nullptr) {
    known.reference = bench.reference->identity();
  }
  if (source.isSimulated()) {
    known.ambientC = run.settings.roomC;
  } else {
    known.device = bench.probe->identity();
  }
  if (auto stored = storeTraceability(*run.session, request, known); !stored) {
    return stored;
  }
  return writeRecord(*run.session, run.plan, bench.name, false);
}

Result<void> writeCsv(const PreparedFieldRun& run, const FieldCaptureRequest& request) {
  if (request.csv.empty()) {
    return {};
  }
  const auto samples = run.session->fieldSamples(sweepRole);
  if (!samples) {
    return std::unexpected(samples.error());
  }
  const auto campaign = field::campaignFromSamples(*samples, request.session);
  if (!campaign) {
    return std::unexpected(campaign.error());
  }
  return writeFileWhole(request.csv, field::campaignCsv(*campaign));
}

void tellWhatIsNext(const FieldCaptureRequest& request, const PreparedFieldRun& run,
                    const devices::FieldCaptureProgress& progress) {
  std::ostream& out = request.csv == "-" ? std::cerr : std::cout;
  const auto stages = std::ranges::count(run.plan.stages, false, &devices::FieldStage::skipped);
  out << request.session << ": " << stages << " stages, " << progress.pointsPlanned << " plateaus and sweeps, "
      << run.already.size() + static_cast<std::size_t>(progress.samples) << " rows\n";
  for (std::size_t i = 0; i < progress.stages.size(); ++i) {
    if (progress.stages[i].pointsGivenUp > 0) {
      out << "stage '" << devices::stageTitle(run.plan.stages[i]) << "': the reference did not lock at "
          << progress.stages[i].pointsGivenUp << " of " << progress.stages[i].pointsPlanned << " fields\n";
    }
  }
  out << "next: straightedge-cli field fit " << request.session << " --out DIR\n";
}

Result<void> captureOn(BenchSource& source, CaptureWatch& watch, const FieldCaptureRequest& request) {
  std::optional<devices::FieldBench> bench;
  if (source.instruments() != nullptr) {
    auto roles = source.instruments()->fieldBench();
    if (!roles) {
      return std::unexpected(std::move(roles.error()));
    }
    bench = *std::move(roles);
  }
  auto run = request.resume ? prepareResumed(request, source) : prepareNew(request, source, bench ? &*bench : nullptr);
  if (!run) {
    return std::unexpected(std::move(run.error()));
  }
  std::optional<devices::SimulatedFieldBench> simulated;
  if (!bench) {
    bench = simulated.emplace(run->settings).bench();
  }
  if (auto described = describe(*run, request, *bench, source); !described) {
    return described;
  }
  std::vector<std::string> titles;
  for (const devices::FieldStage& stage : run->plan.stages) {
    titles.push_back(devices::stageTitle(stage));
  }
  devices::FieldCaptureProgress progress;
  {
    auto sink = run->session->fieldSink(sweepRole);
    if (!sink) {
      return std::unexpected(std::move(sink.error()));
    }
    devices::FieldCapture capture(*bench, **sink);
    if (auto started = capture.start(run->plan, run->already); !started) {
      return started;
    }
    progress = watch.follow(capture, titles, PersonPrompt(request.yes));
  }
  Result<void> outcome = captureOutcome(progress, request.session, "plateaus and sweeps");
  if (outcome) {
    outcome = writeRecord(*run->session, run->plan, bench->name, true);
  }
  if (outcome) {
    outcome = writeCsv(*run, request);
  }
  const auto closed = run->session->close();
  if (!outcome || !closed) {
    return outcome ? closed : outcome;
  }
  tellWhatIsNext(request, *run, progress);
  return {};
}

} // namespace

Result<void> runFieldCapture(const FieldCaptureRequest& request) {
  return runOnBench(request,
                    [&request](BenchSource& source, CaptureWatch& watch) { return captureOn(source, watch, request); });
}

} // namespace straightedge::cli
