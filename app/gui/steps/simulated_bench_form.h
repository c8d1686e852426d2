// Settings of the simulated bench as a form.
#pragma once

#include "app/gui/steps/simulation_rows.h"
#include "devices/simulated/simulated_angle_bench.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QSpinBox;

namespace straightedge::gui {

class SimulatedBenchForm : public QWidget {
  Q_OBJECT
public:
  explicit SimulatedBenchForm(QWidget* parent = nullptr);

  void setSettings(const devices::SimulatedAngleSettings& settings);
  devices::SimulatedAngleSettings settings() const;

private:
  devices::SimulatedAngleSettings m_base; ///< what the form does not show
  QComboBox* m_geometry;
  QDoubleSpinBox* m_mounting;
  QDoubleSpinBox* m_noise;
  QDoubleSpinBox* m_hysteresis;
  QSpinBox* m_bits;
  QCheckBox* m_decreasing;
  std::optional<SimulationRows> m_simulation; ///< the last rows
};

} // namespace straightedge::gui
