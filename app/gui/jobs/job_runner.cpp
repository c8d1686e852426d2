#include "app/gui/jobs/job_runner.h"

#include <QMetaObject>
#include <QThreadPool>

#include <algorithm>
#include <chrono>
#include <map>

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

struct JobRunner::Impl {
  struct Job {
    std::uint64_t id = 0;
    std::stop_source stop;
  };
  std::map<QString, Job> running; // jobs whose results are still wanted
  std::uint64_t lastId = 0;
  QThreadPool pool;
};

JobRunner::JobRunner(QObject* parent) : QObject(parent), m_impl(std::make_unique<Impl>()) {
  // One more than the cores: a job that waits for a disk does not hold up the one that computes.
  m_impl->pool.setMaxThreadCount(std::max(2, QThread::idealThreadCount() + 1));
}

JobRunner::~JobRunner() {
  for (auto& [key, job] : m_impl->running) {
    job.stop.request_stop();
  }
  m_impl->running.clear();
  m_impl->pool.clear();
  m_impl->pool.waitForDone();
}

void JobRunner::start(const QString& key, const QString& title, std::function<void(const JobControl&)> work,
                      std::function<void()> deliver) {
  cancelQuietly(key);
  Impl::Job job;
  job.id = ++m_impl->lastId;
  const auto id = job.id;
  const auto token = job.stop.get_token();
  m_impl->running.insert_or_assign(key, job);
  emit jobStarted(key, title);

  m_impl->pool.start([this, key, id, token, work = std::move(work), deliver = std::move(deliver)]() mutable {
    JobControl control;
    control.stop = token;
    auto throttle = std::make_shared<ProgressThrottle>();
    control.progress = [this, key, id, throttle](double fraction) {
      if (throttle->due(fraction)) {
        QMetaObject::invokeMethod(this, [this, key, id, fraction] { showProgress(key, id, fraction); });
      }
    };
    if (!token.stop_requested()) {
      work(control);
    }
    // The destructor waits for the pool, so `this` is alive here; its queued calls die with it.
    QMetaObject::invokeMethod(
        this, [this, key, id, deliver = std::move(deliver)] { finish(key, id, deliver); }, Qt::QueuedConnection);
  });
}

void JobRunner::showProgress(const QString& key, std::uint64_t id, double fraction) {
  const auto found = m_impl->running.find(key);
  if (found != m_impl->running.end() && found->second.id == id) {
    emit jobProgress(key, std::clamp(fraction, 0.0, 1.0));
  }
}

void JobRunner::finish(const QString& key, std::uint64_t id, const std::function<void()>& deliver) {
  const auto found = m_impl->running.find(key);
  if (found == m_impl->running.end() || found->second.id != id) {
    return; // cancelled or overtaken: nobody wants this result any more
  }
  m_impl->running.erase(found);
  deliver(); // before jobEnded, so that whoever waits for the end finds the result; may start further jobs
  emit jobEnded(key, false);
  if (!busy()) {
    emit idle();
  }
}

bool JobRunner::cancelQuietly(const QString& key) {
  const auto found = m_impl->running.find(key);
  if (found == m_impl->running.end()) {
    return false;
  }
  found->second.stop.request_stop();
  m_impl->running.erase(found);
  emit jobEnded(key, true);
  return true;
}

void JobRunner::cancel(const QString& key) {
  if (cancelQuietly(key) && !busy()) {
    emit idle();
  }
}

void JobRunner::cancelAll() {
  while (!m_impl->running.empty()) {
    const QString key = m_impl->running.begin()->first;
    cancel(key);
  }
}

bool JobRunner::busy() const { return !m_impl->running.empty(); }

bool JobRunner::isRunning(const QString& key) const { return m_impl->running.contains(key); }

} // namespace straightedge::gui
