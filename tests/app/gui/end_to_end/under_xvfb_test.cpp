// The installed program on a private X server: it opens on its simulated bench and paints. Ends with 77 (skipped) where
// there is no Xvfb.
#include "tests/app/gui/end_to_end/private_display.h"

#include <QApplication>
#include <QImage>
#include <QPixmap>
#include <QProcess>
#include <QScreen>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

#include <cstdio>

namespace {

constexpr int skipped = 77;
constexpr int waitMs = 60000;

int coloursOf(const QImage& picture) {
  QSet<QRgb> colours;
  for (int y = 0; y < picture.height(); y += 3) {
    for (int x = 0; x < picture.width(); x += 3) {
      colours.insert(picture.pixel(x, y));
    }
  }
  return static_cast<int>(colours.size());
}

} // namespace

class UnderXvfbTest : public QObject {
  Q_OBJECT
private slots:
  void opensOnTheSimulatedBench();
};

void UnderXvfbTest::opensOnTheSimulatedBench() {
  QScreen* screen = QGuiApplication::primaryScreen();
  const auto rootPicture = [screen] { return screen->grabWindow(0).toImage(); };
  const int before = coloursOf(rootPicture());
  QVERIFY(before < 10); // an empty X server
  QProcess program;
  program.setProcessChannelMode(QProcess::ForwardedChannels);
  straightedge::testing::PrivateDisplay::bindToTest(program);
  program.start(QStringLiteral(STRAIGHTEDGE_BINARY_DIR "/straightedge"), {QStringLiteral("--simulated")});
  QVERIFY(program.waitForStarted(waitMs));
  QTRY_VERIFY_WITH_TIMEOUT(program.state() != QProcess::Running || coloursOf(rootPicture()) > 50, waitMs);
  QCOMPARE(program.state(), QProcess::Running);
  const QImage picture = rootPicture();
  QVERIFY(picture.width() >= 1280);
  const QString kept = qEnvironmentVariable("STRAIGHTEDGE_SCREENSHOT");
  QVERIFY(kept.isEmpty() || picture.save(kept));
  program.kill();
  QVERIFY(program.waitForFinished(waitMs));
}

int main(int argc, char** argv) {
  if (straightedge::testing::PrivateDisplay::program().isEmpty()) {
    std::puts("SKIPPED: Xvfb is not installed");
    return skipped;
  }
  QTemporaryDir home;
  qputenv("XDG_DATA_HOME", home.path().toUtf8());
  qputenv("XDG_CONFIG_HOME", home.path().toUtf8());
  straightedge::testing::PrivateDisplay display;
  if (!display.start()) {
    std::puts("Xvfb does not start");
    return 1;
  }
  qputenv("DISPLAY", display.name());
  qputenv("QT_QPA_PLATFORM", "xcb");
  QApplication application(argc, argv);
  UnderXvfbTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "under_xvfb_test.moc"
