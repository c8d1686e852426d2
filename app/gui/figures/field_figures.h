// Every figure of one field calibration, in the order of the chain, with a file name and a caption each: what Export
// writes as pictures and the report prints.
#pragma once

#include "app/gui/figures/named_figure.h"
#include "core/field/calibration.h"
#include "core/field/campaign.h"
#include "core/field/field_fit.h"
#include "core/field/storage.h"
#include "core/field/verification.h"

#include <QList>

#include <memory>
#include <optional>

namespace straightedge::gui {

/// What there is of a field calibration. `calibration` is needed; the rest may be missing, and its figures with it: a
/// calibration read from a file has no run unless its campaign is at hand.
struct FieldResults {
  field::FieldCalibration calibration;
  std::shared_ptr<const field::Campaign> campaign;
  std::shared_ptr<const field::FieldRun> run;
  std::shared_ptr<const field::StorageComparison> comparison;
  std::optional<field::LimitReport> verification; ///< against a limit; of a fresh campaign or the run's own rows
  bool verificationIsFresh = false;
};

/// Cheap: plots are made only when asked for. `results` is shared with them.
QList<NamedFigure> fieldFigures(const std::shared_ptr<const FieldResults>& results);

} // namespace straightedge::gui
