// An X server of the test's own (Xvfb) for programs that it starts as children.
#pragma once

#include <QByteArray>
#include <QProcess>
#include <QProcessEnvironment>
#include <QStandardPaths>

#include <csignal>
#include <sys/prctl.h>

namespace straightedge::testing {

/// The server ends with this object, after the programs that use it.
class PrivateDisplay {
public:
  static QString program() { return QStandardPaths::findExecutable(QStringLiteral("Xvfb")); } ///< empty: not installed

  /// False where the server does not start.
  bool start() {
    // What is preloaded for the programs under test is none of the server's business.
    m_server.setProcessEnvironment(plainEnvironment());
    bindToTest(m_server);
    // -noreset: without it the server begins anew when its last client leaves, and the next one may fail to connect.
    m_server.start(program(), {QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-screen"),
                               QStringLiteral("0"), QStringLiteral("1400x900x24"), QStringLiteral("-noreset"),
                               QStringLiteral("-nolisten"), QStringLiteral("tcp")});
    if (!m_server.waitForReadyRead(waitMs)) {
      return false;
    }
    m_name = ":" + m_server.readAllStandardOutput().trimmed();
    return true;
  }
  ~PrivateDisplay() {
    m_server.terminate();
    m_server.waitForFinished(waitMs);
  }

  const QByteArray& name() const { return m_name; } ///< for DISPLAY

  /// It ends with the test, also where that is killed.
  static void bindToTest(QProcess& child) {
    child.setChildProcessModifier([] { ::prctl(PR_SET_PDEATHSIG, SIGKILL); });
  }

  /// Ours without what is preloaded for tests on emulated USB.
  static QProcessEnvironment plainEnvironment() {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("LD_PRELOAD"));
    return environment;
  }

private:
  static constexpr int waitMs = 60000;
  QProcess m_server;
  QByteArray m_name;
};

} // namespace straightedge::testing
