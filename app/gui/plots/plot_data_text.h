// The numbers behind a plot as a table for spreadsheets.
#pragma once

#include "app/gui/plots/plot_spec.h"

#include <QChar>
#include <QString>

namespace straightedge::gui {

/// Visible series as columns with a header line; series with the same x share its column, others bring their own.
/// Numbers read back to the same double; NaN is an empty cell.
QString dataAsText(const PlotSpec& spec, QChar separator);

} // namespace straightedge::gui
