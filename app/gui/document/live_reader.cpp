#include "app/gui/document/live_reader.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace straightedge::gui {

namespace {

constexpr std::chrono::milliseconds readingPeriod{50};
constexpr std::chrono::milliseconds movingPeriod{20};
constexpr std::chrono::milliseconds failingPeriod{1000};
// Moved in small steps with a reading after each, so that the numbers follow the shaft.
constexpr double moveStepDeg = 4.0;
// A shaft still creeps when its stage says that it is there; on a virtual clock no time would pass for that.
constexpr double creepS = 0.03;

} // namespace

LiveReader::LiveReader(devices::AngleBench bench, QObject* parent)
    : QObject(parent), m_bench(std::move(bench)), m_thread([this](const std::stop_token& stop) { run(stop); }) {}

LiveReader::~LiveReader() = default;

void LiveReader::moveShaftTo(double encoderDeg) {
  {
    const std::lock_guard lock(m_mutex);
    m_targetDeg = encoderDeg;
  }
  m_wake.notify_one();
}

std::optional<double> LiveReader::pendingTarget() {
  const std::lock_guard lock(m_mutex);
  return m_targetDeg;
}

Result<double> LiveReader::readOnce() {
  const Result<devices::TimedReading> encoder = m_bench.reference->readDeg();
  if (!encoder) {
    return std::unexpected(encoder.error());
  }
  const Result<devices::TimedReading> sensor = m_bench.sensor->readDeg();
  if (!sensor) {
    return std::unexpected(sensor.error());
  }
  m_encoderDeg = encoder->value;
  return sensor->value;
}

Result<void> LiveReader::moveOneStep() {
  const std::optional<double> target = pendingTarget();
  if (!target || m_bench.stage == nullptr) {
    return {};
  }
  const double distance = *target - m_encoderDeg;
  const double step = std::clamp(distance, -moveStepDeg, moveStepDeg);
  const Result<void> moved = m_bench.stage->moveToDeg(m_encoderDeg + step);
  m_bench.clock->sleepS(creepS);
  const std::lock_guard lock(m_mutex);
  if (!moved || std::abs(distance) <= moveStepDeg) {
    if (m_targetDeg == target) { // a newer target stays
      m_targetDeg.reset();
    }
  }
  return moved;
}

void LiveReader::run(const std::stop_token& stop) {
  bool failing = false;
  while (!stop.stop_requested()) {
    Result<double> sensorDeg = readOnce();
    if (sensorDeg) {
      failing = false;
      emit reading(m_encoderDeg, *sensorDeg);
      if (const Result<void> moved = moveOneStep(); !moved) {
        emit failed(QString::fromStdString(moved.error().message()));
      }
    } else if (!failing) {
      failing = true;
      emit failed(QString::fromStdString(sensorDeg.error().message()));
    }
    std::unique_lock lock(m_mutex);
    const auto period = failing ? failingPeriod : (m_targetDeg ? movingPeriod : readingPeriod);
    const bool moving = m_targetDeg.has_value();
    m_wake.wait_for(lock, stop, period, [this, moving] { return !moving && m_targetDeg.has_value(); });
  }
}

} // namespace straightedge::gui
