// The free-running part of CaptureWorker: the shaft turns, driven or by hand, and the bench samples by itself.
#include "core/base/number_text.h"
#include "devices/capture/capture_worker.h"
#include "devices/capture/stream_rate.h"

#include <array>
#include <cmath>
#include <utility>

namespace straightedge::devices {

namespace {

/// Two rates that differ by more are not the same.
constexpr double rateTolerance = 0.05;

/// Whole numbers as such: 100000, not 1e+05.
std::string rateText(double hz) { return hz == std::trunc(hz) ? std::to_string(std::llround(hz)) : formatDouble(hz); }

std::string angleText(double angleDeg) { return formatDouble(std::round(angleDeg * 1e3) / 1e3) + "°"; }

} // namespace

CaptureWorker::Step<void> CaptureWorker::measureRun(PointRun run) {
  StreamPass pass(m_course, run, m_bench.stage == nullptr);
  if (auto begun = beginPass(pass); !begun) {
    return begun;
  }
  m_standsAtDeg.reset();
  auto outcome = followPass(pass);
  // Whatever ended it, stage and stream stand still afterwards; the first fault is the one that is told.
  auto halted = m_bench.stage != nullptr ? fromInstrument(m_bench.stage->halt(), "stage") : Step<void>{};
  auto stopped = fromInstrument(m_bench.stream->stop(), "sampling");
  if (outcome) {
    outcome = halted ? std::move(stopped) : std::move(halted);
  }
  return outcome;
}

CaptureWorker::Step<void> CaptureWorker::beginPass(const StreamPass& pass) {
  const StreamRequest request{.rateHz = m_course.plan().sampleRateHz, .pairing = m_course.plan().pairing};
  if (m_bench.stage == nullptr) {
    return fromInstrument(m_bench.stream->start(request), "sampling");
  }
  if (auto there = travelTo(pass.fromDeg() - pass.direction() * takeUpDeg); !there) {
    return there;
  }
  if (auto settled = wait(m_course.plan().settleS); !settled) {
    return settled;
  }
  if (auto moving = fromInstrument(m_bench.stage->startMoveToDeg(pass.toDeg() + pass.direction() * takeUpDeg), "stage");
      !moving) {
    return moving;
  }
  auto started = fromInstrument(m_bench.stream->start(request), "sampling");
  if (!started) {
    static_cast<void>(m_bench.stage->halt()); // the first fault is the one that is told
  }
  return started;
}

CaptureWorker::Step<void> CaptureWorker::followPass(StreamPass& pass) {
  StreamRate rate;
  while (!pass.passed()) {
    m_note = streamNote(pass, rate.hz());
    if (auto waited = wait(lookAroundS / 4.0); !waited) {
      return waited;
    }
    // Asked before the samples are read: what is read afterwards reaches to the end of the move.
    const auto moving =
        m_bench.stage != nullptr ? fromInstrument(m_bench.stage->isMoving(), "stage") : Step<bool>(true);
    if (!moving) {
      return std::unexpected(moving.error());
    }
    const auto block = fromInstrument(m_bench.stream->read(), "sampling");
    if (!block) {
      return std::unexpected(block.error());
    }
    rate.add(*block);
    if (auto stored = storeStream(*block, pass); !stored) {
      return stored;
    }
    if (!pass.passed() && !*moving && block->samples.empty()) {
      return std::unexpected(
          Interruption{.fault = Error{ErrorKind::Instrument, "the stage stopped before the end of the sweep",
                                      "see whether the shaft is blocked, then resume", "stage"}});
    }
  }
  m_note = streamNote(pass, rate.hz());
  publishProgress();
  return {};
}

std::string CaptureWorker::streamNote(const StreamPass& pass, std::optional<double> rateHz) const {
  if (!pass.begun() && m_bench.stage == nullptr) {
    const std::string side = pass.direction() > 0 ? "below " : "above ";
    return "turn the shaft to " + side + angleText(pass.fromDeg()) + ", then steadily to " + angleText(pass.toDeg());
  }
  const double plannedHz = m_course.plan().sampleRateHz;
  if (!rateHz || std::abs(*rateHz / plannedHz - 1.0) <= rateTolerance) {
    return {};
  }
  return "the bench samples " + formatForPeople(*rateHz, 3) + " times a second instead of the plan's " +
         rateText(plannedHz) + ": its instruments have a rate of their own; every sample is stored";
}

/// Numbers are used up for what is missing, so that it shows wherever the samples do.
CaptureWorker::Step<void> CaptureWorker::recordGaps(const StreamBlock& block) {
  const std::array losses = {
      std::pair{block.lost, "the instrument's memory ran over"},
      std::pair{block.rejected, "what the instrument sent was no reading"},
      std::pair{block.unpaired, "no reading of the sensor close enough to the encoder's in time"}};
  for (const auto& [count, reason] : losses) {
    if (count <= 0) {
      continue;
    }
    if (auto recorded = fromSink(m_sink.recordGap({m_course.nextSequence, count, reason})); !recorded) {
      return recorded;
    }
    m_course.nextSequence += count;
  }
  return {};
}

CaptureWorker::Step<void> CaptureWorker::storeStream(const StreamBlock& block, StreamPass& pass) {
  std::vector<session::AngleSample> samples;
  samples.reserve(block.samples.size());
  for (const StreamedAngle& streamed : block.samples) {
    const auto sector = pass.place(streamed.encoderDeg);
    if (pass.passed()) {
      break;
    }
    if (!sector) {
      continue;
    }
    session::AngleSample sample;
    sample.point = *sector;
    sample.attempt = m_course.attempt(*sector);
    sample.turn = m_course.point(*sector).turn;
    sample.direction = pass.direction();
    sample.timeS = sampleTimeS(streamed.timeS);
    sample.encoderDeg = streamed.encoderDeg;
    sample.sensorDeg = streamed.sensorDeg;
    samples.push_back(sample);
  }
  // On the way to the first sector there is nothing to miss. Of the look in which it was reached it is not known what
  // came before: all of it is told.
  if (pass.begun()) {
    if (auto recorded = recordGaps(block); !recorded) {
      return recorded;
    }
  }
  if (auto stored = store(std::move(samples)); !stored) {
    return stored;
  }
  if (!block.samples.empty()) { // what belongs to nothing was read all the same: the shaft stands there now
    m_zero.seen(block.samples.back().encoderDeg);
  }
  publishProgress();
  return {};
}

} // namespace straightedge::devices
