#include "app/gui/shell/import_presenter.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace straightedge::gui {

namespace {
QString sayImport(const char* text) { return QCoreApplication::translate("ImportPresenter", text); }

/// Seven digits at most, as short as they can be.
QString shortNumber(double value) { return QString::number(value, 'g', 7); }
} // namespace

ImportPresenter::ImportPresenter(angle::CsvPreview preview)
    : m_preview(std::move(preview)), m_mapping(m_preview.mapping()) {}

const std::vector<angle::SweepColumn>& ImportPresenter::roles() {
  using enum angle::SweepColumn;
  static const std::vector<angle::SweepColumn> all{Ignored, Encoder, Sensor, Turn, Direction, Temperature, Time};
  return all;
}

QString ImportPresenter::roleText(angle::SweepColumn role) {
  switch (role) {
  case angle::SweepColumn::Ignored:
    return sayImport("Not used");
  case angle::SweepColumn::Encoder:
    return sayImport("Encoder angle (°)");
  case angle::SweepColumn::Sensor:
    return sayImport("Sensor angle (°)");
  case angle::SweepColumn::Turn:
    return sayImport("Turn");
  case angle::SweepColumn::Direction:
    return sayImport("Direction");
  case angle::SweepColumn::Temperature:
    return sayImport("Temperature (°C)");
  case angle::SweepColumn::Time:
    return sayImport("Time (s)");
  }
  return {};
}

void ImportPresenter::setRole(std::size_t column, angle::SweepColumn role) {
  if (column >= m_mapping.size()) {
    return;
  }
  if (role != angle::SweepColumn::Ignored) {
    std::replace(m_mapping.begin(), m_mapping.end(), role, angle::SweepColumn::Ignored);
  }
  m_mapping[column] = role;
  m_changed = true;
}

QString ImportPresenter::problem() const {
  const auto count = [&](angle::SweepColumn role) { return std::count(m_mapping.begin(), m_mapping.end(), role); };
  if (m_mapping.size() < 2) {
    return sayImport(
        "The file has a single column. A sweep needs the encoder angle and the sensor angle in columns of their "
        "own.");
  }
  if (count(angle::SweepColumn::Encoder) == 0) {
    return sayImport("Choose the column that holds the encoder (reference) angle.");
  }
  if (count(angle::SweepColumn::Sensor) == 0) {
    return sayImport("Choose the column that holds the sensor angle.");
  }
  for (std::size_t i = 0; i < m_mapping.size(); ++i) {
    if (m_mapping[i] != angle::SweepColumn::Ignored && m_mapping[i] != angle::SweepColumn::Direction &&
        !m_preview.columns[i].minimum) {
      return sayImport("The column “%1” holds no numbers.").arg(QString::fromStdString(m_preview.columns[i].title));
    }
  }
  if (m_preview.problem && !m_changed) {
    return QString::fromStdString(m_preview.problem->message());
  }
  return {};
}

QString ImportPresenter::layoutText() const {
  const auto& layout = m_preview.layout;
  const QString separator = layout.separator == '\t'  ? sayImport("tab")
                            : layout.separator == ';' ? sayImport("semicolon")
                                                      : sayImport("comma");
  QStringList parts{sayImport("Separator: %1").arg(separator),
                    layout.decimalPoint == ',' ? sayImport("decimal comma") : sayImport("decimal point"),
                    layout.hasHeader ? sayImport("titles in the first row") : sayImport("no titles"),
                    sayImport("%1 rows").arg(m_preview.rowCount)};
  return parts.join(QStringLiteral(" · "));
}

QString ImportPresenter::rangeText(std::size_t column) const {
  const auto& info = m_preview.columns[column];
  if (!info.minimum || !info.maximum) {
    return sayImport("no numbers");
  }
  return sayImport("%1 … %2").arg(shortNumber(*info.minimum), shortNumber(*info.maximum));
}

} // namespace straightedge::gui
