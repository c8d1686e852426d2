// A dialogue as a driver has to lead it, in a few lines of test: "> sent", "< received", "x", "!< timed-out".
#pragma once

#include "devices/instruments/angle_instruments.h"
#include "devices/transport/replay_transport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace straightedge::devices {

/// Goes on by 1 ms whenever it is looked at, so that nothing in a test waits.
class SteppingClock : public BenchClock {
public:
  double nowS() const override { return m_nowS += 0.001; }
  void sleepS(double seconds) override {
    m_nowS += seconds;
    sleptS += seconds;
  }
  double sleptS = 0.0;

private:
  mutable double m_nowS = 0.0;
};

/// `messages`: as USBTMC has them. `then` follows `first`, where a set-up is common to several tests.
inline ReplayTransport script(const std::vector<std::string>& first, bool messages = false,
                              const std::vector<std::string>& then = {}) {
  std::string text =
      std::string("straightedge-dialogue 1\ntransport test line\nmessages ") + (messages ? "yes" : "no") + "\n";
  const auto add = [&](const std::string& exchange) {
    text += "0 " + exchange + (exchange.starts_with("!<") ? ": nothing came; wait" : "") + "\n";
  };
  std::ranges::for_each(first, add);
  std::ranges::for_each(then, add);
  auto dialogue = parseDialogue(text, "script");
  EXPECT_TRUE(dialogue) << (dialogue ? "" : dialogue.error().message());
  return {dialogue ? *std::move(dialogue) : Dialogue{}, "script"};
}

inline void expectPlayed(const ReplayTransport& transport) {
  const auto finished = transport.finished();
  EXPECT_TRUE(finished) << (finished ? "" : finished.error().message());
}

/// The problem in words; empty if there is none.
template <typename T>
std::string problemOf(const Result<T>& result) {
  return result ? std::string() : result.error().message();
}

} // namespace straightedge::devices
