#include "app/gui/jobs/job_runner.h"

#include "app/gui/jobs/job_pool.h"

#include <QMetaObject>
#include <QPointer>
#include <QThread>

#include <algorithm>
#include <map>

namespace straightedge::gui {

struct JobRunner::Impl {
  struct Job {
    QString key;
    std::function<void()> deliver;
  };
  std::map<JobPool::Id, Job> running; // jobs whose results are still wanted
  std::unique_ptr<JobPool> pool;

  std::map<JobPool::Id, Job>::iterator find(const QString& key) {
    return std::find_if(running.begin(), running.end(), [&](const auto& entry) { return entry.second.key == key; });
  }
};

JobRunner::JobRunner(QObject* parent) : QObject(parent), m_impl(std::make_unique<Impl>()) {
  // One more than the cores: a job that waits for a disk does not hold up the one that computes.
  const auto threads = static_cast<std::size_t>(std::max(2, QThread::idealThreadCount() + 1));
  m_impl->pool = std::make_unique<JobPool>(
      threads, [this] { QMetaObject::invokeMethod(this, [this] { takeEvents(); }, Qt::QueuedConnection); });
}

JobRunner::~JobRunner() {
  m_impl->running.clear();
  m_impl->pool.reset(); // joins: nothing is queued for this object afterwards
}

void JobRunner::start(const QString& key, const QString& title, std::function<void(const JobControl&)> work,
                      std::function<void()> deliver) {
  cancelQuietly(key);
  const JobPool::Id id = m_impl->pool->start(std::move(work));
  m_impl->running.emplace(id, Impl::Job{key, std::move(deliver)});
  emit jobStarted(key, title);
}

void JobRunner::takeEvents() {
  const QPointer<JobRunner> alive(this); // whoever takes a result may close the window
  for (const JobPool::Event& event : m_impl->pool->takeEvents()) {
    const auto found = m_impl->running.find(event.job);
    if (found == m_impl->running.end()) {
      continue; // cancelled or overtaken: nobody wants this result any more
    }
    if (!event.ended) {
      emit jobProgress(found->second.key, std::clamp(event.fraction, 0.0, 1.0));
      continue;
    }
    const Impl::Job job = std::move(found->second);
    m_impl->running.erase(found);
    job.deliver(); // before jobEnded, so that whoever waits for the end finds the result; may start further jobs
    if (!alive) {
      return;
    }
    emit jobEnded(job.key, false);
    if (alive && !busy()) {
      emit idle();
    }
    if (!alive) {
      return;
    }
  }
}

bool JobRunner::cancelQuietly(const QString& key) {
  const auto found = m_impl->find(key);
  if (found == m_impl->running.end()) {
    return false;
  }
  m_impl->pool->cancel(found->first);
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
    const QString key = m_impl->running.begin()->second.key;
    cancel(key);
  }
}

bool JobRunner::busy() const { return !m_impl->running.empty(); }

bool JobRunner::isRunning(const QString& key) const { return m_impl->find(key) != m_impl->running.end(); }

} // namespace straightedge::gui
