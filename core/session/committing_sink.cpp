#include "core/session/committing_sink.h"

#include <pthread.h>
#include <utility>

namespace straightedge::session {

namespace {

/// More than this is written at once rather than gathered: 3 s at 10,000 samples a second.
constexpr std::size_t largestBatch = 32768;

void bindOptional(Statement& statement, int parameter, const std::optional<double>& value) {
  value ? statement.bind(parameter, *value) : statement.bindNull(parameter);
}

void bindOptional(Statement& statement, int parameter, const std::optional<int>& value) {
  value ? statement.bind(parameter, std::int64_t{*value}) : statement.bindNull(parameter);
}

} // namespace

template <>
const char* SampleTable<AngleSample>::insertSql() {
  return "INSERT INTO angle_sample(sweep, sequence, point, attempt, turn, direction, time_s, encoder_deg, sensor_deg, "
         "temperature_c) VALUES(?1,?2,?3,?4,?5,?6,?7,?8,?9,?10)";
}

template <>
void SampleTable<AngleSample>::bind(Statement& statement, const AngleSample& sample) {
  statement.bind(2, sample.sequence);
  statement.bind(3, std::int64_t{sample.point});
  statement.bind(4, std::int64_t{sample.attempt});
  statement.bind(5, std::int64_t{sample.turn});
  statement.bind(6, std::int64_t{sample.direction});
  statement.bind(7, sample.timeS);
  statement.bind(8, sample.encoderDeg);
  statement.bind(9, sample.sensorDeg);
  bindOptional(statement, 10, sample.temperatureC);
}

template <>
const char* SampleTable<FieldSample>::insertSql() {
  return "INSERT INTO field_sample(sweep, sequence, stage, point, attempt, time_s, step, axis, orientation, locked, "
         "reference_t, chamber_c, pt100_ohm, electronics_c, raw_x_t, raw_y_t, raw_z_t) "
         "VALUES(?1,?2,?3,?4,?5,?6,?7,?8,?9,?10,?11,?12,?13,?14,?15,?16,?17)";
}

template <>
void SampleTable<FieldSample>::bind(Statement& statement, const FieldSample& sample) {
  statement.bind(2, sample.sequence);
  statement.bind(3, std::int64_t{sample.stage});
  statement.bind(4, std::int64_t{sample.point});
  statement.bind(5, std::int64_t{sample.attempt});
  statement.bind(6, sample.timeS);
  statement.bind(7, std::int64_t{sample.step});
  bindOptional(statement, 8, sample.axis);
  bindOptional(statement, 9, sample.orientation);
  statement.bind(10, std::int64_t{sample.locked ? 1 : 0});
  bindOptional(statement, 11, sample.referenceT);
  bindOptional(statement, 12, sample.chamberC);
  bindOptional(statement, 13, sample.pt100Ohm);
  bindOptional(statement, 14, sample.electronicsC);
  statement.bind(15, sample.rawT[0]);
  statement.bind(16, sample.rawT[1]);
  statement.bind(17, sample.rawT[2]);
}

template <typename Sample>
CommittingSink<Sample>::CommittingSink(std::shared_ptr<Connection> connection, SweepRole role)
    : m_connection(std::move(connection)), m_role(role), m_thread([this](const std::stop_token& stop) {
        static_cast<void>(::pthread_setname_np(::pthread_self(), "session")); // for debuggers and tests/bench
        commitInTime(stop);
      }) {}

template <typename Sample>
CommittingSink<Sample>::~CommittingSink() {
  m_thread.request_stop();
  m_thread.join();
  std::ignore = commit();
}

template <typename Sample>
Result<void> CommittingSink<Sample>::append(std::span<const Sample> samples) {
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

template <typename Sample>
Result<void> CommittingSink<Sample>::recordGap(const SampleGap& gap) {
  const std::scoped_lock lock(m_mutex);
  if (m_failure) {
    return std::unexpected(*m_failure);
  }
  const bool wasEmpty = nothingPending();
  m_gaps.push_back(gap);
  pendingGrew(wasEmpty);
  return {};
}

template <typename Sample>
void CommittingSink<Sample>::pendingGrew(bool wasEmpty) {
  if (wasEmpty && !nothingPending()) {
    m_oldest = std::chrono::steady_clock::now();
    m_changed.notify_all();
  }
}

template <typename Sample>
Result<void> CommittingSink<Sample>::commit() {
  const std::scoped_lock writing(m_writing);
  std::vector<Sample> samples;
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

template <typename Sample>
Result<void> CommittingSink<Sample>::write(const std::vector<Sample>& samples, const std::vector<SampleGap>& gaps) {
  const std::scoped_lock lock(m_connection->mutex);
  Database& database = *m_connection->database;
  Transaction transaction(database);
  if (auto begun = transaction.begin(); !begun) {
    return begun;
  }
  if (auto deleted = m_connection->deleteCleared(); !deleted) {
    return deleted;
  }
  auto insert = database.prepare(SampleTable<Sample>::insertSql());
  if (!insert) {
    return std::unexpected(std::move(insert.error()));
  }
  insert->bind(1, sweepNumber(m_role));
  for (const Sample& sample : samples) {
    SampleTable<Sample>::bind(*insert, sample);
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

template <typename Sample>
void CommittingSink<Sample>::commitInTime(const std::stop_token& stop) {
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

template class CommittingSink<AngleSample>;
template class CommittingSink<FieldSample>;

} // namespace straightedge::session
