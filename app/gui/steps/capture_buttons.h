// The buttons that a capture is started, paused, gone on with and left by, of every kind of calibration.
#pragma once

#include <QString>
#include <QWidget>

#include <functional>

class QPushButton;

namespace straightedge::gui {

class CaptureButtons : public QWidget {
  Q_OBJECT
public:
  /// What the capture can be told now, and where to go from here.
  struct State {
    bool hasBench = false;
    bool capturing = false;
    bool waits = false; ///< for an instrument that was unplugged: there is nothing to pause
    bool canStart = false;
    bool replaces = false;    ///< starting replaces what the session holds
    bool canContinue = false; ///< an interrupted capture
    bool canResume = false;
    bool complete = false; ///< all that was planned is there
    QString nextStep;      ///< title of the step to go on with; empty where it is too early
  };

  explicit CaptureButtons(QWidget* parent = nullptr);
  void showState(const State& state);

signals:
  void startWanted();
  void continueWanted();
  void pauseWanted(); ///< or resuming, where that can be done
  void stopWanted();
  void stepWanted(const QString& title);

private:
  QPushButton* m_continue;
  QPushButton* m_start;
  QPushButton* m_pause;
  QPushButton* m_stop;
  QPushButton* m_connect;
  QPushButton* m_next;
  QString m_nextStep;
};

struct ReplaceQuestion {
  QString title;
  QString objectName; ///< of the message box
};

/// Asks over `page`; `replace` is called where the answer is yes, and only while `page` lives.
void askToReplace(QWidget& page, const ReplaceQuestion& question, const QString& text, std::function<void()> replace);

} // namespace straightedge::gui
