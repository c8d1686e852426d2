// Everything said with the instruments of a bench, kept for a console and for a bug report.
#pragma once

#include "devices/bench/bench_seat.h"

#include <chrono>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <vector>

namespace straightedge::gui {

/// Filled by the threads that use the bench, read by the window: any thread. The oldest entries go when there are too
/// many.
class DialogueLog {
public:
  static constexpr std::size_t mostEntries = 20'000;
  static constexpr std::size_t mostBytes = 16'000'000;

  struct Entry {
    std::size_t instrument = 0; ///< index into instruments()
    int connection = 1;
    double sinceS = 0.0;                        ///< since the log began
    std::chrono::system_clock::time_point when; ///< for people
    devices::DialogueEntry entry;
  };
  struct News {
    std::vector<Entry> entries;
    std::uint64_t next = 0; ///< to ask for what comes after them
  };

  void add(const devices::BenchExchange& exchange);
  void clear();

  std::vector<std::string> instruments() const; ///< in order of their first exchange
  News since(std::uint64_t number) const;       ///< entries from this number on, as far as they are still there

  /// What was said with one instrument, as a dialogue file that replay plays. Errors (Storage, Usage).
  Result<void> save(const std::string& path, std::size_t instrument) const;

private:
  struct Speaker {
    std::string name;
    std::string header; ///< of its dialogue file
    bool complete = true;
  };

  mutable std::mutex m_mutex; ///< guards what follows
  std::vector<Speaker> m_speakers;
  std::deque<Entry> m_entries;
  std::uint64_t m_first = 0; ///< number of the oldest entry that is kept
  std::size_t m_bytes = 0;
  const std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

} // namespace straightedge::gui
