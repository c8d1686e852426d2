#include "devices/capture/capture_worker.h"

#include "core/base/number_text.h"
#include "devices/instruments/reading_pairing.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace straightedge::devices {

namespace {

/// A shaft turned by hand counts as still while it moves less than this between two looks.
constexpr double handStillDeg = 0.02;
/// A pair that the rule rejects is read again so often.
constexpr int pairTries = 20;

} // namespace

CaptureWorker::CaptureWorker(AngleBench bench, session::SampleSink& sink, CaptureCourse course, CaptureShared& shared)
    : CaptureLoop(*bench.clock, shared, bench.connection, course.plan().retries), m_bench(std::move(bench)),
      m_sink(sink), m_course(std::move(course)), m_shared(shared), m_zero(*m_bench.reference),
      m_doneAtStart(m_course.done()) {
  if (m_course.lastAlready) {
    m_zero.takeUp(*m_course.lastAlready);
  }
}

void CaptureWorker::takeRequests() {
  const std::scoped_lock lock(m_shared.mutex);
  for (const int index : m_shared.redoRequests) {
    m_course.redo(index);
  }
  m_shared.redoRequests.clear();
}

CaptureWorker::Step<void> CaptureWorker::measureNext() {
  if (auto sure = confirmZero(); !sure) {
    return sure;
  }
  return m_course.plan().sampleRateHz > 0.0 ? measureRun(*m_course.nextRun()) : measurePoint(*m_course.next());
}

CaptureWorker::Step<void> CaptureWorker::confirmZero() {
  if (!m_zero.inDoubt()) {
    return {};
  }
  const auto encoder = fromInstrument(m_bench.reference->readDeg(), "encoder");
  if (!encoder) {
    return std::unexpected(encoder.error());
  }
  const auto sensor = fromInstrument(m_bench.sensor->readDeg(), "sensor");
  if (!sensor) {
    return std::unexpected(sensor.error());
  }
  if (auto lost = m_zero.compare(encoder->value, sensor->value)) {
    return std::unexpected(instrumentFault(*std::move(lost), "encoder"));
  }
  return {};
}

CaptureWorker::Step<TimedReading> CaptureWorker::readEncoder() {
  auto reading = fromInstrument(m_bench.reference->readDeg(), "encoder");
  if (reading) {
    m_zero.seen(reading->value);
  }
  return reading;
}

CaptureWorker::Step<void> CaptureWorker::measurePoint(int index) {
  const PlannedPoint& point = m_course.point(index);
  if (auto there = m_bench.stage != nullptr ? approach(point.encoderDeg, point.direction) : waitForHand(point);
      !there) {
    return there;
  }
  if (auto settled = wait(m_course.plan().settleS); !settled) {
    return settled;
  }
  std::optional<double> temperatureC;
  if (m_bench.thermometer != nullptr) {
    const auto reading = fromInstrument(m_bench.thermometer->readC(), "thermometer");
    if (!reading) {
      return std::unexpected(reading.error());
    }
    temperatureC = reading->value;
  }
  for (int left = m_course.readingsMissing(index); left > 0; --left) {
    if (auto taken = readOnce(index, temperatureC); !taken) {
      return taken;
    }
    m_course.readingTaken(index);
    if (auto free = checkInterruption(); !free && left > 1) {
      return free;
    }
  }
  publishProgress();
  return {};
}

CaptureWorker::Step<void> CaptureWorker::readOnce(int index, std::optional<double> temperatureC) {
  const auto pair = m_course.plan().pairing.kind == PairingKind::Interpolate ? readInterpolated() : readAsRead();
  if (!pair) {
    return std::unexpected(pair.error());
  }
  const PlannedPoint& point = m_course.point(index);
  session::AngleSample sample;
  sample.point = index;
  sample.attempt = m_course.attempt(index);
  sample.turn = point.turn;
  sample.direction = point.direction;
  sample.timeS = sampleTimeS(pair->timeS);
  sample.encoderDeg = pair->encoderDeg;
  sample.sensorDeg = pair->sensorDeg;
  sample.temperatureC = temperatureC;
  return store({sample});
}

CaptureWorker::Step<StreamedAngle> CaptureWorker::readAsRead() {
  const auto encoder = readEncoder();
  if (!encoder) {
    return std::unexpected(encoder.error());
  }
  const auto sensor = fromInstrument(m_bench.sensor->readDeg(), "sensor");
  if (!sensor) {
    return std::unexpected(sensor.error());
  }
  return StreamedAngle{.timeS = sensor->timeS, .encoderDeg = encoder->value, .sensorDeg = sensor->value};
}

CaptureWorker::Step<StreamedAngle> CaptureWorker::readInterpolated() {
  const PairingRule& rule = m_course.plan().pairing;
  ReadingPairing pairing(rule);
  auto sensor = fromInstrument(m_bench.sensor->readDeg(), "sensor");
  for (int i = 0; sensor && i < pairTries; ++i) {
    pairing.addSensor(*sensor);
    const auto encoder = readEncoder();
    if (!encoder) {
      return std::unexpected(encoder.error());
    }
    pairing.addReference(*encoder);
    sensor = fromInstrument(m_bench.sensor->readDeg(), "sensor");
    if (!sensor) {
      break;
    }
    pairing.addSensor(*sensor);
    if (const auto pairs = pairing.takePairs(); !pairs.empty()) {
      return pairs.back();
    }
  }
  if (!sensor) {
    return std::unexpected(sensor.error());
  }
  return std::unexpected(Interruption{
      .fault = Error{ErrorKind::Instrument,
                     "no sensor readings within " + formatForPeople(rule.maxAgeS) +
                         " s before and after the encoder's, " + std::to_string(pairTries) + " times in a row",
                     "allow a greater age, correct the latencies in the bench, or pair readings as they are read",
                     m_bench.name}});
}

CaptureWorker::Step<void> CaptureWorker::approach(double angleDeg, int direction) {
  const bool onTheWay = m_standsAtDeg && m_cameFrom == direction && (angleDeg - *m_standsAtDeg) * direction > 0.0;
  if (!onTheWay) {
    if (auto back = travelTo(angleDeg - direction * takeUpDeg); !back) {
      return back;
    }
  }
  if (auto there = travelTo(angleDeg); !there) {
    return there;
  }
  m_standsAtDeg = angleDeg;
  m_cameFrom = direction;
  return {};
}

CaptureWorker::Step<void> CaptureWorker::travelTo(double angleDeg) {
  if (auto started = fromInstrument(m_bench.stage->startMoveToDeg(angleDeg), "stage"); !started) {
    return started;
  }
  for (;;) {
    const auto moving = fromInstrument(m_bench.stage->isMoving(), "stage");
    if (!moving) {
      return std::unexpected(moving.error());
    }
    if (!*moving) {
      return {};
    }
    if (auto waited = wait(lookAroundS / 10.0); !waited) {
      const auto halted = fromInstrument(m_bench.stage->halt(), "stage");
      return halted ? waited : halted;
    }
  }
}

CaptureWorker::Step<void> CaptureWorker::waitForHand(const PlannedPoint& point) {
  const double tolerance = m_course.stepDeg() / 4.0;
  std::optional<double> before;
  for (;;) {
    const auto reading = readEncoder();
    if (!reading) {
      return std::unexpected(reading.error());
    }
    const bool near = std::abs(reading->value - point.encoderDeg) <= tolerance;
    if (near && before && std::abs(reading->value - *before) <= handStillDeg) {
      return {};
    }
    before = reading->value;
    if (auto waited = wait(lookAroundS); !waited) {
      return waited;
    }
  }
}

CaptureWorker::Step<void> CaptureWorker::store(std::vector<session::AngleSample> samples) {
  if (samples.empty()) {
    return {};
  }
  for (session::AngleSample& sample : samples) {
    if (!std::isfinite(sample.encoderDeg) || !(sample.sensorDeg >= 0.0 && sample.sensorDeg <= 360.0)) {
      return std::unexpected(
          Interruption{.fault = Error{ErrorKind::Instrument, "a reading is not an angle from 0 to 360°",
                                      "see to wiring and settings of sensor and encoder, then resume", m_bench.name}});
    }
    sample.sensorDeg = sample.sensorDeg == 360.0 ? 0.0 : sample.sensorDeg;
    sample.sequence = m_course.nextSequence++;
  }
  if (auto appended = fromSink(m_sink.append(samples)); !appended) {
    return appended;
  }
  m_zero.stored(samples.back());
  samplesAppended();
  m_samples += static_cast<std::int64_t>(samples.size());
  m_shared.queue.push(std::move(samples));
  return commitIfDue();
}

void CaptureWorker::fillProgress(CaptureProgress& progress) {
  const int done = m_course.done();
  const int doneNow = done - m_doneAtStart;
  progress.pointsDone = done;
  progress.pointsPlanned = m_course.planned();
  progress.samples = m_samples;
  progress.samplesLost = m_shared.queue.lost();
  progress.note = m_note;
  if (doneNow >= 2) {
    progress.remainingS = progress.elapsedS / doneNow * (m_course.planned() - done);
  }
}

} // namespace straightedge::devices
