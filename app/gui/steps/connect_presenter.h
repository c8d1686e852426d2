// What the step Connect says and does, without widgets: the bench, its instruments, the live reading.
#pragma once

#include "app/gui/document/bench_link.h"
#include "app/gui/plots/plot_spec.h"
#include "app/gui/steps/connect_words.h"
#include "devices/bench/opened_bench.h"

#include <QList>
#include <QObject>
#include <QString>

#include <optional>

namespace straightedge::gui {

class AngleDocument;

/// GUI thread. Angles in degrees.
class ConnectPresenter : public QObject {
  Q_OBJECT
public:
  struct Reading {
    double encoderDeg = 0.0; ///< unwrapped
    double sensorDeg = 0.0;  ///< [0, 360)
  };

  ConnectPresenter(AngleDocument& document, BenchLink& bench, QObject* parent = nullptr);

  // Connection
  bool connected() const;
  bool mayChange() const; ///< no capture is running
  void connectSimulated(const devices::SimulatedAngleSettings& settings);
  void disconnectBench();
  QString statusText() const; ///< one line: what is connected, or what to do
  QString problem() const;    ///< the last thing that went wrong, with its remedy; empty after success
  QList<ConnectedInstrument> instruments() const;
  bool simulated() const; ///< connected to the simulated bench
  /// Real instruments that were opened: they become the bench, and the plan pairs readings as it says.
  bool useInstruments(const std::shared_ptr<devices::OpenedBench>& opened);
  void letGoOfInstruments(); ///< they are being closed; nothing else is disconnected
  bool usesInstruments(const devices::OpenedBench* opened) const { return opened != nullptr && m_opened == opened; }

  // Live reading
  void setShown(bool shown);                             ///< reads only while somebody looks
  void takeReading(double encoderDeg, double sensorDeg); ///< of instruments that somebody else reads
  void loseReading();                                    ///< there is none now: a number that stays would be made up
  std::optional<Reading> reading() const;
  QString encoderText() const; ///< "123.4567°", a dash without a reading
  QString sensorText() const;
  QString differenceText() const; ///< sensor − encoder in [−180°, 180°)
  QString noiseText() const;      ///< standard deviation while the shaft stands; a dash until there are enough readings
  PlotSpec tracePlot() const;     ///< sensor − encoder over the last readings, seconds before now
  bool canMoveShaft() const;
  void moveShaftTo(double encoderDeg); ///< the shortest way to this angle of the turn

  // Traceability
  QString traceabilitySummary() const; ///< lines of text; says what is not stated yet
  bool canTakeOverInstruments() const; ///< the bench tells model and serial that the document lacks or states otherwise
  void takeOverInstruments();

signals:
  void connectionChanged();
  void readingChanged();
  void problemChanged();
  void traceabilityChanged();

private:
  std::optional<BenchIdentities> identities() const;
  void setProblem(const QString& problem);

  AngleDocument& m_document;
  BenchLink& m_bench;
  bool m_wasCapturing = false;
  const devices::OpenedBench* m_opening = nullptr; ///< while the bench link is asked to take it
  const devices::OpenedBench* m_opened = nullptr;  ///< that the bench link holds; compared only
  QString m_problem;
  std::optional<Reading> m_reading;
  QList<double> m_differences; ///< oldest first, continuous, since the connection
  int m_steady = 0;            ///< newest readings during which the shaft stood still
};

} // namespace straightedge::gui
