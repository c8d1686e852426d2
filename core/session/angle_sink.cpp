#include "core/session/angle_sink.h"

#include <utility>

namespace straightedge::session {

namespace {

/// More than this is written at once rather than gathered: 3 s at 10,000 samples a second.
constexpr std::size_t largestBatch = 32768;

} // namespace

AngleSink::AngleSink(std::shared_ptr<Connection> connection, SweepRole role)
    : m_connection(std::move(connection)), m_role(role),
      m_thread([this](const std::stop_token& stop) { commitInTime(stop); }) {}

AngleSink::~AngleSink() {
  m_thread.request_stop();
  m_thread.join();
  std::ignore = commit();
}

Result<void> AngleSink::append(std::span<const AngleSample> samples) {
  bool much = false;
  {
    const std::scoped_lock lock(m_mutex);
    if (m_failure) {
      return std::unexpected(*m_failure);
    }
    const bool wasEmpty = nothingPending();
    m_samples.insert(m_samples.end(), samples.begin(), samples.end());
    much = m_samples.size() >= largestBatch;
    pendingGrew(wasEmpty);
  }
  return much ? commit() : Result<void>();
}

Result<void> AngleSink::recordGap(const SampleGap& gap) {
  const std::scoped_lock lock(m_mutex);
  if (m_failure) {
    return std::unexpected(*m_failure);
  }
  const bool wasEmpty = nothingPending();
  m_gaps.push_back(gap);
  pendingGrew(wasEmpty);
  return {};
}

void AngleSink::pendingGrew(bool wasEmpty) {
  if (wasEmpty && !nothingPending()) {
    m_oldest = std::chrono::steady_clock::now();
    m_changed.notify_all();
  }
}

Result<void> AngleSink::commit() {
  const std::scoped_lock writing(m_writing);
  std::vector<AngleSample> samples;
  std::vector<SampleGap> gaps;
  {
    const std::scoped_lock lock(m_mutex);
    samples.swap(m_samples);
    gaps.swap(m_gaps);
  }
  if (samples.empty() && gaps.empty()) {
    return {};
  }
  auto written = write(samples, gaps);
  const std::scoped_lock lock(m_mutex);
  if (written) {
    m_failure.reset();
    m_changed.notify_all();
    return {};
  }
  samples.insert(samples.end(), m_samples.begin(), m_samples.end());
  gaps.insert(gaps.end(), m_gaps.begin(), m_gaps.end());
  m_samples = std::move(samples);
  m_gaps = std::move(gaps);
  m_failure = written.error();
  return written;
}

Result<void> AngleSink::write(const std::vector<AngleSample>& samples, const std::vector<SampleGap>& gaps) {
  const std::scoped_lock lock(m_connection->mutex);
  Database& database = *m_connection->database;
  Transaction transaction(database);
  if (auto begun = transaction.begin(); !begun) {
    return begun;
  }
  if (auto deleted = m_connection->deleteCleared(); !deleted) {
    return deleted;
  }
  auto insert = database.prepare("INSERT INTO angle_sample(sweep, sequence, point, attempt, turn, direction, time_s, "
                                 "encoder_deg, sensor_deg, temperature_c) VALUES(?1,?2,?3,?4,?5,?6,?7,?8,?9,?10)");
  if (!insert) {
    return std::unexpected(std::move(insert.error()));
  }
  insert->bind(1, sweepNumber(m_role));
  for (const AngleSample& sample : samples) {
    insert->bind(2, sample.sequence);
    insert->bind(3, std::int64_t{sample.point});
    insert->bind(4, std::int64_t{sample.attempt});
    insert->bind(5, std::int64_t{sample.turn});
    insert->bind(6, std::int64_t{sample.direction});
    insert->bind(7, sample.timeS);
    insert->bind(8, sample.encoderDeg);
    insert->bind(9, sample.sensorDeg);
    sample.temperatureC ? insert->bind(10, *sample.temperatureC) : insert->bindNull(10);
    if (auto inserted = insert->execute(); !inserted) {
      return inserted;
    }
  }
  auto insertGap =
      database.prepare("INSERT INTO sample_gap(sweep, first_missing, count, reason) VALUES(?1, ?2, ?3, ?4)");
  if (!insertGap) {
    return std::unexpected(std::move(insertGap.error()));
  }
  insertGap->bind(1, sweepNumber(m_role));
  for (const SampleGap& gap : gaps) {
    insertGap->bind(2, gap.firstMissing);
    insertGap->bind(3, gap.count);
    insertGap->bind(4, gap.reason);
    if (auto inserted = insertGap->execute(); !inserted) {
      return inserted;
    }
  }
  if (auto committed = transaction.commit(); !committed) {
    return committed;
  }
  m_connection->clearingDone();
  return {};
}

void AngleSink::commitInTime(const std::stop_token& stop) {
  std::unique_lock lock(m_mutex);
  for (;;) {
    // After a failure only commit() tries again: a full disk is not hammered.
    if (!m_changed.wait(lock, stop, [this] { return !nothingPending() && !m_failure; })) {
      return;
    }
    const auto due = m_oldest + commitAfter;
    m_changed.wait_until(lock, stop, due, [this] { return nothingPending(); });
    if (stop.stop_requested()) {
      return;
    }
    if (!nothingPending() && std::chrono::steady_clock::now() >= m_oldest + commitAfter) {
      lock.unlock();
      std::ignore = commit(); // a failure is kept and told by the next call
      lock.lock();
    }
  }
}

} // namespace straightedge::session
