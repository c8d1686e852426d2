// A simulated bench whose sensor cable can be pulled: after so many readings each further one fails until it is mended.
#pragma once

#include "devices/simulated/simulated_angle_bench.h"

#include <atomic>
#include <memory>

namespace straightedge::gui {

class FailingBench {
public:
  FailingBench(const devices::SimulatedAngleSettings& settings, int goodReadings)
      : m_simulated(settings), m_sensor(*m_simulated.bench().sensor, goodReadings) {}

  devices::AngleBench bench() {
    devices::AngleBench bench = m_simulated.bench();
    bench.name = "Failing bench";
    bench.sensor = &m_sensor;
    return bench;
  }
  void mend() { m_sensor.left = 1'000'000'000; }
  /// From now on a reading waits until letGo(): what happens in the middle of a capture is not left to speed.
  void hold() { m_sensor.held = true; }
  void letGo() {
    m_sensor.held = false;
    m_sensor.held.notify_all();
  }

private:
  struct Sensor : devices::AngleSensor {
    Sensor(devices::AngleSensor& behind, int readings) : sensor(behind), left(readings) {}
    devices::InstrumentIdentity identity() const override { return sensor.identity(); }
    Result<devices::TimedReading> readDeg() override {
      held.wait(true);
      if (left.fetch_sub(1) <= 0) {
        left = 0;
        return fail(ErrorKind::Instrument, "the sensor was unplugged", "plug it in again, then resume", "Sensor");
      }
      return sensor.readDeg();
    }
    devices::AngleSensor& sensor;
    std::atomic<int> left;
    std::atomic<bool> held = false;
  };

  devices::SimulatedAngleBench m_simulated;
  Sensor m_sensor;
};

} // namespace straightedge::gui
