// The capture plan as a form.
#pragma once

#include "devices/capture/angle_plan.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QSpinBox;

namespace straightedge::gui {

class PlanForm : public QWidget {
  Q_OBJECT
public:
  explicit PlanForm(QWidget* parent = nullptr);

  void setPlan(const devices::AnglePlan& plan); ///< without planEdited()
  devices::AnglePlan plan() const;

signals:
  void planEdited(); ///< by the user

private:
  void showMode();

  QFormLayout* m_form;
  QComboBox* m_mode;
  QSpinBox* m_points;
  QSpinBox* m_turns;
  QCheckBox* m_bothDirections;
  QDoubleSpinBox* m_start;
  QDoubleSpinBox* m_settle;
  QSpinBox* m_averages;
  QDoubleSpinBox* m_rate;
  bool m_setting = false;
};

} // namespace straightedge::gui
