#include "devices/capture/angle_capture.h"

#include "devices/capture/capture_course.h"
#include "devices/capture/capture_worker.h"

#include <optional>
#include <pthread.h>
#include <thread>
#include <utility>

namespace straightedge::devices {

namespace {

Result<void> checkBench(const AngleBench& bench, const AnglePlan& plan) {
  if (bench.sensor == nullptr || bench.reference == nullptr || bench.clock == nullptr) {
    return fail(ErrorKind::Instrument, "the bench has no sensor or no encoder", "connect both", bench.name);
  }
  if (plan.sampleRateHz > 0.0 && bench.stream == nullptr) {
    return fail(ErrorKind::Usage, "this bench cannot sample while the shaft turns",
                "set the sample rate to 0 to capture point by point", bench.name);
  }
  return {};
}

} // namespace

struct AngleCapture::Impl {
  Impl(AngleBench givenBench, session::SampleSink& givenSink) : bench(std::move(givenBench)), sink(givenSink) {}

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

  AngleBench bench;
  session::SampleSink& sink;
  CaptureShared shared;
  std::optional<CaptureWorker> worker;
  std::jthread thread; // last: ends before what it uses
};

AngleCapture::AngleCapture(AngleBench bench, session::SampleSink& sink)
    : m_impl(std::make_unique<Impl>(std::move(bench), sink)) {}

AngleCapture::~AngleCapture() = default;

Result<void> AngleCapture::start(const AnglePlan& plan, const std::vector<session::AngleSample>& already) {
  if (m_impl->shared.running()) {
    return fail(ErrorKind::Usage, "a capture is running", "stop it first", m_impl->bench.name);
  }
  if (auto checked = checkBench(m_impl->bench, plan); !checked) {
    return checked;
  }
  auto course = CaptureCourse::make(plan, already);
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
  }
  m_impl->worker.emplace(m_impl->bench, m_impl->sink, *std::move(course), m_impl->shared);
  m_impl->startThread();
  return {};
}

void AngleCapture::pause() { m_impl->shared.pause(); }
void AngleCapture::resume() { m_impl->shared.resume(); }
void AngleCapture::stop() { m_impl->thread.request_stop(); }

void AngleCapture::redo(int pointIndex) {
  m_impl->shared.requestRedo(pointIndex);
  if (progress().state == CaptureState::Finished && m_impl->worker) {
    m_impl->startThread();
  }
}

void AngleCapture::waitUntilDone() { m_impl->shared.waitUntilDone(m_impl->thread); }

CaptureProgress AngleCapture::progress() const {
  const std::scoped_lock lock(m_impl->shared.mutex);
  CaptureProgress now = m_impl->shared.progress;
  now.samplesLost = m_impl->shared.queue.lost();
  return now;
}

std::vector<session::AngleSample> AngleCapture::takeNewSamples() { return m_impl->shared.queue.takeAll(); }

} // namespace straightedge::devices
