#include "app/gui/field_steps/field_plan_form.h"

#include "app/gui/figures/field_figure_parts.h"
#include "app/gui/figures/field_words.h"
#include "core/field/names.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>

namespace straightedge::gui {

namespace {

// Offered where the sweeps get a range of their own.
constexpr double usualLowC = 17.0;
constexpr double usualHighC = 31.0;

QDoubleSpinBox* fieldPlanNumber(QWidget* parent, const QString& name, double least, double most, int decimals,
                                double step, const QString& unit) {
  auto* box = new QDoubleSpinBox(parent);
  box->setObjectName(name);
  box->setDecimals(decimals);
  box->setRange(least, most);
  box->setSingleStep(step);
  box->setSuffix(unit);
  box->setGroupSeparatorShown(true);
  box->setKeyboardTracking(false); // a number half typed is not a plan
  return box;
}

/// 0 stands for "every stage as published".
QSpinBox* fieldPlanRows(QWidget* parent, const QString& name) {
  auto* box = new QSpinBox(parent);
  box->setObjectName(name);
  box->setRange(0, 1000000);
  box->setSingleStep(5);
  box->setSpecialValueText(FieldPlanForm::tr("as published"));
  box->setGroupSeparatorShown(true);
  box->setKeyboardTracking(false);
  return box;
}

template <typename Boxes>
auto isAnyChecked(const Boxes& boxes) {
  return std::ranges::any_of(boxes, [](const QCheckBox* box) { return box->isChecked(); });
}

/// Those that are checked; empty where all are: so a shape says it.
template <typename All, typename Boxes>
auto checkedOf(const All& all, const Boxes& boxes) {
  std::vector<typename All::value_type> chosen;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (boxes[i]->isChecked()) {
      chosen.push_back(all[i]);
    }
  }
  if (chosen.size() == all.size()) {
    chosen.clear();
  }
  return chosen;
}

template <typename All, typename Boxes, typename Chosen>
void checkChosen(const All& all, const Boxes& boxes, const Chosen& chosen) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    boxes[i]->setChecked(chosen.empty() || std::ranges::find(chosen, all[i]) != chosen.end());
  }
}

} // namespace

FieldPlanForm::FieldPlanForm(QWidget* parent)
    : QWidget(parent), m_plan(devices::makeFieldPlan()),
      m_largest(fieldPlanNumber(this, QStringLiteral("largestField"), 0.05, 30.0, 3, 0.1, tr(" T"))),
      m_step(fieldPlanNumber(this, QStringLiteral("fieldStep"), 0.001, 30.0, 3, 0.05, tr(" T"))),
      m_rows(fieldPlanRows(this, QStringLiteral("plateauRows"))),
      m_sweepRows(fieldPlanRows(this, QStringLiteral("sweepRows"))),
      m_low(fieldPlanNumber(this, QStringLiteral("lowTemperature"), -50.0, 150.0, 1, 1.0, tr(" °C"))),
      m_high(fieldPlanNumber(this, QStringLiteral("highTemperature"), -50.0, 150.0, 1, 1.0, tr(" °C"))),
      m_rowS(fieldPlanNumber(this, QStringLiteral("rowTime"), 0.001, 86400.0, 3, 0.1, tr(" s"))),
      m_settle(fieldPlanNumber(this, QStringLiteral("fieldSettling"), 0.0, 86400.0, 1, 1.0, tr(" s"))),
      m_temperatureSettle(
          fieldPlanNumber(this, QStringLiteral("temperatureSettling"), 0.0, 86400.0, 0, 10.0, tr(" s"))),
      m_lockTimeout(fieldPlanNumber(this, QStringLiteral("lockTimeout"), 0.1, 86400.0, 1, 5.0, tr(" s"))),
      m_elsewhere(new QLabel(this)) {
  m_largest->setPrefix(QStringLiteral("±"));
  m_largest->setToolTip(tr("Of the nonlinearity's plateaus; what an NMR cannot lock on is left out"));
  m_step->setToolTip(tr("From plateau to plateau of the nonlinearity"));
  m_rows->setToolTip(tr("Rows with a locked reference; as published: 10, orientations 30, verification 6"));
  m_sweepRows->setToolTip(tr("Of one sweep of temperature, at least 10; as published: 160 to 800 from stage to stage"));
  m_settle->setToolTip(tr("Wait after the field was set"));
  m_temperatureSettle->setToolTip(tr("Wait after probe or electronics were sent to another temperature"));
  m_lockTimeout->setToolTip(tr("A plateau without a locked row is given up after so long"));
  m_elsewhere->setText(tr("This plan was made elsewhere and is measured as it is. Changing anything here makes a new "
                          "one from these numbers."));
  m_elsewhere->setWordWrap(true);
  m_elsewhere->setForegroundRole(QPalette::PlaceholderText);

  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(m_elsewhere);
  form->addRow(makeSteps());
  form->addRow(tr("Axes"), makeAxes());
  form->addRow(tr("Largest field"), m_largest);
  form->addRow(tr("In steps of"), m_step);
  form->addRow(tr("Rows of a plateau"), m_rows);
  form->addRow(tr("Rows of a sweep"), m_sweepRows);
  form->addRow(tr("Sweeps"), makeTemperatures());
  form->addRow(tr("Time per row"), m_rowS);
  form->addRow(tr("Field settles in"), m_settle);
  form->addRow(tr("Temperature in"), m_temperatureSettle);
  form->addRow(tr("Wait for lock"), m_lockTimeout);
  connectAll();
  setPlan(m_plan);
}

QWidget* FieldPlanForm::makeSteps() {
  auto* box = new QWidget(this);
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(2);
  for (const field::CampaignStep step : field::allSteps) {
    const auto place = field::indexOf(step);
    m_steps.at(place) = new QCheckBox(stepTitle(step), box);
    m_steps.at(place)->setObjectName(QStringLiteral("step%1").arg(place));
    devices::FieldStage example;
    example.step = step;
    m_steps.at(place)->setToolTip(QString::fromStdString(devices::stagePurpose(example)));
    grid->addWidget(m_steps.at(place), static_cast<int>(place / 2), static_cast<int>(place % 2));
  }
  return box;
}

QWidget* FieldPlanForm::makeAxes() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  for (const field::Axis axis : field::allAxes) {
    const auto place = field::indexOf(axis);
    m_axes.at(place) = new QCheckBox(axisLetter(axis), box);
    m_axes.at(place)->setObjectName(QStringLiteral("axis_%1").arg(axisLetter(axis)));
    row->addWidget(m_axes.at(place));
  }
  row->addStretch(1);
  return box;
}

QWidget* FieldPlanForm::makeTemperatures() {
  auto* box = new QWidget(this);
  auto* rows = new QVBoxLayout(box);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(2);
  m_ownRange = new QCheckBox(tr("one range for all"), box);
  m_ownRange->setObjectName(QStringLiteral("ownRange"));
  m_ownRange->setToolTip(tr("Otherwise each kind of sweep has its published range"));
  rows->addWidget(m_ownRange);
  auto* range = new QHBoxLayout;
  range->addWidget(m_low, 1);
  range->addWidget(new QLabel(tr("to"), box));
  range->addWidget(m_high, 1);
  rows->addLayout(range);
  return box;
}

void FieldPlanForm::connectAll() {
  for (QCheckBox* box : m_steps) {
    connect(box, &QCheckBox::toggled, this, [this, box] { editChoice(box); });
  }
  for (QCheckBox* box : m_axes) {
    connect(box, &QCheckBox::toggled, this, [this, box] { editChoice(box); });
  }
  const auto fields = [this] {
    edit([this](auto& shape) { shape.fieldsT = evenFieldsT(m_largest->value(), m_step->value()); });
  };
  connect(m_largest, &QDoubleSpinBox::valueChanged, this, fields);
  connect(m_step, &QDoubleSpinBox::valueChanged, this, fields);
  const auto count = [](int rows) { return rows > 0 ? std::optional(rows) : std::nullopt; };
  connect(m_rows, &QSpinBox::valueChanged, this,
          [this, count](int rows) { edit([&](auto& shape) { shape.rows = count(rows); }); });
  connect(m_sweepRows, &QSpinBox::valueChanged, this,
          [this, count](int rows) { edit([&](auto& shape) { shape.sweepRows = count(rows); }); });
  const auto range = [this] {
    edit([this](auto& shape) {
      shape.lowC = m_ownRange->isChecked() ? std::optional(m_low->value()) : std::nullopt;
      shape.highC = m_ownRange->isChecked() ? std::optional(m_high->value()) : std::nullopt;
    });
  };
  connect(m_ownRange, &QCheckBox::toggled, this, range);
  connect(m_low, &QDoubleSpinBox::valueChanged, this, range);
  connect(m_high, &QDoubleSpinBox::valueChanged, this, range);
  using Member = std::optional<double> devices::FieldPlanShape::*;
  for (const auto& [box, member] : {std::pair<QDoubleSpinBox*, Member>{m_rowS, &devices::FieldPlanShape::rowS},
                                    {m_settle, &devices::FieldPlanShape::settleS},
                                    {m_temperatureSettle, &devices::FieldPlanShape::temperatureSettleS},
                                    {m_lockTimeout, &devices::FieldPlanShape::lockTimeoutS}}) {
    connect(box, &QDoubleSpinBox::valueChanged, this,
            [this, to = member](double value) { edit([&](auto& shape) { shape.*to = value; }); });
  }
}

void FieldPlanForm::editChoice(QCheckBox* changed) {
  if (m_setting) {
    return;
  }
  if (!isAnyChecked(m_steps) || !isAnyChecked(m_axes)) {
    const QSignalBlocker quiet(changed);
    changed->setChecked(true); // a campaign of nothing is none
    return;
  }
  edit([this](auto& shape) {
    shape.steps = checkedOf(field::allSteps, m_steps);
    shape.axes = checkedOf(field::allAxes, m_axes);
  });
}

void FieldPlanForm::edit(const std::function<void(devices::FieldPlanShape&)>& change) {
  if (m_setting) {
    return;
  }
  change(m_shape);
  setPlan(planOfShape(m_shape, m_plan));
  emit planEdited();
}

void FieldPlanForm::setPlan(const devices::FieldPlan& plan) {
  m_setting = true;
  m_plan = plan;
  const ShapedPlan shaped = shapeOf(plan);
  m_shape = shaped.shape;
  m_elsewhere->setVisible(!shaped.exact);
  checkChosen(field::allSteps, m_steps, m_shape.steps);
  checkChosen(field::allAxes, m_axes, m_shape.axes);
  const auto straight = std::ranges::find(plan.stages, field::CampaignStep::Nonlinearity, &devices::FieldStage::step);
  if (straight != plan.stages.end()) {
    const FieldSpan span = spanOf(straight->fieldsT);
    m_largest->setValue(span.largestT);
    m_step->setValue(span.stepT);
  }
  m_largest->setEnabled(straight != plan.stages.end());
  m_step->setEnabled(straight != plan.stages.end());
  m_rows->setValue(m_shape.rows.value_or(0));
  m_sweepRows->setValue(m_shape.sweepRows.value_or(0));
  const bool ownRange = m_shape.lowC || m_shape.highC;
  m_ownRange->setChecked(ownRange);
  m_low->setValue(m_shape.lowC.value_or(usualLowC));
  m_high->setValue(m_shape.highC.value_or(usualHighC));
  m_low->setEnabled(ownRange);
  m_high->setEnabled(ownRange);
  m_rowS->setValue(plan.stages.empty() ? devices::FieldStage{}.rowS : plan.stages.front().rowS);
  m_settle->setValue(plan.settleS);
  m_temperatureSettle->setValue(plan.temperatureSettleS);
  m_lockTimeout->setValue(plan.lockTimeoutS);
  m_setting = false;
}

} // namespace straightedge::gui
