#include "app/cli/capture_command.h"

#include "app/cli/capture_options.h"
#include "app/cli/field_capture_command.h"

#include <map>
#include <memory>
#include <utility>

namespace straightedge::cli {

void addCaptureCommand(CLI::App& program, std::function<void(std::function<Result<void>()>)> onChosen) {
  CLI::App* capture =
      program.add_subcommand("capture", "Capture a sweep or a field campaign on a bench into a session file");
  capture->require_subcommand(1);
  addFieldCapture(*capture, onChosen);
  CLI::App* angle = capture->add_subcommand("angle", "Angle sensor against a reference encoder");
  const auto request = std::make_shared<CaptureRequest>();

  addCaptureOptions(*angle, *request, "sweep", "sensor");
  angle->add_flag("--verification", request->verification, "A fresh sweep to verify with, beside the calibration's");

  angle->add_option("--points", request->points, "Points per turn (64)")->group("Plan");
  angle->add_option("--turns", request->turns, "Turns (1)")->group("Plan");
  angle->add_flag("--both-directions", request->bothDirections, "Back again in the other direction")->group("Plan");
  angle->add_option("--settle", request->settleS, "Seconds to wait at each point (0.05)")->group("Plan");
  angle->add_option("--averages", request->averages, "Readings per point, each stored (1)")->group("Plan");
  angle->add_option("--start", request->startDeg, "Encoder angle of the first point (0)")->group("Plan");
  angle->add_option("--pairing", request->pairing, "How readings are paired (as the bench says, else as-read)")
      ->check(CLI::IsMember({"as-read", "interpolate"}))
      ->group("Plan");
  angle->add_option("--pairing-age", request->pairingMaxAgeS, "Greatest age of a reading that is paired, s (0.1)")
      ->group("Plan");
  angle->add_option("--rate", request->rateHz, "Sample at this rate while the shaft turns, in Hz")->group("Plan");

  const std::map<std::string, devices::FieldGeometry> geometries = {{"on-axis", devices::FieldGeometry::OnAxis},
                                                                    {"side-shaft", devices::FieldGeometry::SideShaft}};
  const char* group = "Simulated bench";
  angle->add_option("--seed", request->seed, "Repeats a run (1)")->group(group);
  angle->add_option("--geometry", request->geometry, "on-axis or side-shaft")
      ->transform(CLI::CheckedTransformer(geometries).description(""))
      ->group(group)
      ->type_name("NAME");
  angle->add_flag("--decreasing", request->decreasing, "Sensor mounted upside down")->group(group);
  angle->add_option("--noise", request->noiseDeg, "Standard deviation of a reading, degrees (0.02)")->group(group);
  angle->add_option("--hysteresis", request->hysteresisDeg, "Half the loop's width, degrees (0.05)")->group(group);
  angle->add_option("--bits", request->sensorBits, "Resolution of the sensor; 0 for none (14)")->group(group);
  angle->add_option("--mounting", request->mountingDeg, "Encoder angle of the sensor's zero (80)")->group(group);

  angle->callback([request, onChosen = std::move(onChosen)] { onChosen([request] { return runCapture(*request); }); });
}

} // namespace straightedge::cli
