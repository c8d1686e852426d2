// The real program on a private X server, driven by what a person has: its window's title to read, keys to press.
#pragma once

#include "tests/app/gui/end_to_end/private_display.h"

#include <QProcess>
#include <QStandardPaths>
#include <QString>
#include <QStringList>

namespace straightedge::testing {

/// Keys are pressed by xdotool. The X server keeps them in order, so that none is lost while the program is busy: what
/// has to be waited for is only what the program does by itself. Needs DISPLAY and QT_QPA_PLATFORM=xcb.
class TypedWindow {
public:
  static constexpr int waitMs = 120000;
  static QString tool() { return QStandardPaths::findExecutable(QStringLiteral("xdotool")); } ///< empty: not installed

  /// Starts the program, waits for its window and gives it the keyboard. False: see error().
  bool start(const QStringList& arguments) {
    m_program.setProcessChannelMode(QProcess::ForwardedChannels);
    PrivateDisplay::bindToTest(m_program);
    m_program.start(QStringLiteral(STRAIGHTEDGE_BINARY_DIR "/straightedge"), arguments);
    if (!m_program.waitForStarted(waitMs)) {
      m_error = m_program.errorString();
      return false;
    }
    const QString process = QString::number(m_program.processId());
    m_window = ask({QStringLiteral("search"), QStringLiteral("--sync"), QStringLiteral("--onlyvisible"),
                    QStringLiteral("--all"), QStringLiteral("--pid"), process, QStringLiteral("--name"),
                    QStringLiteral("Straightedge")})
                   .section(QLatin1Char('\n'), 0, 0);
    ask({QStringLiteral("windowfocus"), QStringLiteral("--sync"), m_window}); // there is no window manager to do it
    return m_error.isEmpty() && !m_window.isEmpty();
  }
  ~TypedWindow() {
    m_program.kill(); // where it has not ended by itself
    m_program.waitForFinished(waitMs);
  }

  QString title() { return ask({QStringLiteral("getwindowname"), m_window}); }
  void press(const char* keys) { ask({QStringLiteral("key"), QString::fromLatin1(keys)}); } ///< "ctrl+2"

  bool isRunning() {
    return m_program.state() == QProcess::Running && !m_program.waitForFinished(0); // it may just have ended
  }
  /// Waits until it has ended by itself; its exit code, −1 where it crashed or goes on.
  int exitCode() {
    const bool ended = m_program.state() == QProcess::NotRunning || m_program.waitForFinished(waitMs);
    return ended && m_program.exitStatus() == QProcess::NormalExit ? m_program.exitCode() : -1;
  }
  const QString& error() const { return m_error; }

private:
  QString ask(const QStringList& arguments) {
    QProcess xdotool;
    xdotool.setProcessEnvironment(PrivateDisplay::plainEnvironment());
    xdotool.start(tool(), arguments);
    if (!xdotool.waitForFinished(waitMs) || xdotool.exitCode() != 0) {
      m_error = QStringLiteral("xdotool %1: %2")
                    .arg(arguments.join(QLatin1Char(' ')), QString::fromUtf8(xdotool.readAllStandardError()));
    }
    return QString::fromUtf8(xdotool.readAllStandardOutput()).trimmed();
  }

  QProcess m_program;
  QString m_window; ///< X's number of it
  QString m_error;  ///< of the last key or question that failed
};

} // namespace straightedge::testing
