#include "app/gui/jobs/job_pool.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

namespace straightedge::gui {

namespace {
using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds progressInterval{40}; // 25 updates a second are enough for a progress bar

/// Belongs to the computing thread: lets through only as much progress as a person can see.
class ProgressThrottle {
public:
  bool due(double fraction) {
    const auto now = Clock::now();
    if (fraction < 1.0 && now - m_last < progressInterval) {
      return false;
    }
    m_last = now;
    return true;
  }

private:
  Clock::time_point m_last;
};
} // namespace

JobPool::JobPool(std::size_t mostThreads, std::function<void()> wake)
    : m_mostThreads(std::max<std::size_t>(1, mostThreads)), m_wake(std::move(wake)) {}

JobPool::~JobPool() {
  {
    const std::scoped_lock lock(m_mutex);
    m_waiting.clear();
    for (auto& [id, stop] : m_stops) {
      stop.request_stop();
    }
  }
  for (std::jthread& thread : m_threads) {
    thread.request_stop();
  }
  m_threads.clear();
}

JobPool::Id JobPool::start(std::function<void(const JobControl&)> work) {
  Id id = 0;
  bool another = false;
  {
    const std::scoped_lock lock(m_mutex);
    id = ++m_lastId;
    Task task{id, {}, std::move(work)};
    m_stops.emplace(id, task.stop);
    m_waiting.push_back(std::move(task));
    another = m_idle < m_waiting.size() && m_threads.size() < m_mostThreads;
  }
  m_changed.notify_one();
  if (another) {
    m_threads.emplace_back([this](const std::stop_token& closing) { serve(closing); });
  }
  return id;
}

void JobPool::cancel(Id job) {
  const std::scoped_lock lock(m_mutex);
  if (const auto found = m_stops.find(job); found != m_stops.end()) {
    found->second.request_stop();
  }
}

std::vector<JobPool::Event> JobPool::takeEvents() {
  const std::scoped_lock lock(m_mutex);
  return std::exchange(m_events, {});
}

void JobPool::serve(const std::stop_token& closing) {
  while (true) {
    Task task;
    {
      std::unique_lock lock(m_mutex);
      ++m_idle;
      const bool found = m_changed.wait(lock, closing, [this] { return !m_waiting.empty(); });
      --m_idle;
      if (!found || closing.stop_requested()) {
        return;
      }
      task = std::move(m_waiting.front());
      m_waiting.pop_front();
    }
    run(task);
  }
}

void JobPool::run(Task& task) {
  JobControl control;
  control.stop = task.stop.get_token();
  control.progress = [this, id = task.id, throttle = std::make_shared<ProgressThrottle>()](double fraction) {
    if (throttle->due(fraction)) {
      announce({id, false, fraction});
    }
  };
  if (!control.stop.stop_requested()) {
    task.work(control);
  }
  task.work = nullptr; // what it held goes here, not in the controlling thread
  announce({task.id, true, 1.0});
}

void JobPool::announce(Event event) {
  bool first = false;
  {
    const std::scoped_lock lock(m_mutex);
    first = m_events.empty();
    m_events.push_back(event);
    if (event.ended) {
      m_stops.erase(event.job);
    }
  }
  if (first) {
    m_wake();
  }
}

} // namespace straightedge::gui
