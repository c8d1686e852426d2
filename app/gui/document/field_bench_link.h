// The field bench as the window sees it: connection, live reading, capture of a campaign. One for the whole window.
#pragma once

#include "app/gui/document/bench_link_of.h"
#include "app/gui/document/field_live_reader.h"
#include "devices/capture/field_capture.h"
#include "devices/simulated/simulated_field_bench.h"

namespace straightedge::gui {

class FieldDocument;

/// What the capture of a campaign is made of.
struct FieldCaptureKind {
  using Bench = devices::FieldBench;
  using Plan = devices::FieldPlan;
  using Sample = session::FieldSample;
  using Sink = session::FieldSampleSink;
  using Capture = devices::FieldCapture;
  using Progress = devices::FieldCaptureProgress;
  using Reader = FieldLiveReader;
  static auto samples(const session::Session& session, session::SweepRole role) { return session.fieldSamples(role); }
  static auto sampleCount(const session::Session& session, session::SweepRole role) {
    return session.fieldSampleCount(role);
  }
  static auto sink(session::Session& session, session::SweepRole role) { return session.fieldSink(role); }
  static auto record(const session::Session& session, session::SweepRole role) {
    return readFieldCaptureRecord(session, role);
  }
};

/// GUI thread. The destructor stops the capture and commits. What it leaves in the session is what the command line
/// leaves: a campaign begun by one is gone on with by the other.
class FieldBenchLink : public BenchLinkOf<FieldCaptureKind> {
  Q_OBJECT
public:
  explicit FieldBenchLink(FieldDocument& document, QObject* parent = nullptr);
  ~FieldBenchLink() override;

  Result<void> connectSimulated(const devices::SimulatedFieldSettings& settings);
  /// Any other bench; `owner` keeps its instruments alive while connected. Errors (Usage): there is no teslameter; a
  /// capture is running.
  Result<void> connectBench(devices::FieldBench bench, std::shared_ptr<void> owner);
  /// Of the simulated bench that is connected, was connected last, or that the open session was captured on.
  const devices::SimulatedFieldSettings& simulatedSettings() const { return m_settings; }
  bool isSimulated() const { return !m_simulated.expired(); }
  bool inRealTime() const { return !isSimulated() || m_settings.realTime; }
  bool hasReference() const { return m_bench.reference != nullptr; }

  // While idle and live; they return at once, the live reading follows
  bool canSetField() const;
  void setFieldT(double fieldT);
  bool canPlaceProbe() const;
  void placeProbe(devices::ProbePlacement placing);

  /// What progress().waitingFor asks for is done.
  void confirm();
  /// While capturing, or afterwards: measures this stage of the calibration campaign again.
  void redoStage(int stage);
  /// Leaves a stage out or takes it back in: of the running capture, else of the campaign in the session, else of the
  /// document's plan. Rows stay.
  void skipStage(int stage, bool skipped);

signals:
  void liveReading(const straightedge::gui::FieldLiveReading& reading); ///< about 10 times a second

private:
  void connectReader(const FieldLiveReader& reader) override;
  Result<void> prepareCapture(session::Session& session, bool resume, std::size_t samplesAlready) override;
  Result<void> renewSimulated(session::Session& session, bool resume, std::size_t samplesAlready);
  void takeSamplesIn(session::SweepRole role) override;
  void skipInSession(session::Session& session, FieldCaptureRecord record, int stage, bool skipped);
  void useSettingsOfSession();

  FieldDocument& m_document;
  devices::SimulatedFieldSettings m_settings;
  std::weak_ptr<devices::SimulatedFieldBench> m_simulated; ///< while it is the connected one
};

} // namespace straightedge::gui
