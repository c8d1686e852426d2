// Samples of a field campaign in and out of a session.
#include "core/session/committing_sink.h"
#include "core/session/session_impl.h"

#include <utility>

namespace straightedge::session {

namespace {

std::optional<int> optionalInteger(const Statement& row, int column) {
  const auto value = row.optionalReal(column);
  return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
}

FieldSample sampleOf(const Statement& row) {
  return {.sequence = row.integer(0),
          .stage = static_cast<int>(row.integer(1)),
          .point = static_cast<int>(row.integer(2)),
          .attempt = static_cast<int>(row.integer(3)),
          .timeS = row.real(4),
          .step = static_cast<int>(row.integer(5)),
          .axis = optionalInteger(row, 6),
          .orientation = optionalInteger(row, 7),
          .locked = row.integer(8) != 0,
          .referenceT = row.optionalReal(9),
          .chamberC = row.optionalReal(10),
          .pt100Ohm = row.optionalReal(11),
          .electronicsC = row.optionalReal(12),
          .rawT = {row.real(13), row.real(14), row.real(15)}};
}

} // namespace

Result<std::int64_t> Session::fieldSampleCount(SweepRole role) const {
  // A session of an angle sensor holds none, and one of an older version that is only read lacks the table.
  if (m_impl->kind != SessionKind::Field) {
    return 0;
  }
  const std::scoped_lock lock(m_impl->connection->mutex);
  if (m_impl->connection->cleared.at(indexOf(role))) {
    return 0;
  }
  return m_impl->connection->database->integer("SELECT count(*) FROM field_sample WHERE sweep = " +
                                               std::to_string(sweepNumber(role)));
}

Result<std::vector<FieldSample>> Session::fieldSamples(SweepRole role) const {
  const auto count = fieldSampleCount(role);
  if (!count) {
    return std::unexpected(count.error());
  }
  std::vector<FieldSample> samples;
  if (*count == 0) {
    return samples;
  }
  samples.reserve(static_cast<std::size_t>(*count));
  const std::scoped_lock lock(m_impl->connection->mutex);
  auto select = m_impl->connection->database->prepare(
      "SELECT sequence, stage, point, attempt, time_s, step, axis, orientation, locked, reference_t, chamber_c, "
      "pt100_ohm, electronics_c, raw_x_t, raw_y_t, raw_z_t FROM field_sample WHERE sweep = ?1 ORDER BY sequence");
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
    samples.push_back(sampleOf(*select));
  }
}

Result<std::unique_ptr<FieldSampleSink>> Session::fieldSink(SweepRole role) {
  if (m_impl->readOnly) {
    return fail(ErrorKind::Storage, "the session was opened from a read-only place", "save it under another name first",
                m_impl->file.string());
  }
  return std::make_unique<FieldSink>(m_impl->connection, role);
}

} // namespace straightedge::session
