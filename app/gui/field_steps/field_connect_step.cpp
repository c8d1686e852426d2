#include "app/gui/field_steps/field_connect_step.h"

#include "app/gui/bench/bench_console.h"
#include "app/gui/bench/bench_panel.h"
#include "app/gui/field_steps/simulated_field_form.h"
#include "app/gui/figures/field_figure_parts.h"
#include "app/gui/steps/connect_column.h"
#include "app/gui/steps/connect_wiring.h"
#include "app/gui/steps/notice_list.h"
#include "app/gui/steps/value_label.h"
#include "core/field/names.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace straightedge::gui {

namespace {
constexpr double largestSettableT = 30.0; // as in a plan
} // namespace

FieldConnectStep::FieldConnectStep(FieldStepContext context, QWidget* parent)
    : StepPage(parent), m_presenter(context.document, context.bench),
      m_realBench(context.jobs, {.kind = QStringLiteral("field"), .roles = fieldRoleSlots()}) {
  auto* page = new QVBoxLayout(this);
  m_notices = new NoticeList(this);
  page->addWidget(m_notices);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(16);
  page->addLayout(columns, 1);
  columns->addWidget(makeColumn());
  columns->addWidget(withConsole(makeLiveBox(), m_panel->console(), this), 1);

  connect(&m_presenter, &FieldConnectPresenter::connectionChanged, this, &FieldConnectStep::showConnection);
  connect(&m_presenter, &FieldConnectPresenter::readingChanged, this, &FieldConnectStep::showReading);
  connect(&m_presenter, &FieldConnectPresenter::problemChanged, this, &FieldConnectStep::showProblem);
  connect(&m_presenter, &FieldConnectPresenter::traceabilityChanged, this, &FieldConnectStep::showTraceability);
  connectInstruments();
  m_form->setSettings(m_presenter.simulatedSettings());
  showConnection();
  showReading();
}

void FieldConnectStep::connectInstruments() {
  wireInstruments(*this, m_presenter, m_realBench);
  connect(&m_realBench.opener(), &BenchOpener::rolesRead, this, &FieldConnectStep::takeRoles);
}

void FieldConnectStep::takeRoles() {
  using Role = devices::InstrumentRole;
  const BenchOpener& opener = m_realBench.opener();
  if (!m_presenter.usesInstruments(opener.bench().get())) {
    return;
  }
  const auto readingOf = [&](Role role) {
    const RoleState* state = opener.role(role);
    return state != nullptr && state->reading ? &*state->reading : nullptr;
  };
  const auto valueOf = [&](Role role) {
    const devices::RoleReading* reading = readingOf(role);
    return reading != nullptr && !reading->values.empty() ? std::optional(reading->values.front()) : std::nullopt;
  };
  const devices::RoleReading* probe = readingOf(Role::FieldProbe);
  if (probe == nullptr) {
    m_presenter.loseReading();
    return;
  }
  FieldLiveReading reading;
  reading.overRange = probe->values.size() != reading.rawT.size();
  if (!reading.overRange) {
    std::ranges::copy(probe->values, reading.rawT.begin());
  }
  reading.referenceT = valueOf(Role::FieldReference);
  reading.locked = reading.referenceT.has_value();
  reading.pt100Ohm = valueOf(Role::Resistance);
  const bool ownThermometer = m_realBench.draft().filling(Role::Temperature) != nullptr;
  reading.electronicsC = ownThermometer ? valueOf(Role::Temperature) : probe->electronicsC;
  m_presenter.takeReading(reading);
}

QString FieldConnectStep::title() const { return tr("Connect"); }

QString FieldConnectStep::helpPage() const { return QStringLiteral("field-connect"); }

void FieldConnectStep::entered() {
  m_presenter.setShown(true);
  m_realBench.setShown(true);
}

void FieldConnectStep::left() {
  m_presenter.setShown(false);
  m_realBench.setShown(false);
}

QWidget* FieldConnectStep::makeColumn() {
  m_column = new ConnectColumn(this);
  m_form = new SimulatedFieldForm(m_column);
  m_panel = fillConnectColumn(
      *m_column,
      tr("A Hall teslameter, an NMR, a magnet and two chambers in software, with a truth that is known. "
         "For learning the method and for trying out plans."),
      *m_form, *this, m_presenter, m_realBench);
  return m_column;
}

QWidget* FieldConnectStep::makeLiveBox() {
  auto* box = new QGroupBox(tr("Live reading"), this);
  auto* layout = new QVBoxLayout(box);
  layout->setSpacing(10);
  auto* axes = new QGridLayout;
  axes->setHorizontalSpacing(24);
  axes->setVerticalSpacing(0);
  for (const field::Axis axis : field::allAxes) {
    const auto place = field::indexOf(axis);
    const auto column = static_cast<int>(place);
    m_axes.at(place) =
        new ValueLabel(tr("Raw %1 (T)").arg(axisLetter(axis)), ValueLabel::Size::Large, QPalette::Link, box);
    m_axes.at(place)->setObjectName(QStringLiteral("raw_%1").arg(axisLetter(axis)));
    m_noise.at(place) = new QLabel(box);
    m_noise.at(place)->setObjectName(QStringLiteral("noise_%1").arg(axisLetter(axis)));
    m_noise.at(place)->setForegroundRole(QPalette::PlaceholderText);
    m_noise.at(place)->setToolTip(tr("Noise of one reading, from the differences of neighbouring ones"));
    axes->addWidget(m_axes.at(place), 0, column);
    axes->addWidget(m_noise.at(place), 1, column);
    axes->setColumnStretch(column, 1);
  }
  layout->addLayout(axes);
  auto* values = new QHBoxLayout;
  values->setSpacing(24);
  const QList<FieldConnectPresenter::Value> roles = m_presenter.values();
  for (const FieldConnectPresenter::Value& role : roles) {
    auto* label = new ValueLabel(role.caption, ValueLabel::Size::Small, QPalette::WindowText, box);
    label->setObjectName(role.name + QStringLiteral("Reading"));
    label->setMinimumWidth(fontMetrics().averageCharWidth() * 15); // nothing moves when values come
    m_values.append(label);
    values->addWidget(label);
  }
  values->addStretch(1);
  layout->addLayout(values);
  layout->addWidget(makeSettingRow(box));
  m_trace = new PlotView(box);
  m_trace->setObjectName(QStringLiteral("fieldLiveTrace"));
  m_trace->setMinimumHeight(180);
  layout->addWidget(m_trace, 1);
  return box;
}

QWidget* FieldConnectStep::makeSettingRow(QWidget* parent) {
  m_settings = new QWidget(parent);
  auto* row = new QHBoxLayout(m_settings);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  m_placing = new QComboBox(m_settings);
  m_placing->setObjectName(QStringLiteral("placement"));
  for (int placing = 0; placing <= static_cast<int>(devices::ProbePlacement::ZeroChamber); ++placing) {
    m_placing->addItem(placementWords(static_cast<devices::ProbePlacement>(placing)), placing);
  }
  m_place = new QPushButton(tr("Place"), m_settings);
  m_place->setObjectName(QStringLiteral("placeProbe"));
  auto* placeCaption = new QLabel(tr("&Probe"), m_settings);
  placeCaption->setBuddy(m_placing);
  m_field = new QDoubleSpinBox(m_settings);
  m_field->setObjectName(QStringLiteral("fieldTarget"));
  m_field->setRange(-largestSettableT, largestSettableT);
  m_field->setDecimals(3);
  m_field->setSingleStep(0.1);
  m_field->setSuffix(tr(" T"));
  m_field->setValue(0.5);
  m_setField = new QPushButton(tr("Set"), m_settings);
  m_setField->setObjectName(QStringLiteral("setField"));
  auto* fieldCaption = new QLabel(tr("&Magnet"), m_settings);
  fieldCaption->setBuddy(m_field);
  for (QWidget* each : std::initializer_list<QWidget*>{placeCaption, m_placing, m_place}) {
    row->addWidget(each);
  }
  row->addSpacing(20);
  for (QWidget* each : std::initializer_list<QWidget*>{fieldCaption, m_field, m_setField}) {
    row->addWidget(each);
  }
  row->addStretch(1);
  connect(m_place, &QPushButton::clicked, this,
          [this] { m_presenter.placeProbe(static_cast<devices::ProbePlacement>(m_placing->currentData().toInt())); });
  connect(m_setField, &QPushButton::clicked, this, [this] { m_presenter.setFieldT(m_field->value()); });
  return m_settings;
}

void FieldConnectStep::showConnection() {
  m_form->setSettings(m_presenter.simulatedSettings()); // of the session that was opened, or as it was connected
  m_column->showConnection({.connected = m_presenter.connected(),
                            .form = m_presenter.simulated() ? m_form : nullptr,
                            .mayChange = m_presenter.mayChange(),
                            .status = m_presenter.statusText(),
                            .instruments = m_presenter.instruments()});
  showTraceability();
  showReading();
}

void FieldConnectStep::showReading() {
  for (const field::Axis axis : field::allAxes) {
    m_axes.at(field::indexOf(axis))->setText(m_presenter.axisText(axis));
    m_noise.at(field::indexOf(axis))->setText(m_presenter.noiseText(axis));
  }
  const QList<FieldConnectPresenter::Value> values = m_presenter.values();
  for (qsizetype i = 0; i < values.size(); ++i) {
    m_values[i]->setText(values[i].text);
  }
  m_placing->setEnabled(m_presenter.canPlaceProbe());
  m_place->setEnabled(m_presenter.canPlaceProbe());
  m_field->setEnabled(m_presenter.canSetField());
  m_setField->setEnabled(m_presenter.canSetField());
  m_trace->setSpec(m_presenter.tracePlot());
}

void FieldConnectStep::showProblem() {
  m_notices->setNotices(m_presenter.problem().isEmpty()
                            ? QList<Notice>{}
                            : QList<Notice>{{Notice::Level::Problem, m_presenter.problem()}});
}

void FieldConnectStep::showTraceability() {
  m_column->showTraceability(m_presenter.traceabilitySummary(), m_presenter.canTakeOverInstruments());
}

StepPage* makeFieldConnectStep(FieldStepContext context, QWidget* parent) {
  return new FieldConnectStep(context, parent);
}

} // namespace straightedge::gui
