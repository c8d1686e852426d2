// The threads behind JobRunner, without Qt, so that the thread sanitizer sees every hand-over.
#pragma once

#include "core/base/job_control.h"

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace straightedge::gui {

/// Owned and called by one thread, the controlling one. What a job has written before it ended may be read after its
/// `ended` event was taken.
class JobPool {
public:
  using Id = std::uint64_t;
  struct Event {
    Id job = 0;
    bool ended = false;
    double fraction = 0.0; ///< progress, where the job has not ended
  };

  /// `wake` is called from the jobs' threads when events wait for takeEvents(), once until they are taken; never after
  /// the destructor has returned.
  JobPool(std::size_t mostThreads, std::function<void()> wake);
  ~JobPool(); ///< asks every job to stop and waits for them
  JobPool(const JobPool&) = delete;
  JobPool& operator=(const JobPool&) = delete;

  Id start(std::function<void(const JobControl&)> work);
  void cancel(Id job); ///< its work is asked to stop, or not begun; it still ends
  std::vector<Event> takeEvents();

private:
  struct Task {
    Id id = 0;
    std::stop_source stop;
    std::function<void(const JobControl&)> work;
  };

  void serve(const std::stop_token& closing);
  void run(Task& task);
  void announce(Event event);

  const std::size_t m_mostThreads;
  const std::function<void()> m_wake;
  std::mutex m_mutex; ///< guards what follows
  std::condition_variable_any m_changed;
  std::deque<Task> m_waiting;
  std::map<Id, std::stop_source> m_stops; ///< of jobs that have not ended
  std::vector<Event> m_events;
  std::size_t m_idle = 0; ///< threads that wait for a task
  Id m_lastId = 0;
  std::vector<std::jthread> m_threads; ///< controlling thread only; last: joined before the rest goes
};

} // namespace straightedge::gui
