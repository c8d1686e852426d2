#include "app/gui/bench/role_reader.h"

#include <algorithm>
#include <chrono>

namespace straightedge::gui {

namespace {

// As the live displays count: 20 angles, 10 fields a second.
constexpr std::chrono::milliseconds rolePeriod{50};
constexpr std::chrono::milliseconds fieldRolePeriod{100};
constexpr std::chrono::milliseconds roleFailingPeriod{500};

} // namespace

RoleReader::RoleReader(std::shared_ptr<devices::OpenedBench> bench, Listener listener)
    : m_bench(std::move(bench)),
      m_period(m_bench->saved().filling(devices::InstrumentRole::FieldProbe) != nullptr ? fieldRolePeriod : rolePeriod),
      m_listener(std::move(listener)), m_thread([this](const std::stop_token& stop) { run(stop); }) {}

RoleReader::~RoleReader() = default;

void RoleReader::setReading(bool on) {
  const std::lock_guard lock(m_mutex);
  m_reading = on;
  m_wake.notify_all();
}

void RoleReader::say(std::size_t instrument, std::string bytes) {
  const std::lock_guard lock(m_mutex);
  m_commands.push_back({instrument, std::move(bytes)});
  m_wake.notify_all();
}

void RoleReader::silence() {
  {
    const std::lock_guard listening(m_listening);
    m_listener.reset();
  }
  m_thread.request_stop();
  setReading(false);
}

template <typename Call>
void RoleReader::tell(const Call& call) {
  const std::lock_guard listening(m_listening);
  if (m_listener) {
    call(*m_listener);
  }
}

bool RoleReader::stillWanted() {
  const std::lock_guard lock(m_mutex);
  return m_reading && m_commands.empty();
}

void RoleReader::run(const std::stop_token& stop) {
  std::unique_lock lock(m_mutex);
  while (!stop.stop_requested()) {
    if (!m_commands.empty()) {
      const Command command = std::move(m_commands.front());
      m_commands.pop_front();
      lock.unlock();
      auto answer = m_bench->say(command.instrument, command.bytes);
      tell([&](const Listener& listener) { listener.said(command.instrument, std::move(answer)); });
      lock.lock();
      continue;
    }
    if (!m_reading) {
      m_wake.wait(lock, stop, [this] { return m_reading || !m_commands.empty(); });
      continue;
    }
    lock.unlock();
    std::vector<RoleState> states = readAll(stop);
    const bool failing = std::ranges::any_of(states, [](const RoleState& state) { return state.fault.has_value(); });
    if (!states.empty()) {
      tell([&](const Listener& listener) { listener.read(std::move(states)); });
    }
    lock.lock();
    m_wake.wait_for(lock, stop, failing ? roleFailingPeriod : m_period,
                    [this] { return !m_reading || !m_commands.empty(); });
  }
}

std::vector<RoleState> RoleReader::readAll(const std::stop_token& stop) {
  std::vector<RoleState> states;
  for (const devices::BenchInstrument& instrument : m_bench->saved().instruments) {
    for (const devices::InstrumentRole role : instrument.roles) {
      if (stop.stop_requested() || !stillWanted()) {
        return {}; // half a round says less than none
      }
      auto reading = m_bench->readRole(role);
      if (reading) {
        states.push_back({role, *std::move(reading), std::nullopt});
      } else {
        states.push_back({role, std::nullopt, std::move(reading.error())});
      }
    }
  }
  if (!m_bench->allThere()) {
    if (const auto back = m_bench->restore(); !back) { // it is plugged in again and cannot be used
      for (RoleState& state : states) {
        if (state.fault) {
          state.fault = back.error();
        }
      }
    }
  }
  return states;
}

} // namespace straightedge::gui
