// What the step Connect of a field calibration says and does, without widgets: the bench, its instruments, what every
// role reads now.
#pragma once

#include "app/gui/document/field_bench_link.h"
#include "app/gui/plots/plot_spec.h"
#include "app/gui/steps/connect_words.h"
#include "core/field/calibration.h"
#include "devices/bench/opened_bench.h"

#include <QList>
#include <QObject>
#include <QString>

#include <array>
#include <optional>

namespace straightedge::gui {

class FieldDocument;

/// GUI thread. Fields in tesla.
class FieldConnectPresenter : public QObject {
  Q_OBJECT
public:
  struct Value {
    QString name; ///< "reference", "pt100", …: never changes
    QString caption, text;
  };

  FieldConnectPresenter(FieldDocument& document, FieldBenchLink& bench, QObject* parent = nullptr);

  // Connection
  bool connected() const { return m_bench.isConnected(); }
  bool mayChange() const { return !m_bench.isCapturing(); } ///< no capture is running
  const devices::SimulatedFieldSettings& simulatedSettings() const { return m_bench.simulatedSettings(); }
  void connectSimulated(const devices::SimulatedFieldSettings& settings);
  bool simulated() const { return m_bench.isSimulated(); } ///< connected to the simulated bench
  /// Real instruments that were opened become the bench.
  bool useInstruments(const std::shared_ptr<devices::OpenedBench>& opened);
  void letGoOfInstruments(); ///< they are being closed; nothing else is disconnected
  bool usesInstruments(const devices::OpenedBench* opened) const { return opened != nullptr && m_opened == opened; }
  void disconnectBench();
  QString statusText() const; ///< one line: what is connected, or what to do
  QString problem() const { return m_problem; }
  QList<ConnectedInstrument> instruments() const { return connectedInstruments(m_bench); }

  // Live reading
  void setShown(bool shown);                         ///< reads only while somebody looks
  void takeReading(const FieldLiveReading& reading); ///< also of instruments that somebody else reads
  void loseReading();                                ///< there is none now: a number that stays would be made up
  QString axisText(field::Axis axis) const;          ///< in tesla, "0.123456"; a dash without a reading
  QString noiseText(field::Axis axis) const;         ///< "1 σ 5.1 µT"; empty until there are enough readings
  QList<Value> values() const;                       ///< of the other roles, in a fixed order
  PlotSpec tracePlot() const;                        ///< raw readings, seconds before now
  bool canSetField() const { return m_bench.canSetField(); }
  void setFieldT(double fieldT) { m_bench.setFieldT(fieldT); }
  bool canPlaceProbe() const { return m_bench.canPlaceProbe(); }
  void placeProbe(devices::ProbePlacement placing) { m_bench.placeProbe(placing); }

  // Traceability
  QString traceabilitySummary() const;
  bool canTakeOverInstruments() const;
  void takeOverInstruments();

signals:
  void connectionChanged();
  void readingChanged();
  void problemChanged();
  void traceabilityChanged();

private:
  std::optional<BenchIdentities> identities() const;
  void setProblem(const QString& problem);
  void report(const Result<void>& outcome);

  FieldDocument& m_document;
  FieldBenchLink& m_bench;
  const devices::OpenedBench* m_opening = nullptr; ///< while the bench link is asked to take it
  const devices::OpenedBench* m_opened = nullptr;  ///< that the bench link holds; compared only
  bool m_wasCapturing = false;
  QString m_problem;
  std::optional<FieldLiveReading> m_reading;
  std::array<QList<double>, 3> m_trace; ///< oldest first, since the connection; not a number where out of range
};

/// "in the magnet, −x along the field", for a list to choose from.
QString placementWords(devices::ProbePlacement placing);

} // namespace straightedge::gui
