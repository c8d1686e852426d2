#include "devices/instruments/line_stream.h"

#include <utility>

namespace straightedge::devices {

namespace {

Result<void> startLines(const StreamedLines& from, std::int64_t& rejectedBefore) {
  auto started = from.lines->startStream(*from.talk);
  *from.streaming = started.has_value();
  rejectedBefore = from.lines->counts().rejected;
  return started;
}

std::int64_t rejectedSince(const StreamedLines& from, std::int64_t& before) {
  return from.lines->counts().rejected - std::exchange(before, from.lines->counts().rejected);
}

} // namespace

Result<void> LineReadings::start() { return startLines(m_from, m_rejectedBefore); }

Result<ReadingBlock> LineReadings::read() {
  const auto came = m_from.lines->waiting(*m_from.talk);
  if (!came) {
    return std::unexpected(came.error());
  }
  ReadingBlock block;
  block.readings.reserve(came->size());
  for (const TimedValues& reading : *came) {
    const double printed = reading.values[m_column];
    block.readings.push_back({m_unwrap == nullptr ? printed : m_unwrap->follow(printed), reading.timeS});
  }
  block.rejected = rejectedSince(m_from, m_rejectedBefore);
  return block;
}

Result<void> LineReadings::stop() {
  *m_from.streaming = false;
  return {};
}

Result<void> LineAngles::start(const StreamRequest& /*request*/) { return startLines(m_from, m_rejectedBefore); }

Result<StreamBlock> LineAngles::read() {
  const auto came = m_from.lines->waiting(*m_from.talk);
  if (!came) {
    return std::unexpected(came.error());
  }
  StreamBlock block;
  block.samples.reserve(came->size());
  for (const TimedValues& reading : *came) {
    const double encoder = reading.values[m_encoderColumn];
    block.samples.push_back({.timeS = reading.timeS,
                             .encoderDeg = m_unwrap == nullptr ? encoder : m_unwrap->follow(encoder),
                             .sensorDeg = wrapTurn(reading.values[m_sensorColumn])});
  }
  block.rejected = rejectedSince(m_from, m_rejectedBefore);
  return block;
}

Result<void> LineAngles::stop() {
  *m_from.streaming = false;
  return {};
}

} // namespace straightedge::devices
