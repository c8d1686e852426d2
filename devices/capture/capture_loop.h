// The body of a capture thread, whatever is captured: pause, stop, faults, commits in time.
#pragma once

#include "devices/capture/capture_control.h"
#include "devices/instruments/angle_instruments.h"
#include "devices/instruments/bench_connection.h"

#include <chrono>
#include <expected>
#include <optional>
#include <stop_token>
#include <type_traits>

namespace straightedge::devices {

/// Measures what the derived class says comes next, until all is done, the capture is stopped or the sink fails. A
/// fault of an instrument pauses it with everything committed; what was interrupted is begun again. Where the bench has
/// a connection: a time-out is first tried again as often as the plan says, and an instrument that was unplugged is
/// waited for.
class CaptureLoop {
public:
  virtual ~CaptureLoop() = default;
  CaptureLoop(const CaptureLoop&) = delete;
  CaptureLoop& operator=(const CaptureLoop&) = delete;

  /// May be run again, for what is asked for after the end.
  void run(const std::stop_token& stop);

protected:
  /// Why a measurement ended early. Without an error: pause or stop was asked for.
  struct Interruption {
    std::optional<Error> fault = std::nullopt;
    bool ofStorage = false;
    bool lookAgain = false; ///< neither fault nor pause: what comes next has changed
  };
  template <typename T>
  using Step = std::expected<T, Interruption>;

  CaptureLoop(BenchClock& clock, CaptureControl& control, BenchConnection* connection, int retries)
      : m_clock(clock), m_control(control), m_connection(connection), m_retries(retries), m_retriesLeft(retries) {}

  virtual void takeRequests() = 0;   ///< redo and the like
  virtual bool requestsWait() const; ///< under the control's mutex
  /// What is being measured now is not wanted any more: leave it, also in the middle of a wait.
  virtual bool abandonsPresent() const { return false; }
  virtual bool isDone() const = 0; ///< nothing left to measure
  virtual Step<void> measureNext() = 0;
  virtual void forgetPositions() = 0; ///< whoever pauses may turn the shaft, move the probe, …
  virtual Result<void> commitSink() = 0;
  virtual double timeOffsetS() const = 0;                   ///< of the samples that were there at the start
  virtual void fillProgress(CaptureProgress& progress) = 0; ///< under the control's mutex; points and samples

  template <typename T>
  static Step<T> fromInstrument(Result<T> outcome, const char* who) {
    if (outcome) {
      if constexpr (std::is_void_v<T>) {
        return {};
      } else {
        return *std::move(outcome);
      }
    }
    return std::unexpected(instrumentFault(std::move(outcome.error()), who));
  }
  static Interruption instrumentFault(Error error, const char* who);
  static Step<void> fromSink(Result<void> outcome);

  Step<void> wait(double seconds);
  Step<void> checkInterruption() const;
  const std::stop_token& stopToken() const { return m_stop; }
  void samplesAppended(); ///< starts the time until they are to be committed
  Step<void> commitIfDue();
  Step<void> commit();
  double sampleTimeS(double benchTimeS) const;
  void publishProgress();

  /// Longest time without a look at pause, stop and uncommitted samples.
  static constexpr double lookAroundS = 0.02;

private:
  bool finish();                          ///< false: there is something to measure again
  bool tryAgain(const Interruption& why); ///< a time-out, and the plan allows another try
  bool isUnplugged(const Interruption& why) const;
  bool awaitInstrument(const std::stop_token& stop, Error fault);     ///< false: stopped meanwhile
  bool rest(const std::stop_token& stop, std::optional<Error> fault); ///< paused; false: stopped meanwhile
  void end(CaptureState state, std::optional<Error> fault = std::nullopt);

  BenchClock& m_clock;
  CaptureControl& m_control;
  BenchConnection* m_connection; ///< may be null
  int m_retries;
  int m_retriesLeft;
  std::stop_token m_stop;
  std::optional<double> m_startS; ///< bench clock at the first run
  std::optional<std::chrono::steady_clock::time_point> m_oldestUncommitted;
};

} // namespace straightedge::devices
