// Every figure of one angle calibration, in the order of the road, with a file name and a caption each: what Export
// writes as pictures and the report prints.
#pragma once

#include "app/gui/figures/named_figure.h"
#include "app/gui/plots/plot_spec.h"
#include "core/angle/calibration.h"
#include "core/angle/comparison.h"
#include "core/angle/verification.h"

#include <QList>
#include <QString>

#include <memory>
#include <optional>

namespace straightedge::gui {

/// What there is of a calibration. `calibration` is needed; the rest may be missing, and its figures with it: a
/// calibration read from a file has no run unless its sweep is at hand.
struct AngleResults {
  angle::AngleCalibration calibration;
  std::shared_ptr<const angle::Sweep> sweep;
  std::shared_ptr<const angle::CalibrationRun> run;
  std::shared_ptr<const angle::Comparison> comparison;
  std::optional<angle::VerificationReport> verification;
  std::optional<angle::ModelName> selected;
  std::optional<double> targetErrorDeg;
  std::optional<int> budgetEntries;
  std::optional<int> bits;
};

/// Cheap: plots are made only when asked for. `results` is shared with them.
QList<NamedFigure> angleFigures(const std::shared_ptr<const AngleResults>& results);

/// Segments and table entries of the figures that show one size: those of the first such model, otherwise 32 and 64.
int segmentsShown(const angle::AngleCalibration& calibration);
int entriesShown(const angle::AngleCalibration& calibration);

} // namespace straightedge::gui
