#include "app/gui/steps/simulation_rows.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QSpinBox>

#include <algorithm>
#include <limits>

namespace straightedge::gui {

namespace {

constexpr int largestSeed = std::numeric_limits<int>::max();

QString simulationText(const char* text) { return QCoreApplication::translate("SimulationRows", text); }

} // namespace

SimulationRows::SimulationRows(QFormLayout& form, const QString& aboutSpeed)
    : m_speed(new QComboBox(form.parentWidget())), m_seed(new QSpinBox(form.parentWidget())) {
  m_speed->setObjectName(QStringLiteral("speed"));
  m_speed->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon); // the column decides
  m_speed->setMinimumContentsLength(12);
  m_speed->addItem(simulationText("Real time"), true);
  m_speed->addItem(simulationText("As fast as possible"), false);
  m_speed->setToolTip(aboutSpeed);
  m_seed->setObjectName(QStringLiteral("seed"));
  m_seed->setRange(0, largestSeed);
  m_seed->setToolTip(simulationText("The same number repeats the same noise"));
  form.addRow(simulationText("Speed"), m_speed);
  form.addRow(simulationText("Random numbers"), m_seed);
}

void SimulationRows::set(bool realTime, std::uint64_t seed) {
  m_speed->setCurrentIndex(m_speed->findData(realTime));
  m_seed->setValue(static_cast<int>(std::min<std::uint64_t>(seed, largestSeed)));
}

bool SimulationRows::realTime() const { return m_speed->currentData().toBool(); }

std::uint64_t SimulationRows::seed() const { return static_cast<std::uint64_t>(m_seed->value()); }

} // namespace straightedge::gui
