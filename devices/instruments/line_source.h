// A board that prints lines by itself: a fresh reading, or everything that came.
#pragma once

#include "devices/instruments/conversation.h"
#include "devices/instruments/line_reader.h"

#include <optional>
#include <vector>

namespace straightedge::devices {

struct TimedValues {
  std::vector<double> values; ///< the columns of the format
  double timeS = 0.0;
};

/// Times are those of arrival minus the board's latency; readings that arrive together are spread evenly over the time
/// since the arrival before, for a board prints at a steady rate. One thread.
class LineSource {
public:
  LineSource(LineFormat format, double latencyS) : m_reader(std::move(format)), m_latencyS(latencyS) {}

  /// A reading whose line began after this call: what waits is thrown away, and so is the line under way.
  /// Errors: the transport's; lines came within the deadline and none was a reading (what the last one was).
  Result<TimedValues> fresh(Conversation& talk, Milliseconds deadline);

  /// From now on: everything. To be called before the first waiting().
  Result<void> startStream(Conversation& talk);
  /// What came since; does not wait for more. What came before a fault is handed out first, the fault with the next
  /// call.
  Result<std::vector<TimedValues>> waiting(Conversation& talk);

  const LineFormat& format() const { return m_reader.format(); }
  const LineCounts& counts() const { return m_reader.counts(); }

private:
  LineReader m_reader;
  double m_latencyS;
  double m_lastArrivalS = 0.0;
  std::optional<TransportError> m_fault; ///< came behind the readings that were handed out last
};

} // namespace straightedge::devices
