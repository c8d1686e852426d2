// The bench as the window sees it: connection, live reading, capture. One for the whole window.
#pragma once

#include "core/base/error.h"
#include "core/session/session.h"
#include "devices/capture/angle_capture.h"
#include "devices/simulated/simulated_angle_bench.h"

#include <QObject>
#include <QString>

#include <memory>
#include <vector>

namespace straightedge::gui {

class AngleDocument;

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
  Result<void> connectSimulated(const devices::SimulatedAngleSettings& settings);
  void disconnectBench();
  const devices::SimulatedAngleSettings& simulatedSettings() const;

  /// Live reading while connected and not capturing, about 20 times a second.
  void setLiveReading(bool on);

  /// Starts capturing into the document's session. `resume` goes on with the plan after the committed samples.
  Result<void> startCapture(const devices::AnglePlan& plan, session::SweepRole role, bool resume);
  void pauseCapture();
  void resumeCapture();
  void stopCapture();
  void redoPoint(int pointIndex);
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
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace straightedge::gui
