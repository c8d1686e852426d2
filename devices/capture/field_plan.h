// What to capture: the plan of a field campaign, stage by stage.
#pragma once

#include "core/base/error.h"
#include "core/field/campaign.h"
#include "devices/instruments/field_bench.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace straightedge::devices {

/// Smallest field that an NMR's probes lock on: the paper's plateaus leave out what is below.
inline constexpr double smallestLockT = 0.043;

/// One stage: the probe lies one way, and one block of the correction gets its data. A stage is measured again or left
/// out as a whole. It is made of points: plateaus of constant field and temperature, or sweeps of temperature.
struct FieldStage {
  field::CampaignStep step = field::CampaignStep::Nonlinearity;
  std::optional<field::Axis> axis;               ///< of steps with an axis
  std::optional<field::Orientation> orientation; ///< of step orientation
  std::vector<double> fieldsT; ///< of the magnet, signed, a point each; empty in the zero-field chamber
  std::vector<double> probeC;  ///< plateaus at several temperatures: every field at each; empty: at the reference's
  std::vector<double> electronicsC; ///< beside probeC, one for each (from the front again where there are fewer)
  double lowC = 0.0;                ///< sweeps: of probe or electronics, up and down again
  double highC = 0.0;
  int cycles = 1;
  int rows = 10;        ///< of a plateau (locked ones) or a sweep
  double rowS = 1.0;    ///< from row to row
  bool skipped = false; ///< left out by choice; its block of the correction stays off

  bool operator==(const FieldStage&) const = default;
};

struct FieldPlan {
  std::vector<FieldStage> stages;
  double settleS = 5.0;            ///< after the field was set
  double temperatureSettleS = 120; ///< after probe or electronics were sent to another temperature
  double lockTimeoutS = 30.0;      ///< without a locked row a plateau is given up after so long
  double referenceTemperatureC = 24.0;
  int retries = 2; ///< times that a reading is asked for again after a time-out, before the capture pauses

  bool operator==(const FieldPlan&) const = default;
};

/// What the defaults of a plan can be changed by. What is not given keeps the paper's shape.
struct FieldPlanShape {
  std::vector<field::CampaignStep> steps;     ///< empty: all
  std::vector<field::Axis> axes;              ///< empty: all
  std::optional<std::vector<double>> fieldsT; ///< of the nonlinearity
  std::optional<int> rows;                    ///< of a plateau
  std::optional<int> sweepRows;               ///< of a sweep at one field
  std::optional<double> lowC, highC;          ///< of all sweeps and of the verification
  std::optional<double> rowS, settleS, temperatureSettleS, lockTimeoutS;
};

/// Stages in the order in which they are best measured: nonlinearity, temperatures, orientations, verification.
FieldPlan makeFieldPlan(const FieldPlanShape& shape = {});

/// Errors (Usage): no stage, negative times, fields beyond ±30 T, temperatures beyond −50 to 150 °C, … with the range.
Result<void> checkPlan(const FieldPlan& plan);

/// One plateau or sweep.
struct FieldPoint {
  int index = 0; ///< within its stage
  double fieldT = 0.0;
  std::optional<double> probeC;       ///< plateaus: where not the reference temperature
  std::optional<double> electronicsC; ///< likewise
};
std::vector<FieldPoint> plannedPoints(const FieldStage& stage);

bool isProbeSweep(const FieldStage& stage);
bool isElectronicsSweep(const FieldStage& stage);
inline bool isSweep(const FieldStage& stage) { return isProbeSweep(stage) || isElectronicsSweep(stage); }
bool needsReference(const FieldStage& stage);
ProbePlacement placementOf(const FieldStage& stage);
/// Where a sweep is sent for its row: smoothly from low to high and back, so that nothing overshoots.
double sweepC(const FieldStage& stage, int row);

std::string stageTitle(const FieldStage& stage);            ///< "nonlinearity, x"
std::string placementInstruction(ProbePlacement placement); ///< "place the probe with its +x axis along the field"
std::string stagePurpose(const FieldStage& stage);          ///< why it is measured, and what is lost without it

/// What a stage takes, without the engineer's own time.
double expectedS(const FieldPlan& plan, const FieldStage& stage);
double expectedS(const FieldPlan& plan); ///< all stages that are not skipped

/// JSON for the session's "plan" document.
std::string planToJson(const FieldPlan& plan);
Result<FieldPlan> fieldPlanFromJson(std::string_view json);

} // namespace straightedge::devices
