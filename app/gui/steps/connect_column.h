// The left column of a step Connect, whatever is calibrated: the benches one may choose from, what is connected,
// traceability.
#pragma once

#include "app/gui/steps/connect_words.h"

#include <QList>
#include <QScrollArea>
#include <QString>

class QGroupBox;
class QLabel;
class QPushButton;
class QTabWidget;

namespace straightedge::gui {

class ConnectColumn : public QScrollArea {
  Q_OBJECT
public:
  struct Connection {
    bool connected = false;
    const QWidget* form = nullptr; ///< of the bench that is connected; null: one that has no button of the column's
    bool mayChange = true;         ///< no capture is running
    QString status;                ///< one line: what is connected, or what to do
    QList<ConnectedInstrument> instruments;
  };

  explicit ConnectColumn(QWidget* parent = nullptr);

  /// A bench to choose: what it is, and its settings. The first one fills the box alone; from the second on each has a
  /// tab. `connects`: the column's own button connects it; a panel that does so itself leaves it out.
  void addBench(const QString& title, const QString& about, QWidget* form, bool connects = true);
  void chooseBench(int index); ///< shows its tab
  void showConnection(const Connection& connection);
  void showTraceability(const QString& lines, bool canTakeOver);

signals:
  void connectWanted(QWidget* form); ///< the form of the bench that was chosen
  void disconnectWanted();
  void nextWanted();
  void detailsWanted();
  void takeOverWanted();

private:
  QWidget* makeBenchBox();
  QWidget* makeInstrumentsBox();
  QWidget* makeTraceabilityBox();
  void showButton();
  bool isChosenConnected() const;

  struct Bench {
    QWidget* form;
    bool connects;
  };
  QList<Bench> m_forms; ///< one for each tab
  bool m_connected = false;
  const QWidget* m_connectedForm = nullptr;
  bool m_mayChange = true;
  QGroupBox* m_box = nullptr;
  QTabWidget* m_benches = nullptr;
  QLabel* m_status = nullptr;
  QPushButton* m_connect = nullptr;
  QPushButton* m_next = nullptr;
  QLabel* m_instruments = nullptr;
  QLabel* m_traceability = nullptr;
  QPushButton* m_takeOver = nullptr;
};

} // namespace straightedge::gui
