#include "app/cli/capture_options.h"

#include <utility>

namespace straightedge::cli {

void addCaptureOptions(CLI::App& command, CaptureOptions& options, const std::string& sweep,
                       const std::string& device) {
  command.add_option("--bench", options.bench, "Bench: simulated, the name of a saved bench, or its file")
      ->required()
      ->type_name("NAME");
  command.add_option("--session", options.session, "Session file (.sedge) to write")->required()->type_name("FILE");
  command.add_option("--csv", options.csv, "Also write the " + sweep + " as CSV (- for standard output)")
      ->type_name("FILE");
  command.add_flag("--resume", options.resume, "Go on with the " + sweep + " that the session holds");
  command.add_flag("--real-time", options.realTime, "Let the simulated bench take the time a real one takes");
  command.add_option("--wait", options.waitS, "Seconds to wait for an instrument that was unplugged (600)");
  command
      .add_option("--record-dialogue", options.dialogues,
                  "Record what is said with each instrument into files in DIR, for a bug report")
      ->type_name("DIR");
  command.add_option("--retries", options.retries, "Times to ask again after a time-out (2)")->group("Plan");
  const char* group = "Traceability";
  command.add_option("--serial", options.serial, "Serial number of the " + device)->type_name("TEXT")->group(group);
  command.add_option("--device-model", options.deviceModel, "Model of the " + device)->type_name("TEXT")->group(group);
  command.add_option("--operator", options.operatorName, "Who captures")->type_name("TEXT")->group(group);
}

Result<void> storeTraceability(session::Session& session, const CaptureOptions& options,
                               const CaptureTraceability& known) {
  auto traceability = session.traceability();
  if (!traceability) {
    return std::unexpected(std::move(traceability.error()));
  }
  const auto set = [](std::string& entry, const std::string& value) { entry = value.empty() ? entry : value; };
  set(traceability->deviceSerial, options.serial);
  set(traceability->deviceModel, options.deviceModel);
  set(traceability->operatorName, options.operatorName);
  if (known.device && traceability->deviceSerial.empty() && traceability->deviceModel.empty()) {
    traceability->deviceSerial = known.device->serial;
    traceability->deviceModel = known.device->model;
  }
  if (known.reference) {
    set(traceability->reference.model, known.reference->model);
    set(traceability->reference.serial, known.reference->serial);
  }
  if (known.ambientC) {
    traceability->ambientC = known.ambientC;
  }
  return session.setTraceability(*traceability);
}

Result<void> captureOutcome(const devices::CaptureProgress& progress, const std::string& session,
                            const std::string& points) {
  const std::string goOn = "go on with --resume";
  if (progress.error) {
    Error error = *progress.error;
    if (error.kind == ErrorKind::Instrument) {
      error.remedy += (error.remedy.empty() ? "" : ", or ") + goOn;
    }
    return std::unexpected(std::move(error));
  }
  if (progress.state == devices::CaptureState::Finished) {
    return {};
  }
  return fail(ErrorKind::Cancelled,
              "stopped after " + std::to_string(progress.pointsDone) + " of " + std::to_string(progress.pointsPlanned) +
                  " " + points + "; everything taken is stored",
              goOn, session);
}

} // namespace straightedge::cli
