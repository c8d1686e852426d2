// Reads an idle field bench in a thread of its own, so that a slow or silent instrument never holds up the window.
#pragma once

#include "devices/instruments/field_bench.h"

#include <QObject>
#include <QString>

#include <array>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

namespace straightedge::gui {

/// What every role of a field bench reads now; empty where nothing fills the role or it said nothing.
struct FieldLiveReading {
  std::array<double, 3> rawT = {0.0, 0.0, 0.0};
  bool overRange = false; ///< then rawT is not to be used
  bool locked = false;    ///< of the reference
  std::optional<double> referenceT;
  std::optional<double> pt100Ohm;
  std::optional<double> electronicsC;
  std::optional<double> probeChamberC;
  std::optional<double> electronicsChamberC;
};

/// Made and destroyed in the GUI thread; while it lives, its thread alone touches the bench's instruments.
/// The bench's owner must outlive it. Signals are sent from the reading thread and arrive queued.
class FieldLiveReader : public QObject {
  Q_OBJECT
public:
  explicit FieldLiveReader(devices::FieldBench bench, QObject* parent = nullptr);
  ~FieldLiveReader() override; ///< stops after the reading in hand and joins

  void setFieldT(double fieldT);                    ///< needs a magnet
  void placeProbe(devices::ProbePlacement placing); ///< needs a carrier

signals:
  void reading(const straightedge::gui::FieldLiveReading& reading);
  void failed(const QString& message); ///< once per run of failing readings

private:
  void run(const std::stop_token& stop);
  Result<void> readOnce();
  Result<void> readBeside(FieldLiveReading& reading);
  Result<void> carryOut();

  devices::FieldBench m_bench;
  std::mutex m_mutex;
  std::condition_variable_any m_wake;
  std::optional<double> m_fieldT; ///< asked for; both guarded by m_mutex
  std::optional<devices::ProbePlacement> m_placing;
  std::jthread m_thread; ///< last: stops before the rest goes
};

} // namespace straightedge::gui
