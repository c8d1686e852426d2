#include "app/gui/steps/capture_points_model.h"

#include <algorithm>

namespace straightedge::gui {

namespace {

QString degreesText(double deg, int decimals) {
  return QString::number(deg, 'f', decimals).replace(QLatin1Char('-'), QChar(0x2212)) + QStringLiteral("°");
}

} // namespace

CapturePointsModel::CapturePointsModel(QObject* parent) : QAbstractTableModel(parent) {}

void CapturePointsModel::setPlan(const devices::AnglePlan& plan) {
  beginResetModel();
  m_planned = devices::checkPlan(plan) ? devices::plannedPoints(plan) : std::vector<devices::PlannedPoint>{};
  m_readings.assign(m_planned.size(), {});
  m_lastMeasured.reset();
  m_measured = 0;
  m_firstChanged = m_lastChanged = -1;
  endResetModel();
}

void CapturePointsModel::add(std::span<const session::AngleSample> samples,
                             const std::function<std::optional<double>(const session::AngleSample&)>& errorDeg) {
  for (const session::AngleSample& sample : samples) {
    if (sample.point < 0 || static_cast<std::size_t>(sample.point) >= m_readings.size()) {
      continue;
    }
    Reading& reading = m_readings[static_cast<std::size_t>(sample.point)];
    m_measured += reading.samples == 0 && reading.attempt == 0 ? 1 : 0;
    if (sample.attempt > reading.attempt) {
      reading = Reading{sample.attempt, 0, 0.0, {}};
    }
    reading.samples += 1;
    reading.sensorDeg = sample.sensorDeg;
    reading.errorDeg = errorDeg(sample);
    m_lastMeasured = sample.point;
    m_firstChanged = m_firstChanged < 0 ? sample.point : std::min(m_firstChanged, sample.point);
    m_lastChanged = std::max(m_lastChanged, sample.point);
  }
}

void CapturePointsModel::flush() {
  if (m_firstChanged >= 0 && m_lastChanged >= m_firstChanged) {
    emit dataChanged(index(m_firstChanged, 0), index(m_lastChanged, ColumnCount - 1));
  }
  m_firstChanged = m_lastChanged = -1;
}

bool CapturePointsModel::isMeasured(int planPoint) const {
  return planPoint >= 0 && static_cast<std::size_t>(planPoint) < m_readings.size() &&
         m_readings[static_cast<std::size_t>(planPoint)].samples > 0;
}

int CapturePointsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_planned.size());
}

int CapturePointsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QString CapturePointsModel::stateText(const Reading& reading) const {
  if (reading.samples == 0) {
    return {};
  }
  const QString count = reading.samples == 1 ? tr("1 reading") : tr("%1 readings").arg(reading.samples);
  return reading.attempt == 0 ? count : tr("%1, measured again").arg(count);
}

QVariant CapturePointsModel::data(const QModelIndex& index, int role) const {
  const auto row = static_cast<std::size_t>(index.row());
  if (role == Qt::TextAlignmentRole) {
    return QVariant::fromValue(index.column() == State || index.column() == Direction
                                   ? Qt::AlignLeft | Qt::AlignVCenter
                                   : Qt::AlignRight | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole || row >= m_planned.size()) {
    return {};
  }
  const devices::PlannedPoint& point = m_planned[row];
  const Reading& reading = m_readings[row];
  switch (index.column()) {
  case Point:
    return point.index + 1;
  case Turn:
    return point.turn + 1;
  case Direction:
    return point.direction > 0 ? tr("rising") : tr("falling");
  case Planned:
    return degreesText(point.encoderDeg, 2);
  case Sensor:
    return reading.samples > 0 ? degreesText(reading.sensorDeg, 3) : QString();
  case Error:
    return reading.errorDeg ? degreesText(*reading.errorDeg, 3) : QString();
  case State:
    return stateText(reading);
  default:
    return {};
  }
}

QVariant CapturePointsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
  case Point:
    return tr("Point");
  case Turn:
    return tr("Turn");
  case Direction:
    return tr("Direction");
  case Planned:
    return tr("Encoder");
  case Sensor:
    return tr("Sensor");
  case Error:
    return tr("Error");
  case State:
    return tr("Measured");
  default:
    return {};
  }
}

} // namespace straightedge::gui
