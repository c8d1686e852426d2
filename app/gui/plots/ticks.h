// Positions and labels of ticks. Labels stay readable where a range is tiny against its offset: "1 + 1e-9·sin" gets
// labels of the deviation and a remark "× 10⁻⁹ + 1".
#pragma once

#include "app/gui/plots/axis_scale.h"

#include <QList>
#include <QString>

#include <functional>
#include <optional>

namespace straightedge::gui {

struct Ticks {
  QList<double> positions; ///< data units, ascending, within the scale
  QStringList labels;      ///< one per position; empty text = tick without label
  QList<double> minor;     ///< positions between, without labels
  QString remark;          ///< factor and offset of all labels, e.g. "× 10⁻⁹ + 1"; usually empty
};

/// Ticks in steps of 1, 2 or 5 · 10ᵏ, at most `maximumCount` (≥ 2) of them. `preferredStep`, e.g. 45 for angles: the
/// step is a multiple (1, 2, 4, 8) or a whole part (1/3, 1/9, 1/45) of it as long as that gives at least 3 ticks.
Ticks linearTicks(const AxisScale& scale, int maximumCount, std::optional<double> preferredStep = {});

/// Decades (every n-th where there are many), 1-2-5 where there are few, linear steps within less than one decade.
Ticks logarithmicTicks(const AxisScale& scale, int maximumCount);

/// As many ticks as fit on `length` (pixels) when labels need `extent(label)` along the axis and `gap` between them.
Ticks fittingTicks(const AxisScale& scale, double length, double gap, std::optional<double> preferredStep,
                   const std::function<double(const QString&)>& extent);

/// A value for people: only digits that can be told apart on an axis of this scale, no trailing zeros.
QString readableValue(double value, const AxisScale& scale);

/// "10⁻⁶"
QString powerOfTen(int exponent);

} // namespace straightedge::gui
