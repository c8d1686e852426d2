#include "app/gui/steps/plan_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QSpinBox>

namespace straightedge::gui {

namespace {

constexpr double usualRateHz = 1000.0;

QSpinBox* counter(QWidget* parent, const QString& name, int least, int most, int step) {
  auto* box = new QSpinBox(parent);
  box->setObjectName(name);
  box->setRange(least, most);
  box->setSingleStep(step);
  box->setGroupSeparatorShown(true);
  return box;
}

QDoubleSpinBox* measure(QWidget* parent, const QString& name, double least, double most, int decimals,
                        const QString& unit) {
  auto* box = new QDoubleSpinBox(parent);
  box->setObjectName(name);
  box->setDecimals(decimals);
  box->setRange(least, most);
  box->setSuffix(unit);
  box->setGroupSeparatorShown(true);
  return box;
}

} // namespace

PlanForm::PlanForm(QWidget* parent)
    : QWidget(parent), m_form(new QFormLayout(this)), m_mode(new QComboBox(this)),
      m_points(counter(this, QStringLiteral("pointsPerTurn"), 8, 36000, 8)),
      m_turns(counter(this, QStringLiteral("turns"), 1, 1000, 1)),
      m_bothDirections(new QCheckBox(tr("Rising and falling"), this)),
      m_start(measure(this, QStringLiteral("startAngle"), -3600.0, 3600.0, 2, QStringLiteral("°"))),
      m_settle(measure(this, QStringLiteral("settling"), 0.0, 600.0, 3, tr(" s"))),
      m_averages(counter(this, QStringLiteral("averages"), 1, 10000, 1)),
      m_rate(measure(this, QStringLiteral("sampleRate"), 1.0, 1e6, 0, tr(" Hz"))) {
  m_mode->setObjectName(QStringLiteral("captureMode"));
  m_mode->addItem(tr("Point by point"), false);
  m_mode->addItem(tr("Free running"), true);
  m_mode->setToolTip(tr("Point by point: the shaft stops at each angle and settles.\n"
                        "Free running: readings are taken at a fixed rate while the shaft turns."));
  m_bothDirections->setObjectName(QStringLiteral("bothDirections"));
  m_bothDirections->setToolTip(tr("Both directions are needed to see hysteresis"));
  m_points->setToolTip(
      tr("Evenly spaced. While free running a point is the sector up to the next one: the least that can "
         "be measured again."));
  m_settle->setSingleStep(0.01);
  m_settle->setToolTip(tr("Wait at each point before reading"));
  m_averages->setToolTip(tr("Readings at each point; every one is kept, so that noise can be told"));
  m_rate->setSingleStep(1000.0);

  m_form->setContentsMargins(0, 0, 0, 0);
  m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  m_form->addRow(tr("Capture"), m_mode);
  m_form->addRow(tr("Points per turn"), m_points);
  m_form->addRow(tr("Turns"), m_turns);
  m_form->addRow(tr("Directions"), m_bothDirections);
  m_form->addRow(tr("Start at"), m_start);
  m_form->addRow(tr("Settling"), m_settle);
  m_form->addRow(tr("Readings per point"), m_averages);
  m_form->addRow(tr("Sample rate"), m_rate);

  const auto edited = [this] {
    showMode();
    if (!m_setting) {
      emit planEdited();
    }
  };
  connect(m_mode, &QComboBox::currentIndexChanged, this, edited);
  connect(m_bothDirections, &QCheckBox::toggled, this, edited);
  for (QSpinBox* box : {m_points, m_turns, m_averages}) {
    box->setKeyboardTracking(false); // a number half typed is not a plan
    connect(box, &QSpinBox::valueChanged, this, edited);
  }
  for (QDoubleSpinBox* box : {m_start, m_settle, m_rate}) {
    box->setKeyboardTracking(false);
    connect(box, &QDoubleSpinBox::valueChanged, this, edited);
  }
  setPlan({});
}

void PlanForm::setPlan(const devices::AnglePlan& plan) {
  m_setting = true;
  m_mode->setCurrentIndex(m_mode->findData(plan.sampleRateHz > 0.0));
  m_points->setValue(plan.pointsPerTurn);
  m_turns->setValue(plan.turns);
  m_bothDirections->setChecked(plan.bothDirections);
  m_start->setValue(plan.startDeg);
  m_settle->setValue(plan.settleS);
  m_averages->setValue(plan.averages);
  m_rate->setValue(plan.sampleRateHz > 0.0 ? plan.sampleRateHz : usualRateHz);
  m_setting = false;
  showMode();
}

devices::AnglePlan PlanForm::plan() const {
  devices::AnglePlan plan;
  plan.pointsPerTurn = m_points->value();
  plan.turns = m_turns->value();
  plan.bothDirections = m_bothDirections->isChecked();
  plan.startDeg = m_start->value();
  plan.settleS = m_settle->value();
  plan.averages = m_averages->value();
  plan.sampleRateHz = m_mode->currentData().toBool() ? m_rate->value() : 0.0;
  return plan;
}

void PlanForm::showMode() {
  const bool freeRunning = m_mode->currentData().toBool();
  const auto setRowShown = [this](QWidget* field, bool shown) {
    field->setVisible(shown);
    m_form->labelForField(field)->setVisible(shown);
  };
  setRowShown(m_settle, !freeRunning);
  setRowShown(m_averages, !freeRunning);
  setRowShown(m_rate, freeRunning);
}

} // namespace straightedge::gui
