// The body of the thread that captures a field campaign: the only one that touches bench and sink while it runs.
#pragma once

#include "devices/capture/capture_loop.h"
#include "devices/capture/field_capture.h"
#include "devices/capture/field_course.h"
#include "devices/capture/live_queue.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace straightedge::devices {

/// What controller and worker share. The mutex guards all of it but the queue.
struct FieldCaptureShared : CaptureControl {
  int stage = -1;
  std::string waitingFor;
  bool confirmed = false;
  FieldAction action = FieldAction::None;
  double target = 0.0;
  int rowsTaken = 0;
  std::vector<FieldStageProgress> stages;
  std::vector<std::pair<int, bool>> skipRequests;
  LiveQueueOf<session::FieldSample> queue;
};

class FieldWorker : public CaptureLoop {
public:
  FieldWorker(FieldBench bench, session::FieldSampleSink& sink, FieldCourse course, FieldCaptureShared& shared);

private:
  void takeRequests() override;
  bool requestsWait() const override;
  bool abandonsPresent() const override;
  bool isDone() const override { return !m_course.next(); }
  Step<void> measureNext() override;
  void forgetPositions() override;
  Result<void> commitSink() override { return m_sink.commit(); }
  double timeOffsetS() const override { return m_course.timeOffsetS; }
  void fillProgress(CaptureProgress& progress) override;

  void tell(FieldAction action, double target = 0.0);
  void tellRows(FieldTask task);
  Step<void> prepare(FieldTask task);
  Step<void> place(const FieldStage& stage);
  Step<void> setTemperatures(FieldTask task);
  Step<void> setTemperature(TemperatureChamber* chamber, std::optional<double>& at, double targetC, bool ofProbe);
  Step<void> setField(FieldTask task);
  Step<void> askFor(const std::string& instruction); ///< until a person confirms
  Step<void> measurePlateau(FieldTask task);
  Step<void> measureSweep(FieldTask task);
  Step<bool> takeRow(FieldTask task); ///< true: the reference was locked
  Step<void> fillTemperatures(const FieldReading& reading, bool withChamber, session::FieldSample& sample);
  Step<void> store(session::FieldSample sample);

  FieldBench m_bench;
  session::FieldSampleSink& m_sink;
  FieldCourse m_course;
  FieldCaptureShared& m_shared;
  std::vector<int> m_givenUp; ///< points of each stage without lock
  int m_present = -1;         ///< the stage that is measured
  std::int64_t m_samples = 0;

  // Where things stand; unknown at first and after a pause
  std::optional<ProbePlacement> m_placement;
  std::optional<double> m_fieldT;
  std::optional<double> m_probeC;       ///< sent to
  std::optional<double> m_electronicsC; ///< sent to
};

} // namespace straightedge::devices
