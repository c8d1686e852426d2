// The dialogue with the instruments of a bench as it happens, and a line to send a command.
#pragma once

#include "app/gui/bench/bench_presenter.h"
#include "app/gui/bench/dialogue_model.h"

#include <QTimer>
#include <QWidget>

class QComboBox;
class QLineEdit;
class QPushButton;
class QTableView;

namespace straightedge::gui {

class TintedLabel;

class BenchConsole : public QWidget {
  Q_OBJECT
public:
  explicit BenchConsole(BenchPresenter& presenter, QWidget* parent = nullptr);

  /// Writes what was said with the chosen instrument as a dialogue file; says what is in the way.
  bool saveTo(const QString& file);

public slots:
  void copy(); ///< all rows, with titles

protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override; // arrow keys in the command line

private:
  QWidget* makeTools();
  QWidget* makeCommandLine();
  void takeNew();
  void showInstruments();
  void showState();
  void send();
  void save();
  std::optional<std::size_t> chosen() const; ///< place in the bench of the instrument that is chosen; none: all

  BenchPresenter& m_presenter;
  DialogueModel m_model;
  QTimer m_timer;
  QStringList m_names; ///< in the list
  QComboBox* m_instrument = nullptr;
  QLineEdit* m_filter = nullptr;
  QPushButton* m_pause = nullptr;
  QPushButton* m_copy = nullptr;
  QPushButton* m_save = nullptr;
  QTableView* m_table = nullptr;
  QLineEdit* m_command = nullptr;
  QComboBox* m_end = nullptr;
  QPushButton* m_send = nullptr;
  TintedLabel* m_problem = nullptr;
  QStringList m_sent; ///< commands for the arrow keys, newest last
  qsizetype m_recalled = 0;
};

/// A page's content with the console below it, which takes room only while it is shown.
QWidget* withConsole(QWidget* content, BenchConsole& console, QWidget* parent);

} // namespace straightedge::gui
