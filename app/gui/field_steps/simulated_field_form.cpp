#include "app/gui/field_steps/simulated_field_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>

#include <algorithm>

namespace straightedge::gui {

namespace {

constexpr double microteslaPerTesla = 1e6;
constexpr double milliteslaPerTesla = 1e3;
// Of the order of a thick plate's: 1 mT of both cross fields of 1 T.
constexpr double usualPlanarHallPerT = 1e-3;

QDoubleSpinBox* fieldBenchNumber(QWidget* parent, const QString& name, double least, double most, int decimals,
                                 const QString& unit) {
  auto* box = new QDoubleSpinBox(parent);
  box->setObjectName(name);
  box->setDecimals(decimals);
  box->setRange(least, most);
  box->setSuffix(unit);
  return box;
}

/// Exactly: off is nothing else than zero.
bool hasPlanarHall(const devices::SimulatedFieldSettings& settings) {
  return std::ranges::any_of(settings.probe.axes,
                             [](const devices::HallAxis& axis) { return axis.planarHallPerT != 0.0; });
}

} // namespace

SimulatedFieldForm::SimulatedFieldForm(QWidget* parent)
    : QWidget(parent), m_noise(fieldBenchNumber(this, QStringLiteral("fieldNoise"), 0.0, 1e5, 1, tr(" µT"))),
      m_probeLag(fieldBenchNumber(this, QStringLiteral("probeLag"), 0.0, 3600.0, 1, tr(" s"))),
      m_lockThreshold(fieldBenchNumber(this, QStringLiteral("lockThreshold"), 0.0, 2000.0, 0, tr(" mT"))),
      m_room(fieldBenchNumber(this, QStringLiteral("roomTemperature"), 10.0, 40.0, 1, tr(" °C"))),
      m_planarHall(new QCheckBox(tr("The probe has it"), this)), m_placing(new QComboBox(this)) {
  m_noise->setToolTip(tr("Standard deviation of one raw reading"));
  m_probeLag->setToolTip(tr("Of the probe behind the air of its chamber: the cause of hysteresis over temperature"));
  m_lockThreshold->setToolTip(tr("The simulated NMR does not lock on a smaller field"));
  m_planarHall->setObjectName(QStringLiteral("planarHall"));
  m_planarHall->setToolTip(tr("Two fields across an axis add to its reading. The correction has no block for it: what "
                              "it leaves is seen in Verify."));
  m_placing->setObjectName(QStringLiteral("placing"));
  m_placing->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon); // the column decides
  m_placing->setMinimumContentsLength(12);
  m_placing->addItem(tr("By the bench"), false);
  m_placing->addItem(tr("By hand: the campaign waits"), true);
  m_placing->setToolTip(tr("By hand the campaign stops at every placement and says what is to be done, as on a bench "
                           "without a carrier"));

  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("Noise"), m_noise);
  form->addRow(tr("Probe's lag"), m_probeLag);
  form->addRow(tr("NMR locks from"), m_lockThreshold);
  form->addRow(tr("Room"), m_room);
  form->addRow(tr("Planar Hall effect"), m_planarHall);
  form->addRow(tr("Probe is placed"), m_placing);
  m_simulation.emplace(*form, tr("In real time a whole campaign takes hours, as on a real bench"));
  setSettings({});
}

void SimulatedFieldForm::setSettings(const devices::SimulatedFieldSettings& settings) {
  m_base = settings;
  m_noise->setValue(settings.probe.noiseT * microteslaPerTesla);
  m_probeLag->setValue(settings.probeLagS);
  m_lockThreshold->setValue(settings.lockThresholdT * milliteslaPerTesla);
  m_room->setValue(settings.roomC);
  m_planarHall->setChecked(hasPlanarHall(settings));
  m_placing->setCurrentIndex(m_placing->findData(settings.byHand));
  m_simulation->set(settings.realTime, settings.seed);
}

devices::SimulatedFieldSettings SimulatedFieldForm::settings() const {
  devices::SimulatedFieldSettings settings = m_base;
  settings.probe.noiseT = m_noise->value() / microteslaPerTesla;
  settings.probeLagS = m_probeLag->value();
  settings.lockThresholdT = m_lockThreshold->value() / milliteslaPerTesla;
  settings.roomC = m_room->value();
  if (hasPlanarHall(m_base) != m_planarHall->isChecked()) { // another strength, of the command line, stays
    for (devices::HallAxis& axis : settings.probe.axes) {
      axis.planarHallPerT = m_planarHall->isChecked() ? usualPlanarHallPerT : 0.0;
    }
  }
  settings.byHand = m_placing->currentData().toBool();
  settings.realTime = m_simulation->realTime();
  settings.seed = m_simulation->seed();
  return settings;
}

} // namespace straightedge::gui
