#include "devices/capture/field_plan.h"

#include "core/base/number_text.h"
#include "core/field/names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace straightedge::devices {

namespace {

using field::Axis;
using field::CampaignStep;

constexpr int mostRows = 1000000;
constexpr int mostCycles = 100;
constexpr double longestS = 86400.0;
constexpr int mostRepeats = 100; // of a reading, after time-outs
constexpr double largestFieldT = 30.0;
constexpr double coldestC = -50.0;
constexpr double hottestC = 150.0;

Result<void> inRange(const std::string& name, double value, double low, double high, const char* unit) {
  if (value >= low && value <= high) { // false for NaN
    return {};
  }
  return fail(ErrorKind::Usage, name + " is " + formatDouble(value) + unit,
              "give " + formatDouble(low) + " to " + formatDouble(high) + unit, "capture plan");
}

Result<void> checkStage(const FieldStage& stage) {
  const std::string title = stageTitle(stage);
  const bool zeroField = placementOf(stage) == ProbePlacement::ZeroChamber;
  if (!zeroField && stage.fieldsT.empty()) {
    return fail(ErrorKind::Usage, "stage '" + title + "' has no fields", "give at least one, or leave the stage out",
                "capture plan");
  }
  std::vector<Result<void>> checks = {
      inRange("the number of rows of stage '" + title + "'", stage.rows, isSweep(stage) ? 10 : 1, mostRows, ""),
      inRange("the time between rows of stage '" + title + "'", stage.rowS, 0.001, longestS, " s")};
  for (const double fieldT : stage.fieldsT) {
    checks.push_back(inRange("a field of stage '" + title + "'", fieldT, -largestFieldT, largestFieldT, " T"));
  }
  for (const double probeC : stage.probeC) {
    checks.push_back(inRange("a temperature of stage '" + title + "'", probeC, coldestC, hottestC, " °C"));
  }
  for (const double electronicsC : stage.electronicsC) {
    checks.push_back(inRange("a temperature of stage '" + title + "'", electronicsC, coldestC, hottestC, " °C"));
  }
  if (isSweep(stage)) {
    checks.push_back(inRange("the lowest temperature of stage '" + title + "'", stage.lowC, coldestC, hottestC, " °C"));
    checks.push_back(
        inRange("the highest temperature of stage '" + title + "'", stage.highC, stage.lowC + 1.0, hottestC, " °C"));
    checks.push_back(inRange("the number of cycles of stage '" + title + "'", stage.cycles, 1, mostCycles, ""));
  }
  const auto failed = std::find_if(checks.begin(), checks.end(), [](const auto& check) { return !check; });
  return failed == checks.end() ? Result<void>() : *failed;
}

} // namespace

bool isProbeSweep(const FieldStage& stage) {
  return stage.step == CampaignStep::ProbeTemperature || stage.step == CampaignStep::Offset ||
         stage.step == CampaignStep::Sensitivity;
}

bool isElectronicsSweep(const FieldStage& stage) {
  return stage.step == CampaignStep::Electronics || stage.step == CampaignStep::ElectronicsSensitivity;
}

bool needsReference(const FieldStage& stage) { return placementOf(stage) != ProbePlacement::ZeroChamber; }

ProbePlacement placementOf(const FieldStage& stage) {
  if (stage.orientation) {
    return static_cast<ProbePlacement>(*stage.orientation);
  }
  return stage.axis ? static_cast<ProbePlacement>(2 * static_cast<int>(*stage.axis)) : ProbePlacement::ZeroChamber;
}

double sweepC(const FieldStage& stage, int row) {
  const double turn = 2.0 * std::numbers::pi * stage.cycles * row / stage.rows;
  return stage.lowC + (stage.highC - stage.lowC) * 0.5 * (1.0 - std::cos(turn));
}

std::vector<FieldPoint> plannedPoints(const FieldStage& stage) {
  std::vector<FieldPoint> points;
  const auto add = [&points](double fieldT, std::optional<double> probeC, std::optional<double> electronicsC) {
    points.push_back(
        {.index = static_cast<int>(points.size()), .fieldT = fieldT, .probeC = probeC, .electronicsC = electronicsC});
  };
  if (placementOf(stage) == ProbePlacement::ZeroChamber) {
    add(0.0, std::nullopt, std::nullopt);
  } else if (stage.probeC.empty() || isSweep(stage)) {
    for (const double fieldT : stage.fieldsT) {
      add(fieldT, std::nullopt, std::nullopt);
    }
  } else {
    for (std::size_t i = 0; i < stage.probeC.size(); ++i) {
      const auto& electronics = stage.electronicsC;
      for (const double fieldT : stage.fieldsT) {
        add(fieldT, stage.probeC[i],
            electronics.empty() ? std::nullopt : std::optional(electronics[i % electronics.size()]));
      }
    }
  }
  return points;
}

std::string stageTitle(const FieldStage& stage) {
  std::string title(field::stepName(stage.step));
  if (stage.orientation) {
    title += ", " + std::string(field::orientationName(*stage.orientation));
  } else if (stage.axis) {
    title += ", " + std::string(field::axisName(*stage.axis));
  }
  return title;
}

std::string placementInstruction(ProbePlacement placement) {
  if (placement == ProbePlacement::ZeroChamber) {
    return "put the probe into the zero-field chamber";
  }
  return "place the probe with its " + std::string(field::orientationName(static_cast<field::Orientation>(placement))) +
         " axis along the field";
}

std::string stagePurpose(const FieldStage& stage) {
  constexpr std::array<const char*, 8> purposes = {
      "Plateaus over the whole range for the polynomial of this axis: everything else rests on it.",
      "Turns ohms of the PT100 into degrees; without it nothing is corrected for the probe's temperature.",
      "Drift of the zero with the probe's temperature; without it a reading drifts by tens of microtesla a degree.",
      "Sensitivity over the probe's temperature; without it a reading of 2 T drifts by about 0.3 mT a degree.",
      "Drift of the zero with the electronics' temperature; without it a few microtesla a degree stay.",
      "Sensitivity over the electronics' temperature, which the paper leaves open; costs about 0.002 % a degree.",
      "Angles between the axes: all six orientations together; without them up to 2 % of a cross field stays.",
      "Readings that nothing is fitted to: what the calibration is worth, before and after each block."};
  return purposes.at(field::indexOf(stage.step));
}

FieldPlan makeFieldPlan(const FieldPlanShape& shape) {
  FieldPlan plan;
  plan.settleS = shape.settleS.value_or(plan.settleS);
  plan.temperatureSettleS = shape.temperatureSettleS.value_or(plan.temperatureSettleS);
  plan.lockTimeoutS = shape.lockTimeoutS.value_or(plan.lockTimeoutS);
  std::vector<double> scale;
  std::vector<double> coarse;
  for (int i = -40; i <= 40; ++i) {
    const double fieldT = i * 0.05;
    if (std::abs(fieldT) >= smallestLockT) {
      scale.push_back(fieldT);
      if (i % 4 == 0) {
        coarse.push_back(fieldT);
      }
    }
  }
  const std::vector<double> plateaus = shape.fieldsT.value_or(scale);
  const auto wanted = [](const auto& list, auto item) {
    return list.empty() || std::find(list.begin(), list.end(), item) != list.end();
  };
  const auto add = [&](FieldStage stage) {
    if (!wanted(shape.steps, stage.step) || (stage.axis && !wanted(shape.axes, *stage.axis)) ||
        (stage.orientation && !wanted(shape.axes, field::axisOf(*stage.orientation)))) {
      return;
    }
    stage.rowS = shape.rowS.value_or(stage.rowS);
    stage.rows = (isSweep(stage) ? shape.sweepRows : shape.rows).value_or(stage.rows);
    if (isSweep(stage)) {
      stage.lowC = shape.lowC.value_or(stage.lowC);
      stage.highC = shape.highC.value_or(stage.highC);
    }
    if (!stage.probeC.empty() && (shape.lowC || shape.highC)) {
      const double low = shape.lowC.value_or(stage.probeC.front());
      const double high = shape.highC.value_or(stage.probeC.back());
      for (std::size_t i = 0; i < stage.probeC.size(); ++i) {
        stage.probeC[i] = low + (high - low) * static_cast<double>(i) / static_cast<double>(stage.probeC.size() - 1);
      }
    }
    plan.stages.push_back(std::move(stage));
  };
  const auto stageOf = [](CampaignStep step, std::optional<Axis> axis) {
    FieldStage stage;
    stage.step = step;
    stage.axis = axis;
    return stage;
  };
  const auto sweepOf = [&stageOf](CampaignStep step, std::optional<Axis> axis, std::vector<double> fieldsT, double lowC,
                                  double highC, int rows) {
    FieldStage stage = stageOf(step, axis);
    stage.fieldsT = std::move(fieldsT);
    stage.lowC = lowC;
    stage.highC = highC;
    stage.rows = rows;
    return stage;
  };
  for (const Axis axis : field::allAxes) {
    FieldStage stage = stageOf(CampaignStep::Nonlinearity, axis);
    stage.fieldsT = plateaus;
    add(stage);
  }
  FieldStage probe = sweepOf(CampaignStep::ProbeTemperature, std::nullopt, {}, 14.0, 34.0, 800);
  probe.cycles = 2;
  add(probe);
  add(sweepOf(CampaignStep::Offset, std::nullopt, {}, 19.0, 37.0, 500));
  for (const Axis axis : field::allAxes) {
    add(sweepOf(CampaignStep::Sensitivity, axis, {0.3, -0.3, 1.0, -1.0, 1.6, -1.6}, 17.0, 31.0, 240));
  }
  add(sweepOf(CampaignStep::Electronics, std::nullopt, {}, 17.0, 34.0, 400));
  for (const Axis axis : field::allAxes) {
    add(sweepOf(CampaignStep::ElectronicsSensitivity, axis, {-1.6, -0.3, 0.3, 1.6}, 17.0, 34.0, 160));
  }
  for (const field::Orientation orientation : field::allOrientations) {
    FieldStage stage = stageOf(CampaignStep::Orientation, std::nullopt);
    stage.orientation = orientation;
    stage.fieldsT = {0.5, 1.0, 1.5};
    stage.rows = 30;
    add(stage);
  }
  for (const Axis axis : field::allAxes) {
    FieldStage stage = stageOf(CampaignStep::Verification, axis);
    stage.fieldsT = coarse;
    stage.probeC = {18.0, 21.0, 24.0, 27.0, 31.0};
    stage.electronicsC = {24.0, 31.0, 19.0, 28.0, 21.0}; // together with the probe's they tell the blocks apart
    stage.rows = 6;
    add(stage);
  }
  return plan;
}

Result<void> checkPlan(const FieldPlan& plan) {
  if (std::all_of(plan.stages.begin(), plan.stages.end(), [](const auto& stage) { return stage.skipped; })) {
    return fail(ErrorKind::Usage, "the plan has no stage to measure", "choose at least one", "capture plan");
  }
  for (const auto& checked :
       {inRange("the settling time", plan.settleS, 0.0, longestS, " s"),
        inRange("the settling time of temperatures", plan.temperatureSettleS, 0.0, longestS, " s"),
        inRange("the time to wait for lock", plan.lockTimeoutS, 0.1, longestS, " s"),
        inRange("the number of retries", plan.retries, 0, mostRepeats, ""),
        inRange("the reference temperature", plan.referenceTemperatureC, coldestC, hottestC, " °C")}) {
    if (!checked) {
      return checked;
    }
  }
  for (const FieldStage& stage : plan.stages) {
    if (auto checked = checkStage(stage); !checked) {
      return checked;
    }
  }
  return {};
}

double expectedS(const FieldPlan& plan, const FieldStage& stage) {
  double seconds = 0.0;
  std::optional<double> before = plan.referenceTemperatureC;
  for (const FieldPoint& point : plannedPoints(stage)) {
    const double starts = isSweep(stage) ? stage.lowC : point.probeC.value_or(plan.referenceTemperatureC);
    seconds += plan.settleS + stage.rows * stage.rowS + (before != starts ? plan.temperatureSettleS : 0.0);
    before = starts;
  }
  return seconds;
}

double expectedS(const FieldPlan& plan) {
  double seconds = 0.0;
  for (const FieldStage& stage : plan.stages) {
    seconds += stage.skipped ? 0.0 : expectedS(plan, stage);
  }
  return seconds;
}

} // namespace straightedge::devices
