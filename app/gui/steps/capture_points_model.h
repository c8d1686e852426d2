// The plan's points as a table: where each is to be measured, and what was read there.
#pragma once

#include "core/session/sample_sink.h"
#include "devices/capture/angle_plan.h"

#include <QAbstractTableModel>

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace straightedge::gui {

class CapturePointsModel : public QAbstractTableModel {
  Q_OBJECT
public:
  enum Column : std::uint8_t { Point, Turn, Direction, Planned, Sensor, Error, State, ColumnCount };

  explicit CapturePointsModel(QObject* parent = nullptr);

  void setPlan(const devices::AnglePlan& plan); ///< forgets all readings
  /// Takes new samples in; the view hears of it by flush(), so that a frame costs one update.
  void add(std::span<const session::AngleSample> samples,
           const std::function<std::optional<double>(const session::AngleSample&)>& errorDeg);
  void flush();
  const std::vector<devices::PlannedPoint>& planned() const { return m_planned; } ///< empty where the plan is none
  std::optional<int> lastMeasured() const { return m_lastMeasured; }
  int measuredPoints() const { return m_measured; }
  bool isMeasured(int planPoint) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
  struct Reading {
    int attempt = 0;
    int samples = 0;
    double sensorDeg = 0.0; ///< of the newest sample
    std::optional<double> errorDeg;
  };
  QString stateText(const Reading& reading) const;

  std::vector<devices::PlannedPoint> m_planned;
  std::vector<Reading> m_readings;
  std::optional<int> m_lastMeasured;
  int m_measured = 0;
  int m_firstChanged = -1, m_lastChanged = -1;
};

} // namespace straightedge::gui
