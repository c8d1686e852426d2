// The plan of a field campaign as a form: what all its stages are made from.
#pragma once

#include "app/gui/field_steps/field_plan_shape.h"

#include <QWidget>

#include <array>
#include <functional>

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QSpinBox;

namespace straightedge::gui {

class FieldPlanForm : public QWidget {
  Q_OBJECT
public:
  explicit FieldPlanForm(QWidget* parent = nullptr);

  void setPlan(const devices::FieldPlan& plan); ///< without planEdited()
  const devices::FieldPlan& plan() const { return m_plan; }

signals:
  void planEdited(); ///< by the user

private:
  QWidget* makeSteps();
  QWidget* makeAxes();
  QWidget* makeTemperatures();
  void connectAll();
  void edit(const std::function<void(devices::FieldPlanShape&)>& change);
  void editChoice(QCheckBox* changed);

  devices::FieldPlan m_plan;
  devices::FieldPlanShape m_shape; ///< that the plan was made from; what is not edited stays
  bool m_setting = false;
  std::array<QCheckBox*, 8> m_steps = {};
  std::array<QCheckBox*, 3> m_axes = {};
  QDoubleSpinBox* m_largest;
  QDoubleSpinBox* m_step;
  QSpinBox* m_rows;
  QSpinBox* m_sweepRows;
  QCheckBox* m_ownRange = nullptr;
  QDoubleSpinBox* m_low;
  QDoubleSpinBox* m_high;
  QDoubleSpinBox* m_rowS;
  QDoubleSpinBox* m_settle;
  QDoubleSpinBox* m_temperatureSettle;
  QDoubleSpinBox* m_lockTimeout;
  QLabel* m_elsewhere; ///< says that no form gives this plan
};

} // namespace straightedge::gui
