#include "app/cli/field_capture_command.h"

#include "app/cli/capture_options.h"
#include "app/cli/field_capture_run.h"

#include <memory>
#include <utility>

namespace straightedge::cli {

void addFieldCapture(CLI::App& capture, std::function<void(std::function<Result<void>()>)> onChosen) {
  CLI::App* field = capture.add_subcommand("field", "Three-axis teslameter against a reference field");
  const auto request = std::make_shared<FieldCaptureRequest>();
  addCaptureOptions(*field, *request, "campaign", "teslameter");
  field->add_flag("--yes", request->yes,
                  "Take all that a person is asked to do as done at once, where it is in place already");

  const char* group = "Plan";
  field
      ->add_option("--stages", request->stages,
                   "Steps to measure: nonlinearity,probe-temperature,offset,… (all that the bench can)")
      ->delimiter(',')
      ->type_name("LIST")
      ->group(group);
  field->add_option("--axes", request->axes, "Axes to measure: x,y,z (all)")
      ->delimiter(',')
      ->type_name("LIST")
      ->group(group);
  field->add_option("--fields", request->fieldsT, "Fields of the nonlinearity's plateaus, T (±2 in steps of 0.05)")
      ->delimiter(',')
      ->type_name("LIST")
      ->group(group);
  field->add_option("--rows", request->rows, "Locked rows of each plateau (10; orientation 30, verification 6)")
      ->group(group);
  field->add_option("--sweep-rows", request->sweepRows, "Rows of each temperature sweep (160 to 800)")->group(group);
  field->add_option("--temperatures", request->temperaturesC, "Lowest and highest temperature, °C, of all sweeps")
      ->delimiter(',')
      ->expected(2)
      ->type_name("LOW,HIGH")
      ->group(group);
  field->add_option("--row-time", request->rowS, "Seconds from row to row (1)")->group(group);
  field->add_option("--settle", request->settleS, "Seconds after the field was set (5)")->group(group);
  field->add_option("--temperature-settle", request->temperatureSettleS, "Seconds after a change of temperature (120)")
      ->group(group);
  field->add_option("--lock-timeout", request->lockTimeoutS, "Seconds without lock that end a plateau (30)")
      ->group(group);

  group = "Simulated bench";
  field->add_option("--seed", request->seed, "Repeats a run (1)")->group(group);
  field->add_option("--noise", request->noiseT, "Standard deviation of a reading, T (5e-6)")->group(group);
  field->add_option("--planar-hall", request->planarHallPerT, "Planar Hall effect: T per T² of the two other axes (0)")
      ->group(group);
  field->add_option("--probe-lag", request->probeLagS, "Lag of the probe behind its chamber, seconds (12)")
      ->group(group);

  field->callback(
      [request, onChosen = std::move(onChosen)] { onChosen([request] { return runFieldCapture(*request); }); });
}

} // namespace straightedge::cli
