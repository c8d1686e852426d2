// Settings of the simulated field bench as a form.
#pragma once

#include "app/gui/steps/simulation_rows.h"
#include "devices/simulated/simulated_field_bench.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;

namespace straightedge::gui {

class SimulatedFieldForm : public QWidget {
  Q_OBJECT
public:
  explicit SimulatedFieldForm(QWidget* parent = nullptr);

  void setSettings(const devices::SimulatedFieldSettings& settings);
  devices::SimulatedFieldSettings settings() const;

private:
  devices::SimulatedFieldSettings m_base; ///< what the form does not show
  QDoubleSpinBox* m_noise;
  QDoubleSpinBox* m_probeLag;
  QDoubleSpinBox* m_lockThreshold;
  QDoubleSpinBox* m_room;
  QCheckBox* m_planarHall;
  QComboBox* m_placing;
  std::optional<SimulationRows> m_simulation; ///< the last rows
};

} // namespace straightedge::gui
