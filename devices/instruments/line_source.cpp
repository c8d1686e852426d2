#include "devices/instruments/line_source.h"

#include "core/base/number_text.h"

#include <algorithm>

namespace straightedge::devices {

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
  m_lastArrivalS = talk.clock().nowS();
  return {};
}

Result<std::vector<TimedValues>> LineSource::waiting(Conversation& talk) {
  std::vector<TimedValues> all;
  constexpr std::size_t enough = 1U << 16U; // readings: faster than we are, hand over what there is
  while (all.size() < enough) {
    const auto bytes = talk.transport().read(Milliseconds{1});
    if (!bytes && bytes.error().fault == TransportFault::TimedOut) {
      break;
    }
    if (!bytes) {
      if (!all.empty()) {
        break; // what came before the fault counts; the fault comes again with the next call
      }
      return talk.failed(bytes.error(), "while streaming");
    }
    auto readings = m_reader.take(*bytes);
    const double arrivalS = talk.clock().nowS();
    const double stepS = readings.empty() ? 0.0 : (arrivalS - m_lastArrivalS) / static_cast<double>(readings.size());
    for (std::size_t i = 0; i < readings.size(); ++i) {
      all.push_back({std::move(readings[i]), m_lastArrivalS + stepS * static_cast<double>(i + 1) - m_latencyS});
    }
    m_lastArrivalS = readings.empty() ? m_lastArrivalS : arrivalS;
  }
  return all;
}

} // namespace straightedge::devices
