// Settings of the simulated field bench as a form.
#pragma once

#include "devices/simulated/simulated_field_bench.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QSpinBox;

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
  QComboBox* m_speed;
  QSpinBox* m_seed;
};

} // namespace straightedge::gui
