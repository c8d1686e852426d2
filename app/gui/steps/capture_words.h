// How the steps Capture of both kinds write times and counts.
#pragma once

#include <QString>

namespace straightedge::gui {

QString durationText(double seconds); ///< "less than 1 s", "12 s", "1 min 43 s", "5 h 20 min"
/// Thousands apart by a narrow space, whatever the user's locale: numbers read the same as in the plots.
QString countText(qint64 count);

} // namespace straightedge::gui
