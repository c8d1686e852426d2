// What the forms of all simulated benches end with: how fast time passes, and where the noise begins.
#pragma once

#include <cstdint>

class QComboBox;
class QFormLayout;
class QSpinBox;
class QString;

namespace straightedge::gui {

/// Two rows of a form that owns the widgets.
class SimulationRows {
public:
  /// `aboutSpeed`: tool tip.
  SimulationRows(QFormLayout& form, const QString& aboutSpeed);

  void set(bool realTime, std::uint64_t seed); ///< a seed beyond the box's range shows as its largest number
  bool realTime() const;
  std::uint64_t seed() const;

private:
  QComboBox* m_speed;
  QSpinBox* m_seed;
};

} // namespace straightedge::gui
