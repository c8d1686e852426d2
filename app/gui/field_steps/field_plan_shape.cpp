#include "app/gui/field_steps/field_plan_shape.h"

#include "core/field/names.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace straightedge::gui {

namespace {

using devices::FieldPlan;
using devices::FieldPlanShape;
using devices::FieldStage;

bool isSame(const FieldStage& one, const FieldStage& other) {
  return one.step == other.step && one.axis == other.axis && one.orientation == other.orientation;
}

std::optional<field::Axis> axisOfStage(const FieldStage& stage) {
  return stage.orientation ? std::optional(field::axisOf(*stage.orientation)) : stage.axis;
}

/// Those of `all` that some stage has, empty where every one is there: so a shape says it.
template <typename List, typename Has>
auto chosenOf(const List& all, const Has& has) {
  std::vector<typename List::value_type> chosen;
  std::ranges::copy_if(all, std::back_inserter(chosen), has);
  if (chosen.size() == all.size()) {
    chosen.clear();
  }
  return chosen;
}

/// The value that all these stages have where it is not what the shape without it gives; nothing where they differ.
template <typename T>
std::optional<T> commonValue(const FieldPlan& plan, const FieldPlan& without, bool (*counts)(const FieldStage&),
                             T FieldStage::* value) {
  std::optional<T> common;
  bool differs = plan.stages.size() != without.stages.size();
  for (std::size_t i = 0; i < plan.stages.size(); ++i) {
    if (!counts(plan.stages[i])) {
      continue;
    }
    if (common && *common != plan.stages[i].*value) {
      return std::nullopt;
    }
    common = plan.stages[i].*value;
    differs = differs || (i < without.stages.size() && without.stages[i].*value != plan.stages[i].*value);
  }
  return differs ? common : std::nullopt;
}

std::optional<double> unlessUsual(double value, double usual) {
  return value == usual ? std::nullopt : std::optional(value);
}

} // namespace

ShapedPlan shapeOf(const FieldPlan& plan) {
  ShapedPlan shaped;
  FieldPlanShape& shape = shaped.shape;
  const auto any = [&plan](const auto& has) { return std::ranges::any_of(plan.stages, has); };
  shape.steps = chosenOf(field::allSteps, [&](field::CampaignStep step) {
    return any([step](const FieldStage& stage) { return stage.step == step; });
  });
  if (any([](const FieldStage& stage) { return axisOfStage(stage).has_value(); })) {
    shape.axes = chosenOf(field::allAxes, [&](field::Axis axis) {
      return any([axis](const FieldStage& stage) { return axisOfStage(stage) == axis; });
    });
  }
  const FieldPlan usual;
  shape.settleS = unlessUsual(plan.settleS, usual.settleS);
  shape.temperatureSettleS = unlessUsual(plan.temperatureSettleS, usual.temperatureSettleS);
  shape.lockTimeoutS = unlessUsual(plan.lockTimeoutS, usual.lockTimeoutS);
  const FieldPlan without = devices::makeFieldPlan(shape);
  for (std::size_t i = 0; i < plan.stages.size() && i < without.stages.size(); ++i) {
    if (plan.stages[i].step == field::CampaignStep::Nonlinearity &&
        plan.stages[i].fieldsT != without.stages[i].fieldsT) {
      shape.fieldsT = plan.stages[i].fieldsT;
    }
  }
  const auto isPlateau = [](const FieldStage& stage) { return !devices::isSweep(stage); };
  const auto isAny = [](const FieldStage&) { return true; };
  shape.rows = commonValue<int>(plan, without, isPlateau, &FieldStage::rows);
  shape.sweepRows = commonValue<int>(plan, without, devices::isSweep, &FieldStage::rows);
  shape.lowC = commonValue<double>(plan, without, devices::isSweep, &FieldStage::lowC);
  shape.highC = commonValue<double>(plan, without, devices::isSweep, &FieldStage::highC);
  shape.rowS = commonValue<double>(plan, without, isAny, &FieldStage::rowS);
  shaped.exact = planOfShape(shape, plan) == plan;
  return shaped;
}

FieldPlan planOfShape(const FieldPlanShape& shape, const FieldPlan& before) {
  FieldPlan plan = devices::makeFieldPlan(shape);
  plan.referenceTemperatureC = before.referenceTemperatureC;
  plan.retries = before.retries;
  for (FieldStage& stage : plan.stages) {
    stage.skipped = std::ranges::any_of(
        before.stages, [&stage](const FieldStage& former) { return former.skipped && isSame(former, stage); });
  }
  return plan;
}

std::vector<double> evenFieldsT(double largestT, double stepT) {
  std::vector<double> fieldsT;
  const auto steps = static_cast<int>(std::floor(largestT / stepT + 1e-6));
  for (int i = -steps; i <= steps; ++i) {
    const double fieldT = i * stepT;
    if (std::abs(fieldT) >= devices::smallestLockT) {
      fieldsT.push_back(fieldT);
    }
  }
  return fieldsT;
}

FieldSpan spanOf(const std::vector<double>& fieldsT) {
  FieldSpan span;
  std::vector<double> sorted = fieldsT;
  std::ranges::sort(sorted);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    span.largestT = std::max(span.largestT, std::abs(sorted[i]));
    const double stepT = i > 0 ? sorted[i] - sorted[i - 1] : 0.0;
    if (stepT > 0.0 && (span.stepT == 0.0 || stepT < span.stepT)) {
      span.stepT = stepT;
    }
  }
  return span;
}

} // namespace straightedge::gui
