// What the window knows of a bench, whatever it measures: who fills its roles, how a capture goes.
#pragma once

#include "core/session/session.h"
#include "devices/instruments/angle_instruments.h"

#include <QObject>
#include <QString>

#include <vector>

namespace straightedge::gui {

/// One role of the connected bench and who fills it.
struct BenchInstrument {
  QString role; ///< "Sensor under calibration", "Reference encoder", "Stage"
  devices::InstrumentIdentity identity;
};

/// GUI thread. What is under calibration comes first in the list of instruments, its reference next where there is one.
class CaptureLink : public QObject {
  Q_OBJECT
public:
  virtual bool isConnected() const = 0;
  virtual bool isCapturing() const = 0;
  virtual QString benchName() const = 0; ///< "Simulated bench", …
  std::vector<BenchInstrument> instruments() const { return m_instruments; }
  QString describe() const; ///< instruments with model and serial, one per line

signals:
  void connectionChanged();
  void progressChanged();            ///< once per frame while capturing
  void samplesArrived(int firstNew); ///< index into liveSamples(); 0: everything anew
  void captureEnded(straightedge::session::SweepRole role);
  void failed(const QString& message);

protected:
  using QObject::QObject;
  std::vector<BenchInstrument> m_instruments;
};

} // namespace straightedge::gui
