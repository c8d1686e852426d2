#include "devices/instruments/line_source.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <utility>

namespace straightedge::devices {

namespace {

/// Arrivals that are taken in one go: on a line that brings more while they are, the rest comes with the next call.
constexpr int mostLineReads = 128;

} // namespace

Result<TimedValues> LineSource::fresh(Conversation& talk, Milliseconds deadline) {
  if (auto started = startStream(talk); !started) {
    return std::unexpected(std::move(started.error()));
  }
  const LineCounts before = m_reader.counts();
  const double untilS = talk.clock().nowS() + std::chrono::duration<double>(deadline).count();
  double leftS = untilS - talk.clock().nowS();
  do {
    const auto wait =
        std::max(Milliseconds{1}, std::chrono::duration_cast<Milliseconds>(std::chrono::duration<double>(leftS)));
    const auto bytes = talk.transport().read(wait);
    if (!bytes && bytes.error().fault == TransportFault::TimedOut) {
      const LineCounts& now = m_reader.counts();
      const bool linesCame = now.rejected + now.banner > before.rejected + before.banner + 1; // one was under way
      if (!linesCame) {
        return talk.failed(bytes.error(), {});
      }
      break;
    }
    if (!bytes) {
      return talk.failed(bytes.error(), {});
    }
    auto readings = m_reader.take(*bytes);
    if (!readings.empty()) {
      return TimedValues{std::move(readings.back()), talk.clock().nowS() - m_latencyS};
    }
    leftS = untilS - talk.clock().nowS();
  } while (leftS > 0.0);
  const std::string why = m_reader.lastFault() ? describe(*m_reader.lastFault(), m_reader.format()) : "";
  return talk.refused("no reading came within " + formatForPeople(std::chrono::duration<double>(deadline).count(), 3) +
                          " s" + (why.empty() ? "" : ", the last line was none: " + why),
                      "check the baud rate and which columns the board prints");
}

Result<void> LineSource::startStream(Conversation& talk) {
  if (auto cleared = talk.clear(); !cleared) {
    return cleared;
  }
  m_reader.startInsideLine();
  m_fault.reset();
  m_lastArrivalS = talk.clock().nowS();
  return {};
}

Result<std::vector<TimedValues>> LineSource::waiting(Conversation& talk) {
  if (const auto fault = std::exchange(m_fault, std::nullopt)) {
    return talk.failed(*fault, "while streaming");
  }
  std::vector<std::vector<double>> readings;
  double arrivalS = m_lastArrivalS;
  for (int i = 0; i < mostLineReads; ++i) {
    auto bytes = talk.transport().read(Milliseconds{0});
    if (!bytes && bytes.error().fault == TransportFault::TimedOut) {
      break;
    }
    if (!bytes && readings.empty()) {
      return talk.failed(bytes.error(), "while streaming");
    }
    if (!bytes) {
      m_fault = std::move(bytes.error());
      break;
    }
    arrivalS = talk.clock().nowS();
    m_reader.take(*bytes, readings);
  }
  std::vector<TimedValues> all;
  all.reserve(readings.size());
  const double stepS = readings.empty() ? 0.0 : (arrivalS - m_lastArrivalS) / static_cast<double>(readings.size());
  for (std::vector<double>& values : readings) {
    const auto number = static_cast<double>(all.size() + 1);
    all.push_back({std::move(values), m_lastArrivalS + stepS * number - m_latencyS});
  }
  m_lastArrivalS = all.empty() ? m_lastArrivalS : arrivalS;
  return all;
}

} // namespace straightedge::devices
