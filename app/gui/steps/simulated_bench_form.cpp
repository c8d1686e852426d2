#include "app/gui/steps/simulated_bench_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSpinBox>

namespace straightedge::gui {

namespace {

QDoubleSpinBox* degreeBox(QWidget* parent, const QString& name, double least, double most, int decimals, double step) {
  auto* box = new QDoubleSpinBox(parent);
  box->setObjectName(name);
  box->setDecimals(decimals);
  box->setRange(least, most);
  box->setSingleStep(step);
  box->setSuffix(QStringLiteral("°"));
  return box;
}

QComboBox* choice(QWidget* parent, const QString& name) {
  auto* box = new QComboBox(parent);
  box->setObjectName(name);
  return box;
}

} // namespace

SimulatedBenchForm::SimulatedBenchForm(QWidget* parent)
    : QWidget(parent), m_geometry(choice(this, QStringLiteral("geometry"))),
      m_mounting(degreeBox(this, QStringLiteral("mountingAngle"), -360.0, 360.0, 2, 5.0)),
      m_noise(degreeBox(this, QStringLiteral("noise"), 0.0, 10.0, 4, 0.01)),
      m_hysteresis(degreeBox(this, QStringLiteral("hysteresis"), 0.0, 10.0, 4, 0.01)), m_bits(new QSpinBox(this)),
      m_decreasing(new QCheckBox(tr("Counts backwards"), this)) {
  m_geometry->addItem(tr("Beside the shaft"), static_cast<int>(devices::FieldGeometry::SideShaft));
  m_geometry->addItem(tr("End of the shaft"), static_cast<int>(devices::FieldGeometry::OnAxis));
  m_geometry->setToolTip(tr("Beside the shaft the field is elliptic: errors above 10°, mostly the second harmonic.\n"
                            "At the end of the shaft, slightly off centre, errors are small."));
  m_mounting->setToolTip(tr("Sensor zero against encoder zero"));
  m_noise->setToolTip(tr("Standard deviation of one reading"));
  m_hysteresis->setToolTip(tr("Half the width of the loop between both directions"));
  m_bits->setObjectName(QStringLiteral("bits"));
  m_bits->setRange(0, 24);
  m_bits->setSuffix(tr(" bit"));
  m_bits->setSpecialValueText(tr("not quantised"));
  m_decreasing->setObjectName(QStringLiteral("decreasing"));
  m_decreasing->setToolTip(tr("The sensor is mounted upside down: its angle falls while the encoder's rises"));

  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("Magnet and sensor"), m_geometry);
  form->addRow(tr("Mounting angle"), m_mounting);
  form->addRow(tr("Noise"), m_noise);
  form->addRow(tr("Hysteresis"), m_hysteresis);
  form->addRow(tr("Resolution"), m_bits);
  form->addRow(tr("Direction"), m_decreasing);
  m_simulation.emplace(*form, tr("In real time a sweep takes as long as on a real bench"));
  setSettings({});
}

void SimulatedBenchForm::setSettings(const devices::SimulatedAngleSettings& settings) {
  m_base = settings;
  m_geometry->setCurrentIndex(m_geometry->findData(static_cast<int>(settings.geometry)));
  m_mounting->setValue(settings.mountingAngleDeg);
  m_noise->setValue(settings.noiseDeg);
  m_hysteresis->setValue(settings.hysteresisDeg);
  m_bits->setValue(settings.sensorBits);
  m_decreasing->setChecked(settings.decreasing);
  m_simulation->set(settings.realTime, settings.seed);
}

devices::SimulatedAngleSettings SimulatedBenchForm::settings() const {
  devices::SimulatedAngleSettings settings = m_base;
  settings.geometry = static_cast<devices::FieldGeometry>(m_geometry->currentData().toInt());
  settings.mountingAngleDeg = m_mounting->value();
  settings.noiseDeg = m_noise->value();
  settings.hysteresisDeg = m_hysteresis->value();
  settings.sensorBits = m_bits->value();
  settings.decreasing = m_decreasing->isChecked();
  settings.realTime = m_simulation->realTime();
  settings.seed = m_simulation->seed();
  return settings;
}

} // namespace straightedge::gui
