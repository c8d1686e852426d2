#include "devices/capture/field_capture.h"

#include "devices/capture/field_course.h"
#include "devices/capture/field_worker.h"

#include <algorithm>
#include <optional>
#include <pthread.h>
#include <thread>
#include <utility>

namespace straightedge::devices {

namespace {

Result<void> checkBench(const FieldBench& bench, const FieldPlan& plan) {
  if (bench.probe == nullptr || bench.clock == nullptr) {
    return fail(ErrorKind::Instrument, "the bench has no teslameter", "connect it", bench.name);
  }
  const bool needsNmr = std::any_of(plan.stages.begin(), plan.stages.end(),
                                    [](const FieldStage& stage) { return !stage.skipped && needsReference(stage); });
  if (needsNmr && bench.reference == nullptr) {
    return fail(ErrorKind::Instrument, "the bench has no reference field",
                "connect the reference teslameter, or leave out the stages that need it", bench.name);
  }
  return {};
}

} // namespace

struct FieldCapture::Impl {
  Impl(FieldBench givenBench, session::FieldSampleSink& givenSink) : bench(std::move(givenBench)), sink(givenSink) {}

  void startThread() {
    if (thread.joinable()) {
      thread.join(); // has ended: it was not running
    }
    shared.begin();
    thread = std::jthread([this](const std::stop_token& stop) {
      static_cast<void>(::pthread_setname_np(::pthread_self(), "capture")); // for debuggers and tests/bench
      worker->run(stop);
    });
  }
  void startAgainAfterTheEnd() {
    std::unique_lock lock(shared.mutex);
    if (shared.progress.state == CaptureState::Finished && worker) {
      lock.unlock();
      startThread();
    }
  }

  FieldBench bench;
  session::FieldSampleSink& sink;
  FieldCaptureShared shared;
  std::optional<FieldWorker> worker;
  std::jthread thread; // last: ends before what it uses
};

FieldCapture::FieldCapture(FieldBench bench, session::FieldSampleSink& sink)
    : m_impl(std::make_unique<Impl>(std::move(bench), sink)) {}

FieldCapture::~FieldCapture() = default;

Result<void> FieldCapture::start(const FieldPlan& plan, const std::vector<session::FieldSample>& already) {
  if (m_impl->shared.running()) {
    return fail(ErrorKind::Usage, "a capture is running", "stop it first", m_impl->bench.name);
  }
  if (auto checked = checkBench(m_impl->bench, plan); !checked) {
    return checked;
  }
  auto course = FieldCourse::make(plan, already);
  if (!course) {
    return std::unexpected(course.error());
  }
  if (m_impl->thread.joinable()) {
    m_impl->thread.join();
  }
  {
    const std::scoped_lock lock(m_impl->shared.mutex);
    m_impl->shared.progress = {};
    m_impl->shared.progress.pointsPlanned = course->planned();
    m_impl->shared.progress.pointsDone = course->done();
    m_impl->shared.progress.remainingS = course->remainingS();
    m_impl->shared.stage = -1;
    m_impl->shared.action = FieldAction::None;
    m_impl->shared.rowsTaken = 0;
    m_impl->shared.stages.clear();
  }
  m_impl->worker.emplace(m_impl->bench, m_impl->sink, *std::move(course), m_impl->shared);
  m_impl->startThread();
  return {};
}

void FieldCapture::pause() { m_impl->shared.pause(); }
void FieldCapture::resume() { m_impl->shared.resume(); }
void FieldCapture::stop() { m_impl->thread.request_stop(); }

void FieldCapture::confirm() {
  const std::scoped_lock lock(m_impl->shared.mutex);
  if (!m_impl->shared.waitingFor.empty()) {
    m_impl->shared.confirmed = true;
    m_impl->shared.waitingFor.clear(); // at once: what is asked for next is confirmed by its own
    m_impl->shared.changed.notify_all();
  }
}

void FieldCapture::redo(int stage) {
  m_impl->shared.requestRedo(stage);
  m_impl->startAgainAfterTheEnd();
}

void FieldCapture::skip(int stage, bool skipped) {
  {
    const std::scoped_lock lock(m_impl->shared.mutex);
    m_impl->shared.skipRequests.emplace_back(stage, skipped);
    m_impl->shared.changed.notify_all();
  }
  m_impl->startAgainAfterTheEnd();
}

void FieldCapture::waitUntilDone() { m_impl->shared.waitUntilDone(m_impl->thread); }

FieldCaptureProgress FieldCapture::progress() const {
  const std::scoped_lock lock(m_impl->shared.mutex);
  FieldCaptureProgress now;
  static_cast<CaptureProgress&>(now) = m_impl->shared.progress;
  now.samplesLost = m_impl->shared.queue.lost();
  now.stage = m_impl->shared.stage;
  now.waitingFor = m_impl->shared.waitingFor;
  now.action = m_impl->shared.action;
  now.target = m_impl->shared.target;
  now.rowsTaken = m_impl->shared.rowsTaken;
  now.stages = m_impl->shared.stages;
  return now;
}

std::vector<session::FieldSample> FieldCapture::takeNewSamples() { return m_impl->shared.queue.takeAll(); }

} // namespace straightedge::devices
