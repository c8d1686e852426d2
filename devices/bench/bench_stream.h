// Encoder and sensor of an opened bench sampled together: by one board that prints both angles, or by two instruments
// that send readings by themselves.
#pragma once

#include "devices/bench/bench_seat.h"
#include "devices/instruments/reading_pairing.h"

#include <memory>
#include <optional>

namespace straightedge::devices {

/// Of two instruments: a sample is a reading of the reference, with the sensor's angle at its time (ReadingPairing), so
/// that the reference's rate is the stream's. Lines of the reference that were no reading are `rejected`; where the
/// sensor's are missing for longer than the rule allows, the reference's readings are `unpaired`. The instruments keep
/// the rate they have. One that says nothing for `longestSilenceS` is a time-out. The seats outlive this; after an
/// instrument has come back the stream is started again. Thread: the capture thread only.
class BenchStream final : public AngleStream {
public:
  static constexpr double longestSilenceS = 3.0;

  /// Null where the instruments on these seats send nothing by themselves; either seat may be null. They may be one.
  static std::unique_ptr<BenchStream> make(BenchSeat* reference, BenchSeat* sensor, const BenchClock& clock);

  Result<void> start(const StreamRequest& request) override;
  Result<StreamBlock> read() override;
  Result<void> stop() override;

private:
  /// One of the two instruments: its seat, and when it was heard last.
  struct Source {
    BenchSeat* seat = nullptr;
    InstrumentRole role = InstrumentRole::AngleReference;
    double heardS = 0.0;
  };

  BenchStream(BenchSeat& reference, BenchSeat& sensor, const BenchClock& clock, bool oneLine)
      : m_reference{&reference, InstrumentRole::AngleReference, 0.0},
        m_sensor{&sensor, InstrumentRole::AngleSensor, 0.0}, m_clock(clock), m_oneLine(oneLine) {}

  Result<StreamBlock> readOneLine();
  Result<ReadingBlock> readSource(Source& source);
  Result<void> checkSilence(Source& source, bool heard);

  Source m_reference;
  Source m_sensor;
  const BenchClock& m_clock;
  bool m_oneLine; ///< both angles by the reference's instrument
  ReadingPairing m_pairing{PairingRule{}};
  std::int64_t m_unpairedBefore = 0;
  std::optional<Error> m_fault; ///< came behind the samples that were handed out last
};

} // namespace straightedge::devices
