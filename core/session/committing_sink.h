// The sink of a session: takes samples without waiting for the disk and commits them in time by itself.
#pragma once

#include "core/session/session_impl.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace straightedge::session {

/// How samples of a kind become rows: the file's table and its columns.
template <typename Sample>
struct SampleTable {
  static const char* insertSql();                               ///< parameter 1 is the sweep
  static void bind(Statement& statement, const Sample& sample); ///< the rest
};
template <>
const char* SampleTable<AngleSample>::insertSql();
template <>
void SampleTable<AngleSample>::bind(Statement& statement, const AngleSample& sample);
template <>
const char* SampleTable<FieldSample>::insertSql();
template <>
void SampleTable<FieldSample>::bind(Statement& statement, const FieldSample& sample);

/// append() copies into memory; one short transaction writes what has gathered, at the latest `commitAfter` later, in
/// the sink's own thread, also while the instrument keeps the capture waiting. A failed write is told by the next
/// append() or commit(); its samples are kept and written with the next commit() that succeeds.
template <typename Sample>
class CommittingSink final : public SinkOf<Sample> {
public:
  static constexpr std::chrono::milliseconds commitAfter{300}; ///< leaves 0.2 s for the disk within the promised 0.5 s

  CommittingSink(std::shared_ptr<Connection> connection, SweepRole role);
  ~CommittingSink() override; ///< commits

  CommittingSink(const CommittingSink&) = delete;
  CommittingSink& operator=(const CommittingSink&) = delete;

  Result<void> append(std::span<const Sample> samples) override;
  Result<void> recordGap(const SampleGap& gap) override;
  Result<void> commit() override;

private:
  void commitInTime(const std::stop_token& stop);
  Result<void> write(const std::vector<Sample>& samples, const std::vector<SampleGap>& gaps);
  bool nothingPending() const { return m_samples.empty() && m_gaps.empty(); }
  void pendingGrew(bool wasEmpty);

  const std::shared_ptr<Connection> m_connection;
  const SweepRole m_role;

  std::mutex m_writing; ///< held while a batch is on its way to the disk; taken before m_mutex
  std::mutex m_mutex;   ///< guards what follows
  std::condition_variable_any m_changed;
  std::vector<Sample> m_samples; ///< not committed yet
  std::vector<SampleGap> m_gaps;
  std::chrono::steady_clock::time_point m_oldest;
  std::optional<Error> m_failure;

  std::jthread m_thread; // last: ends before what it uses
};

extern template class CommittingSink<AngleSample>;
extern template class CommittingSink<FieldSample>;
using AngleSink = CommittingSink<AngleSample>;
using FieldSink = CommittingSink<FieldSample>;

} // namespace straightedge::session
