// The angle bench as the window sees it: connection, live reading, capture. One for the whole window.
#pragma once

#include "app/gui/document/bench_link_of.h"
#include "app/gui/document/live_reader.h"
#include "devices/capture/angle_capture.h"
#include "devices/simulated/simulated_angle_bench.h"

namespace straightedge::gui {

class AngleDocument;

/// What an angle capture is made of.
struct AngleCaptureKind {
  using Bench = devices::AngleBench;
  using Plan = devices::AnglePlan;
  using Sample = session::AngleSample;
  using Sink = session::SampleSink;
  using Capture = devices::AngleCapture;
  using Progress = devices::CaptureProgress;
  using Reader = LiveReader;
  static auto samples(const session::Session& session, session::SweepRole role) { return session.angleSamples(role); }
  static auto sampleCount(const session::Session& session, session::SweepRole role) {
    return session.angleSampleCount(role);
  }
  static auto sink(session::Session& session, session::SweepRole role) { return session.angleSink(role); }
  static auto record(const session::Session& session, session::SweepRole role) {
    return readCaptureRecord(session, role);
  }
};

/// GUI thread. The destructor stops the capture and commits.
class BenchLink : public BenchLinkOf<AngleCaptureKind> {
  Q_OBJECT
public:
  explicit BenchLink(AngleDocument& document, QObject* parent = nullptr);
  ~BenchLink() override;

  Result<void> connectSimulated(const devices::SimulatedAngleSettings& settings);
  /// Any other bench; `owner` keeps its instruments alive while connected, and reads them while they are idle where
  /// they can be unplugged (AngleBench::connection): there is no liveReading() from here then. Errors (Usage): a role
  /// that must be filled is empty; a capture is running.
  Result<void> connectBench(devices::AngleBench bench, std::shared_ptr<void> owner);
  const devices::SimulatedAngleSettings& simulatedSettings() const { return m_settings; }

  bool isSimulated() const { return !m_simulated.expired(); }
  bool hasStage() const { return m_bench.stage != nullptr; } ///< false: the shaft is turned by hand

  bool canMoveShaft() const;           ///< connected, idle, live, and the bench has a stage
  void moveShaftTo(double encoderDeg); ///< while idle; returns at once, the live reading follows

  void redoPoint(int pointIndex); ///< while capturing, or afterwards: measures one planned point again

signals:
  void liveReading(double encoderDeg, double sensorDeg); ///< about 20 times a second

private:
  void connectReader(const LiveReader& reader) override;
  void takeSamplesIn(session::SweepRole role) override;

  AngleDocument& m_document;
  devices::SimulatedAngleSettings m_settings;
  std::weak_ptr<devices::SimulatedAngleBench> m_simulated; ///< while it is the connected one
};

} // namespace straightedge::gui
