// Where capture puts samples. Declared here so that capture knows the session's sink and the session knows no capture.
#pragma once

#include "core/base/error.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace straightedge::session {

/// One averaged or single reading of an angle sweep as it came from the bench.
struct AngleSample {
  std::int64_t sequence = 0; ///< 0, 1, 2, … in order of arrival, never reused within a session
  int point = 0;             ///< index of the plan's point this sample belongs to (see capture plan)
  int attempt = 0;           ///< 0, or 1, 2, … after "redo this point"; only the latest attempt counts
  int turn = 0;
  int direction = 1;       ///< +1 rising encoder, −1 falling
  double timeS = 0.0;      ///< seconds since the capture's start, monotonic over resumes
  double encoderDeg = 0.0; ///< may exceed 360 over several turns
  double sensorDeg = 0.0;  ///< [0, 360)
  std::optional<double> temperatureC;
};

/// One row of a field campaign as it came from the bench. Step, axis and orientation are the numbers of
/// field::CampaignStep, field::Axis and field::Orientation, in that order, which never changes; a value that nothing
/// measured is absent.
struct FieldSample {
  std::int64_t sequence = 0; ///< as of AngleSample
  int stage = 0;             ///< index of the plan's stage
  int point = 0;             ///< index of the plateau or sweep within the stage
  int attempt = 0;           ///< of the stage: 0, or 1, 2, … after "measure this stage again"; only the latest counts
  double timeS = 0.0;        ///< seconds since the capture's start, monotonic over resumes
  int step = 0;
  std::optional<int> axis;
  std::optional<int> orientation;
  bool locked = false;              ///< of the reference
  std::optional<double> referenceT; ///< signed; absent where not locked
  std::optional<double> chamberC;
  std::optional<double> pt100Ohm;
  std::optional<double> electronicsC;
  std::array<double, 3> rawT = {0.0, 0.0, 0.0};

  bool operator==(const FieldSample&) const = default;
};

/// Samples that were lost: recorded with their number, never hidden.
struct SampleGap {
  std::int64_t firstMissing = 0;
  std::int64_t count = 0;
  std::string reason;
};

/// Thread: called from the capture thread only. An error stops the capture and is shown; nothing is dropped silently.
template <typename Sample>
class SinkOf {
public:
  virtual ~SinkOf() = default;
  virtual Result<void> append(std::span<const Sample> samples) = 0;
  virtual Result<void> recordGap(const SampleGap& gap) = 0;
  /// Makes everything appended so far durable. Capture calls it at least every 0.5 s and at pause and end.
  virtual Result<void> commit() = 0;
};
using SampleSink = SinkOf<AngleSample>;
using FieldSampleSink = SinkOf<FieldSample>;

} // namespace straightedge::session
