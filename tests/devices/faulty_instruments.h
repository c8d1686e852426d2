// Decorators that make a simulated instrument fail or tell when it is used.
#pragma once

#include "devices/instruments/angle_instruments.h"

#include <functional>
#include <map>

namespace straightedge::tests {

/// Counts readings from 1; before a reading its hook is called, and what the hook returns, if anything, is the outcome.
class HookedSensor : public devices::AngleSensor {
public:
  using Hook = std::function<std::optional<Result<devices::TimedReading>>()>;

  explicit HookedSensor(devices::AngleSensor& real) : m_real(real) {}
  void at(int reading, Hook hook) { m_hooks[reading] = std::move(hook); }
  void failAt(int reading, const std::string& what) {
    at(reading, [what] { return fail(ErrorKind::Instrument, what, "see to its cable"); });
  }

  devices::InstrumentIdentity identity() const override { return m_real.identity(); }
  Result<devices::TimedReading> readDeg() override {
    if (const auto hook = m_hooks.find(++m_count); hook != m_hooks.end()) {
      if (auto outcome = hook->second()) {
        return *outcome;
      }
    }
    return m_real.readDeg();
  }

private:
  devices::AngleSensor& m_real;
  std::map<int, Hook> m_hooks;
  int m_count = 0;
};

/// The same for blocks of a stream; the hook may change the block.
class HookedStream : public devices::AngleStream {
public:
  explicit HookedStream(devices::AngleStream& real) : m_real(real) {}
  void at(int block, std::function<void(devices::StreamBlock&)> hook) { m_hooks[block] = std::move(hook); }

  Result<void> start(const devices::StreamRequest& request) override { return m_real.start(request); }
  Result<devices::StreamBlock> read() override {
    auto block = m_real.read();
    if (const auto hook = m_hooks.find(++m_count); hook != m_hooks.end()) {
      hook->second(*block);
    }
    return block;
  }
  Result<void> stop() override { return m_real.stop(); }

private:
  devices::AngleStream& m_real;
  std::map<int, std::function<void(devices::StreamBlock&)>> m_hooks;
  int m_count = 0;
};

} // namespace straightedge::tests
