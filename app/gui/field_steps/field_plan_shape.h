// A field plan as the few numbers it was made from, for the form that edits it.
#pragma once

#include "devices/capture/field_plan.h"

#include <optional>
#include <vector>

namespace straightedge::gui {

struct ShapedPlan {
  devices::FieldPlanShape shape;
  bool exact = true; ///< makeFieldPlan() of the shape gives the plan; else it comes near
};

/// What a plan's stages have in common. Which of them are left out is not part of the shape.
ShapedPlan shapeOf(const devices::FieldPlan& plan);

/// The plan of a shape; what no shape holds stays as it was `before`: stages that are left out, reference temperature.
devices::FieldPlan planOfShape(const devices::FieldPlanShape& shape, const devices::FieldPlan& before);

/// Plateaus over ±`largest` in even steps, without those too small for an NMR; ascending.
std::vector<double> evenFieldsT(double largestT, double stepT);

/// Largest field and smallest step of a list.
struct FieldSpan {
  double largestT = 0.0;
  double stepT = 0.0;
};
FieldSpan spanOf(const std::vector<double>& fieldsT);

} // namespace straightedge::gui
