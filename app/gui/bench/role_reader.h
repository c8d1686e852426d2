// Reads every role of an idle bench in a thread of its own and sends what a person types into a console, so that a slow
// or silent instrument never holds up the window. Without Qt.
#pragma once

#include "devices/bench/opened_bench.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace straightedge::gui {

struct RoleState {
  devices::InstrumentRole role = devices::InstrumentRole::AngleSensor;
  std::optional<devices::RoleReading> reading;
  std::optional<Error> fault; ///< where there is no reading
};

/// Owned by the controlling thread. An instrument that left is looked for, and read again when it is back.
class RoleReader {
public:
  /// Called in the reader's thread.
  struct Listener {
    std::function<void(std::vector<RoleState>)> read;
    std::function<void(std::size_t instrument, Result<std::string> answer)> said;
  };

  RoleReader(std::shared_ptr<devices::OpenedBench> bench, Listener listener);
  ~RoleReader(); ///< waits for the reading in hand: not in the window's thread, but see silence()
  RoleReader(const RoleReader&) = delete;
  RoleReader& operator=(const RoleReader&) = delete;

  void setReading(bool on);                            ///< off: nothing is read from the next reading on
  void say(std::size_t instrument, std::string bytes); ///< the listener hears the answer
  void silence();                                      ///< the listener hears nothing any more; nothing is read

private:
  struct Command {
    std::size_t instrument = 0;
    std::string bytes;
  };

  void run(const std::stop_token& stop);
  std::vector<RoleState> readAll(const std::stop_token& stop);
  bool stillWanted();
  template <typename Call>
  void tell(const Call& call);

  const std::shared_ptr<devices::OpenedBench> m_bench;
  const std::chrono::milliseconds m_period;
  std::mutex m_listening; ///< guards m_listener; held while it is called
  std::optional<Listener> m_listener;
  std::mutex m_mutex; ///< guards what follows
  std::condition_variable_any m_wake;
  bool m_reading = false;
  std::deque<Command> m_commands;
  std::jthread m_thread; ///< last: ends before the rest goes
};

} // namespace straightedge::gui
