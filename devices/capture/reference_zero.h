// Guards the zero of a reference encoder that counts from where it was switched on: one sweep never mixes two zeros.
#pragma once

#include "core/base/error.h"
#include "core/session/sample_sink.h"
#include "devices/instruments/angle_instruments.h"

#include <optional>

namespace straightedge::devices {

/// An encoder that was unplugged may have lost its zero, and so may one with which a sweep is taken up again. Before
/// more of the sweep is stored it has to prove that it still has it:
/// - unplugged during the capture: the shaft stands still meanwhile, so it has to read what it read before, within one
///   and a half counts, at least `stillDeg`;
/// - else: the shaft has to be where the last sample was taken, within `nearDeg`, and the sensor, which knows its angle
///   by itself, has to have moved from that sample as far as the encoder, within `agreesDeg`.
/// Nothing is corrected: an encoder that fails has another zero, and its sweep is begun again. Encoders that know their
/// angle by themselves are never in doubt. Thread: the capture thread.
class ReferenceZero {
public:
  static constexpr double stillDeg = 0.02;
  static constexpr double nearDeg = 1.0;
  static constexpr double agreesDeg = 0.25;

  /// The reference must outlive this.
  explicit ReferenceZero(const AngleReference& reference) : m_reference(reference) {}

  void takeUp(const session::AngleSample& last) { m_last = last; } ///< the sweep has samples of an earlier run
  void seen(double encoderDeg); ///< a reading that was not in doubt, whether it is stored or not; NaN is none
  void stored(const session::AngleSample& sample);

  bool inDoubt() const;
  /// Both read now. No error: the zero is the old one.
  std::optional<Error> compare(double encoderDeg, double sensorDeg);

private:
  const AngleReference& m_reference;
  std::optional<session::AngleSample> m_last;
  std::optional<double> m_seenDeg; ///< last reading while the zero was known; none where the shaft may have moved since
  int m_knownFor = 0;              ///< timesOpened() for which the zero is known
};

} // namespace straightedge::devices
