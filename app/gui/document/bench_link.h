// The bench as the window sees it: connection, live reading, capture. One for the whole window.
#pragma once

#include "core/base/error.h"
#include "core/session/session.h"
#include "devices/capture/angle_capture.h"
#include "devices/simulated/simulated_angle_bench.h"

#include <QObject>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace straightedge::gui {

class AngleDocument;

/// One role of the connected bench and who fills it.
struct BenchInstrument {
  QString role; ///< "Sensor under calibration", "Reference encoder", "Stage"
  devices::InstrumentIdentity identity;
};

/// GUI thread. Talks to instruments only through the capture thread (or a job while idle); empties the queue once per
/// frame.
class BenchLink : public QObject {
  Q_OBJECT
public:
  explicit BenchLink(AngleDocument& document, QObject* parent = nullptr);
  ~BenchLink() override; ///< stops the capture, commits

  bool isConnected() const;
  QString benchName() const; ///< "Simulated bench", …
  QString describe() const;  ///< instruments with model and serial, one per line
  std::vector<BenchInstrument> instruments() const;
  Result<void> connectSimulated(const devices::SimulatedAngleSettings& settings);
  /// Any other bench; `owner` keeps its instruments alive while connected. Where its instruments can be unplugged
  /// (AngleBench::connection) its owner reads it while it is idle, and there is no liveReading() from here. Errors
  /// (Usage): a role that must be filled is empty; a capture is running.
  Result<void> connectBench(devices::AngleBench bench, std::shared_ptr<void> owner);
  bool isSimulated() const; ///< connected to the simulated bench
  bool hasStage() const;    ///< false: the shaft is turned by hand
  void disconnectBench();   ///< stops a running capture first; what was captured stays
  const devices::SimulatedAngleSettings& simulatedSettings() const;

  /// Live reading while connected and not capturing, about 20 times a second.
  void setLiveReading(bool on);
  bool canMoveShaft() const;           ///< connected, idle, and the bench has a stage
  void moveShaftTo(double encoderDeg); ///< while idle; returns at once, the live reading follows

  /// Starts capturing into the document's session. `resume` goes on with the plan after the committed samples.
  Result<void> startCapture(const devices::AnglePlan& plan, session::SweepRole role, bool resume);
  void pauseCapture();
  void resumeCapture();
  void stopCapture();
  void stopAndWait(); ///< before the session closes: ends the capture, commits, and returns when both are done
  /// The plan of a sweep in the session that was begun and not carried out to the end; empty while capturing.
  std::optional<devices::AnglePlan> interruptedPlan(session::SweepRole role) const;
  /// Role and plan of the running or last capture.
  session::SweepRole captureRole() const;
  const devices::AnglePlan& capturePlan() const;
  void redoPoint(int pointIndex); ///< while capturing, or afterwards: measures one planned point again
  bool isCapturing() const;
  devices::CaptureProgress progress() const;
  const std::vector<session::AngleSample>& liveSamples() const; ///< of the running or last capture

signals:
  void connectionChanged();
  void liveReading(double encoderDeg, double sensorDeg);
  void progressChanged();
  void samplesArrived(int firstNew); ///< index into liveSamples()
  void captureEnded(straightedge::session::SweepRole role);
  void failed(const QString& message);

private:
  Result<void> beginCapture(const devices::AnglePlan& plan, session::SweepRole role, bool resume,
                            std::optional<int> redo);
  void endCapture();
  void onFrame();
  void onDocumentOpened();
  Result<void> useBench(devices::AngleBench bench, std::shared_ptr<void> owner, bool simulated);
  void updateLiveReading();

  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace straightedge::gui
