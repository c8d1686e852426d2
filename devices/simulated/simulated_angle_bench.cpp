#include "devices/simulated/simulated_angle_bench.h"

#include "devices/simulated/simulated_world.h"

#include <cmath>

namespace straightedge::devices {

namespace {

/// What one reading takes on the virtual clock, so that no two samples have the same time.
constexpr double conversionS = 50e-6;

class SimulatedSensor : public AngleSensor {
public:
  SimulatedSensor(SimulatedWorld& world, bool realTime) : m_world(world), m_realTime(realTime) {}
  InstrumentIdentity identity() const override {
    return {"Simulated magnetic angle sensor", "SIM-S", STRAIGHTEDGE_VERSION};
  }
  Result<TimedReading> readDeg() override {
    if (!m_realTime) {
      m_world.clock().sleepS(conversionS);
    }
    const double now = m_world.clock().nowS();
    return TimedReading{m_world.sensorDeg(now), now};
  }

private:
  SimulatedWorld& m_world;
  bool m_realTime;
};

class SimulatedEncoder : public AngleReference {
public:
  explicit SimulatedEncoder(SimulatedWorld& world) : m_world(world) {}
  InstrumentIdentity identity() const override { return {"Simulated encoder", "SIM-E", STRAIGHTEDGE_VERSION}; }
  Result<TimedReading> readDeg() override {
    const double now = m_world.clock().nowS();
    return TimedReading{m_world.encoderDeg(now), now};
  }

private:
  SimulatedWorld& m_world;
};

class SimulatedStage : public RotaryStage {
public:
  explicit SimulatedStage(SimulatedWorld& world) : m_world(world) {}
  InstrumentIdentity identity() const override { return {"Simulated rotary stage", "SIM-R", STRAIGHTEDGE_VERSION}; }
  Result<void> moveToDeg(double angleDeg) override {
    m_world.moveTo(angleDeg);
    m_world.clock().sleepS(m_world.arrivalS() - m_world.clock().nowS());
    return {};
  }
  Result<void> startMoveToDeg(double angleDeg) override {
    m_world.moveTo(angleDeg);
    return {};
  }
  Result<bool> isMoving() override { return m_world.isMoving(); }
  Result<void> halt() override {
    m_world.halt();
    return {};
  }

private:
  SimulatedWorld& m_world;
};

class SimulatedThermometer : public Thermometer {
public:
  explicit SimulatedThermometer(SimulatedWorld& world) : m_world(world) {}
  Result<TimedReading> readC() override {
    const double now = m_world.clock().nowS();
    return TimedReading{m_world.ambientC(now), now};
  }

private:
  SimulatedWorld& m_world;
};

class SimulatedStream : public AngleStream {
public:
  explicit SimulatedStream(SimulatedWorld& world) : m_world(world) {}
  Result<void> start(const StreamRequest& request) override {
    m_world.startStream(request.rateHz);
    return {};
  }
  Result<StreamBlock> read() override { return m_world.readStream(); }
  Result<void> stop() override {
    m_world.stopStream();
    return {};
  }

private:
  SimulatedWorld& m_world;
};

} // namespace

struct SimulatedAngleBench::Impl {
  explicit Impl(const SimulatedAngleSettings& given)
      : settings(given), world(given), sensor(world, given.realTime), encoder(world), stage(world), thermometer(world),
        stream(world) {}

  SimulatedAngleSettings settings;
  SimulatedWorld world;
  SimulatedSensor sensor;
  SimulatedEncoder encoder;
  SimulatedStage stage;
  SimulatedThermometer thermometer;
  SimulatedStream stream;
};

SimulatedAngleBench::SimulatedAngleBench(const SimulatedAngleSettings& settings)
    : m_impl(std::make_unique<Impl>(settings)) {}

SimulatedAngleBench::~SimulatedAngleBench() = default;

AngleBench SimulatedAngleBench::bench() {
  return {.name = "Simulated bench",
          .sensor = &m_impl->sensor,
          .reference = &m_impl->encoder,
          .stage = &m_impl->stage,
          .thermometer = &m_impl->thermometer,
          .stream = &m_impl->stream,
          .clock = &m_impl->world.clock()};
}

const SimulatedAngleSettings& SimulatedAngleBench::settings() const { return m_impl->settings; }

double SimulatedAngleBench::trueSensorDeg(double shaftDeg) const {
  const double field = m_impl->world.field().fieldDeg(shaftDeg);
  const double turn = std::fmod(m_impl->settings.decreasing ? -field : field, 360.0);
  const double positive = turn < 0.0 ? turn + 360.0 : turn;
  return positive >= 360.0 ? 0.0 : positive;
}

double SimulatedAngleBench::trueCorrectionDeg(double readingDeg) const {
  const double difference = m_impl->world.field().shaftDeg(readingDeg) - readingDeg;
  const double wrapped = std::remainder(difference, 360.0); // in [−180, 180]
  return wrapped >= 180.0 ? wrapped - 360.0 : wrapped;
}

} // namespace straightedge::devices
