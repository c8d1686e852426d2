// Reads an idle bench in a thread of its own, so that a slow or silent instrument never holds up the window.
#pragma once

#include "devices/instruments/angle_instruments.h"

#include <QObject>
#include <QString>

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

namespace straightedge::gui {

/// Made and destroyed in the GUI thread; while it lives, its thread alone touches the bench's instruments.
/// The bench's owner must outlive it. Signals are sent from the reading thread and arrive queued.
class LiveReader : public QObject {
  Q_OBJECT
public:
  explicit LiveReader(devices::AngleBench bench, QObject* parent = nullptr);
  ~LiveReader() override; ///< stops after the reading in hand and joins

  void moveShaftTo(double encoderDeg); ///< unwrapped; replaces a move that is still under way; needs a stage

signals:
  void reading(double encoderDeg, double sensorDeg);
  void failed(const QString& message); ///< once per run of failing readings

private:
  void run(const std::stop_token& stop);
  Result<double> readOnce();
  Result<void> moveOneStep();
  std::optional<double> pendingTarget();

  devices::AngleBench m_bench;
  double m_encoderDeg = 0.0; ///< reading thread only
  std::mutex m_mutex;
  std::condition_variable_any m_wake;
  std::optional<double> m_targetDeg; ///< guarded by m_mutex
  std::jthread m_thread;             ///< last: stops before the rest goes
};

} // namespace straightedge::gui
