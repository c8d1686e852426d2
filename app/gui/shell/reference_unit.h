// The quantity that a kind of calibration measures, where its uncertainty is asked for.
#pragma once

#include <QString>

namespace straightedge::gui {

struct ReferenceUnit {
  QString symbol;       ///< "°", "T"
  QString name;         ///< in a sentence: "degrees", "tesla"
  double largest = 0.0; ///< an uncertainty beyond is a mistake
};

} // namespace straightedge::gui
