// Watches what is plugged in, in a thread of its own: by the system's events, and by looking again where there are
// none.
#pragma once

#include "devices/bench/bench_seat.h"

#include <QObject>

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace straightedge::gui {

/// GUI thread. changed() comes once after the first look, then only when something differs.
class DeviceWatch : public QObject {
  Q_OBJECT
public:
  /// `byEvents`: hears of plugging in and out by USB events beside looking every two seconds.
  explicit DeviceWatch(devices::DeviceLister lister, bool byEvents = true, QObject* parent = nullptr);
  ~DeviceWatch() override; ///< joins

  void setWatching(bool on); ///< looks only while somebody wants to see
  void lookNow();

  bool hasLooked() const { return m_looked; }
  const std::vector<devices::ListedDevice>& devices() const { return m_devices; }
  const std::optional<Error>& problem() const { return m_problem; } ///< the system could not be asked

signals:
  void changed();

private:
  void run(const std::stop_token& stop);
  void look();
  void take();

  const devices::DeviceLister m_lister;
  bool m_looked = false;
  std::vector<devices::ListedDevice> m_devices;
  std::optional<Error> m_problem;

  std::mutex m_mutex; ///< guards what follows
  std::condition_variable_any m_wake;
  bool m_watching = false;
  bool m_poked = false;
  std::optional<Result<std::vector<devices::ListedDevice>>> m_found; ///< not taken over yet
  std::optional<Result<std::vector<devices::ListedDevice>>> m_last;  ///< watching thread only
  const bool m_byEvents;
  std::jthread m_thread; ///< last: ends before the rest goes
};

} // namespace straightedge::gui
