// Samples in and out of a session.
#include "core/session/committing_sink.h"
#include "core/session/session_impl.h"

#include <utility>

namespace straightedge::session {

Result<std::int64_t> Session::angleSampleCount(SweepRole role) const {
  const std::scoped_lock lock(m_impl->connection->mutex);
  if (m_impl->connection->cleared.at(indexOf(role))) {
    return 0;
  }
  return m_impl->connection->database->integer("SELECT count(*) FROM angle_sample WHERE sweep = " +
                                               std::to_string(sweepNumber(role)));
}

Result<std::vector<AngleSample>> Session::angleSamples(SweepRole role) const {
  const auto count = angleSampleCount(role);
  if (!count) {
    return std::unexpected(count.error());
  }
  std::vector<AngleSample> samples;
  if (*count == 0) {
    return samples;
  }
  samples.reserve(static_cast<std::size_t>(*count));
  const std::scoped_lock lock(m_impl->connection->mutex);
  auto select = m_impl->connection->database->prepare(
      "SELECT sequence, point, attempt, turn, direction, time_s, encoder_deg, sensor_deg, temperature_c "
      "FROM angle_sample WHERE sweep = ?1 ORDER BY sequence");
  if (!select) {
    return std::unexpected(std::move(select.error()));
  }
  select->bind(1, sweepNumber(role));
  for (;;) {
    const auto row = select->step();
    if (!row) {
      return std::unexpected(row.error());
    }
    if (!*row) {
      return samples;
    }
    samples.push_back({.sequence = select->integer(0),
                       .point = static_cast<int>(select->integer(1)),
                       .attempt = static_cast<int>(select->integer(2)),
                       .turn = static_cast<int>(select->integer(3)),
                       .direction = static_cast<int>(select->integer(4)),
                       .timeS = select->real(5),
                       .encoderDeg = select->real(6),
                       .sensorDeg = select->real(7),
                       .temperatureC = select->optionalReal(8)});
  }
}

Result<std::vector<SampleGap>> Session::gaps(SweepRole role) const {
  const std::scoped_lock lock(m_impl->connection->mutex);
  std::vector<SampleGap> gaps;
  if (m_impl->connection->cleared.at(indexOf(role))) {
    return gaps;
  }
  auto select = m_impl->connection->database->prepare(
      "SELECT first_missing, count, reason FROM sample_gap WHERE sweep = ?1 ORDER BY first_missing");
  if (!select) {
    return std::unexpected(std::move(select.error()));
  }
  select->bind(1, sweepNumber(role));
  for (;;) {
    const auto row = select->step();
    if (!row) {
      return std::unexpected(row.error());
    }
    if (!*row) {
      return gaps;
    }
    gaps.push_back({select->integer(0), select->integer(1), select->text(2)});
  }
}

Result<void> Session::clearSamples(SweepRole role) {
  if (m_impl->readOnly) {
    return fail(ErrorKind::Storage, "the session was opened from a read-only place", "save it under another name first",
                m_impl->file.string());
  }
  const std::scoped_lock lock(m_impl->connection->mutex);
  m_impl->connection->cleared.at(indexOf(role)) = true;
  return {};
}

Result<std::unique_ptr<SampleSink>> Session::angleSink(SweepRole role) {
  if (m_impl->readOnly) {
    return fail(ErrorKind::Storage, "the session was opened from a read-only place", "save it under another name first",
                m_impl->file.string());
  }
  return std::make_unique<AngleSink>(m_impl->connection, role);
}

} // namespace straightedge::session
