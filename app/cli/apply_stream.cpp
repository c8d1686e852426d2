#include "app/cli/apply_stream.h"

#include "core/base/csv_text.h"
#include "core/base/file_bytes.h"
#include "core/base/file_output.h"
#include "core/base/line_blocks.h"

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace straightedge::cli {

namespace {

constexpr std::size_t startLookedAt = std::size_t{64} * 1024;

/// A block on its way: filled by the reader, corrected by a worker, written and given back in order.
struct Slot {
  std::string input;
  bool first = false;
  CorrectedBlock output;
  bool done = false; ///< guarded by the pool's mutex
};

/// Threads that correct slots. The slots belong to the calling thread; between give() and waitFor() to a worker.
class CorrectionPool {
public:
  CorrectionPool(const BlockCorrection& correction, unsigned threads) : m_correction(correction) {
    for (unsigned i = 0; i < std::max(1U, threads); ++i) {
      m_threads.emplace_back([this](const std::stop_token& stop) { work(stop); });
    }
  }
  ~CorrectionPool() {
    for (auto& thread : m_threads) {
      thread.request_stop();
    }
  }
  CorrectionPool(const CorrectionPool&) = delete;
  CorrectionPool& operator=(const CorrectionPool&) = delete;

  void give(Slot& slot) {
    {
      const std::scoped_lock lock(m_mutex);
      slot.done = false;
      m_waiting.push_back(&slot);
    }
    m_given.notify_one();
  }
  void waitFor(const Slot& slot) {
    std::unique_lock lock(m_mutex);
    m_finished.wait(lock, [&] { return slot.done; });
  }

private:
  void work(const std::stop_token& stop) {
    while (true) {
      Slot* slot = nullptr;
      {
        std::unique_lock lock(m_mutex);
        if (!m_given.wait(lock, stop, [this] { return !m_waiting.empty(); })) {
          return;
        }
        slot = m_waiting.front();
        m_waiting.pop_front();
      }
      m_correction.correct(slot->input, slot->first, slot->output);
      {
        const std::scoped_lock lock(m_mutex);
        slot->done = true;
      }
      m_finished.notify_one();
    }
  }

  const BlockCorrection& m_correction;
  std::mutex m_mutex;
  std::condition_variable_any m_given;
  std::condition_variable m_finished; ///< only the calling thread waits on it
  std::deque<Slot*> m_waiting;
  std::vector<std::jthread> m_threads; ///< last: stops before what it uses goes
};

/// The calling thread's side: reads ahead, writes behind.
class Stream {
public:
  Stream(LineBlocks blocks, PendingFile output, std::string name)
      : m_blocks(std::move(blocks)), m_output(std::move(output)), m_name(std::move(name)) {}

  Result<void> run(std::string start, const BlockCorrection& correction, unsigned threads);
  Result<void> commit() { return m_output.commit(); }
  const ApplyReport& report() const { return m_report; }

private:
  Result<void> writeOldest(CorrectionPool& pool);
  std::string place(std::size_t line) const { return m_name + ":" + std::to_string(line); }

  LineBlocks m_blocks;
  PendingFile m_output;
  std::string m_name;
  std::vector<Slot> m_slots;
  std::size_t m_given = 0;
  std::size_t m_written = 0;
  std::size_t m_lines = 0;
  ApplyReport m_report;
};

Result<void> Stream::writeOldest(CorrectionPool& pool) {
  const Slot& slot = m_slots[m_written % m_slots.size()];
  pool.waitFor(slot);
  m_lines += slot.output.lines;
  if (slot.output.problem) {
    Error error = *slot.output.problem;
    error.where = place(m_lines);
    return std::unexpected(std::move(error));
  }
  m_report.rows += slot.output.rows;
  m_report.bytesRead += slot.input.size();
  ++m_written;
  return m_output.write(slot.output.text());
}

Result<void> Stream::run(std::string start, const BlockCorrection& correction, unsigned threads) {
  m_slots.resize(2 * std::size_t{threads} + 2);
  m_slots.front().input = std::move(start);
  m_slots.front().first = true;
  CorrectionPool pool(correction, threads);
  bool more = true;
  while (more || m_written < m_given) {
    const bool full = m_given - m_written == m_slots.size();
    // While a pipe has nothing to read, what is ready goes out.
    if (m_given > m_written && (full || !more || !m_blocks.hasBytesReady())) {
      if (auto written = writeOldest(pool); !written) {
        return written;
      }
      continue;
    }
    Slot& slot = m_slots[m_given % m_slots.size()];
    if (m_given > 0) {
      slot.first = false;
      const auto read = m_blocks.next(slot.input);
      if (!read) {
        return std::unexpected(read.error());
      }
      more = *read;
    }
    if (more && !m_blocks.tooLong()) {
      pool.give(slot);
      ++m_given;
    }
    more = more && !m_blocks.tooLong();
  }
  if (m_blocks.tooLong()) {
    return fail(ErrorKind::Input, "the line is longer than " + std::to_string(longestCsvLine) + " characters",
                "name a CSV file with one reading in a line", place(m_lines + 1));
  }
  return {};
}

} // namespace

Result<ApplyReport> applyToReadings(const std::string& input, const std::string& output, const MakeCorrection& make,
                                    unsigned threads) {
  auto file = InputFile::open(input);
  if (!file) {
    return std::unexpected(std::move(file.error()));
  }
  const std::string name = inputName(input);
  LineBlocks blocks(std::move(*file));
  std::string start;
  if (auto read = blocks.next(start, startLookedAt); !read) {
    return std::unexpected(std::move(read.error()));
  }
  if (blocks.tooLong()) {
    return fail(ErrorKind::Input, "a line is longer than " + std::to_string(longestCsvLine) + " characters",
                "name a CSV file with one reading in a line, ended by LF or CRLF", name);
  }
  if (start.find('\n') == std::string::npos && start.find('\r') != std::string::npos) {
    return fail(ErrorKind::Input, "the lines end with CR alone", "save the file with LF or CRLF", name);
  }
  const auto correction = make(start, name);
  if (!correction) {
    return std::unexpected(correction.error());
  }
  auto pending = PendingFile::create(output);
  if (!pending) {
    return std::unexpected(std::move(pending.error()));
  }
  Stream stream(std::move(blocks), std::move(*pending), name);
  if (auto done = stream.run(std::move(start), **correction, std::max(1U, threads)); !done) {
    return std::unexpected(std::move(done.error()));
  }
  if (auto done = stream.commit(); !done) {
    return std::unexpected(std::move(done.error()));
  }
  return stream.report();
}

} // namespace straightedge::cli
