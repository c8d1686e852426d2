// Pictures of every step for the eye: screenshots FOLDER writes each in light and dark, of an angle calibration;
// screenshots FOLDER field those of a field calibration. Not a test; run it with
// QT_QPA_PLATFORM=offscreen, and once more with QT_SCALE_FACTOR=2 for 200 %.
#include "app/gui/document/field_document.h"
#include "app/gui/plots/scene_view.h"
#include "app/gui/shell/field_workspace.h"
#include "app/gui/shell/program_start.h"
#include "app/gui/shell/theme.h"
#include "tests/app/gui/end_to_end/quiet_prompts.h"
#include "tests/app/gui/end_to_end/window_driver.h"

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QSignalSpy>
#include <QTabBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>

#include <cstdio>

using namespace straightedge::gui;
namespace devices = straightedge::devices;

namespace {

constexpr int waitMs = 120000;

class Album {
public:
  Album(MainWindow& window, QString folder) : m_window(window), m_folder(std::move(folder)) {}

  void take(const QString& name) {
    settle();
    for (const ThemeChoice theme : {ThemeChoice::Light, ThemeChoice::Dark}) {
      applyTheme(*qobject_cast<QApplication*>(QCoreApplication::instance()), theme);
      settle();
      ++m_count;
      const QString file = QStringLiteral("%1/%2-%3-%4.png")
                               .arg(m_folder)
                               .arg((m_count + 1) / 2, 2, 10, QLatin1Char('0'))
                               .arg(name, themeName(theme));
      if (!m_window.grab().save(file)) {
        qFatal("cannot write %s", qPrintable(file));
      }
      std::puts(qPrintable(file));
    }
    applyTheme(*qobject_cast<QApplication*>(QCoreApplication::instance()), ThemeChoice::Light);
  }
  void settle() {
    if (m_window.jobs().busy()) {
      QSignalSpy idle(&m_window.jobs(), &JobRunner::idle);
      idle.wait(waitMs);
    }
    QTest::qWait(100); // pictures only; nothing is checked
    for (SceneView* scene : m_window.findChildren<SceneView*>()) {
      if (scene->isVisible()) {
        QSignalSpy shown(scene, &SceneView::pictureShown);
        scene->update();
        shown.wait(waitMs);
      }
    }
  }

private:
  MainWindow& m_window;
  QString m_folder;
  int m_count = 0;
};

void capture(MainWindow& window, straightedge::session::SweepRole role, const devices::AnglePlan& plan) {
  QSignalSpy ended(&window.bench(), &BenchLink::captureEnded);
  if (!window.bench().startCapture(plan, role, false) || (ended.isEmpty() && !ended.wait(waitMs))) {
    qFatal("capture failed");
  }
}

void walk(MainWindow& window, Album& album) {
  WindowDriver driver(window);
  album.take(QStringLiteral("start"));
  window.newCalibration();
  album.take(QStringLiteral("connect-empty"));
  driver.step(QStringLiteral("Capture"));
  album.take(QStringLiteral("capture-without-bench"));
  for (const char* step : {"Review", "Fit", "Compare", "Verify", "Export"}) {
    driver.step(QString::fromLatin1(step));
    album.take(QString::fromLatin1(step).toLower() + QStringLiteral("-empty"));
  }
  devices::SimulatedAngleSettings settings;
  if (!window.bench().connectSimulated(settings)) {
    qFatal("no bench");
  }
  driver.step(QStringLiteral("Connect"));
  window.bench().moveShaftTo(140.0);
  QTest::qWait(2500);
  album.take(QStringLiteral("connect"));
  devices::AnglePlan plan;
  plan.pointsPerTurn = 72;
  plan.bothDirections = true;
  plan.averages = 3;
  window.document().setPlan(plan);
  driver.step(QStringLiteral("Capture"));
  album.take(QStringLiteral("capture-ready"));
  driver.click(QStringLiteral("startCapture"));
  QTest::qWait(4000);
  album.take(QStringLiteral("capture-running"));
  window.bench().stopAndWait();
  album.take(QStringLiteral("capture-interrupted"));
  window.bench().disconnectBench();
  settings.realTime = false;
  if (!window.bench().connectSimulated(settings)) {
    qFatal("no bench");
  }
  capture(window, straightedge::session::SweepRole::Calibration, plan);
  album.take(QStringLiteral("capture-done"));
  driver.step(QStringLiteral("Review"));
  album.settle();
  auto* views = driver.find<QTabBar>(QStringLiteral("reviewViews"));
  for (int i = 0; i < views->count(); ++i) {
    views->setCurrentIndex(i);
    album.take(QStringLiteral("review-") + views->tabText(i).toLower());
  }
  driver.step(QStringLiteral("Fit"));
  album.take(QStringLiteral("fit"));
  driver.step(QStringLiteral("Compare"));
  album.take(QStringLiteral("compare"));
  plan.pointsPerTurn = 50;
  capture(window, straightedge::session::SweepRole::Verification, plan);
  driver.step(QStringLiteral("Verify"));
  album.take(QStringLiteral("verify"));
  driver.step(QStringLiteral("Export"));
  album.take(QStringLiteral("export"));
}

void walkField(MainWindow& window, Album& album) {
  WindowDriver driver(window);
  window.newFieldCalibration();
  for (const char* step : {"Connect", "Capture", "Review", "Fit", "Compare", "Verify", "Export"}) {
    driver.step(QString::fromLatin1(step));
    album.take(QString::fromLatin1(step).toLower() + QStringLiteral("-empty"));
  }
  window.openExample(QStringLiteral(":/examples/hall_probe_campaign.csv"));
  album.settle();
  driver.step(QStringLiteral("Review"));
  album.take(QStringLiteral("review"));
  auto* views = driver.find<QTabWidget>(QStringLiteral("fieldReviewTabs"));
  views->setCurrentIndex(1);
  album.take(QStringLiteral("review-orientations"));
  views->setCurrentIndex(0);
  driver.step(QStringLiteral("Fit"));
  album.take(QStringLiteral("fit"));
  auto* figure = driver.find<QComboBox>(QStringLiteral("fitFigure"));
  for (const char* name :
       {"Probe temperature", "Probe temperature hysteresis", "Axis tilts", "Axis directions", "Orientations"}) {
    figure->setCurrentIndex(figure->findText(QString::fromLatin1(name)));
    album.take(QStringLiteral("fit-figure-") + QString::fromLatin1(name).toLower().replace(' ', '-'));
  }
  auto* tables = driver.find<QTabWidget>(QStringLiteral("fitTables"));
  for (int i = 1; i < tables->count(); ++i) {
    tables->setCurrentIndex(i);
    driver.find<QComboBox>(QStringLiteral("fitFigure"))->setCurrentIndex(4 * i);
    album.take(QStringLiteral("fit-") + tables->tabText(i).toLower());
  }
  FieldChoices choices = window.field().document().choices();
  choices.blocksOff.insert(straightedge::field::Block::Offset);
  window.field().document().setChoices(choices, QStringLiteral("Switch off"));
  album.take(QStringLiteral("fit-block-off"));
  window.field().document().undoStack().undo();
  driver.step(QStringLiteral("Compare"));
  album.settle();
  album.take(QStringLiteral("compare"));
  driver.find<QTabWidget>(QStringLiteral("fieldComparison"))->setCurrentIndex(1);
  album.take(QStringLiteral("compare-table"));
  driver.step(QStringLiteral("Verify"));
  album.take(QStringLiteral("verify"));
  auto* verified = driver.find<QComboBox>(QStringLiteral("verifyFigure"));
  for (const char* name : {"Surface before, x", "Surface after, x", "Surface after enlarged, x"}) {
    verified->setCurrentIndex(verified->findText(QString::fromLatin1(name)));
    album.take(QStringLiteral("verify-") + QString::fromLatin1(name).toLower().replace(' ', '-').remove(','));
  }
  driver.step(QStringLiteral("Export"));
  album.take(QStringLiteral("export"));
}

} // namespace

int main(int argc, char** argv) {
  QTemporaryDir home;
  qputenv("XDG_DATA_HOME", home.path().toUtf8());
  qputenv("XDG_CONFIG_HOME", home.path().toUtf8());
  QApplication application(argc, argv);
  prepareApplication(application);
  const bool fieldWanted = argc == 3 && QByteArray(argv[2]) == "field";
  if ((argc != 2 && !fieldWanted) || !QDir().mkpath(QString::fromLocal8Bit(argv[1]))) {
    std::fputs("usage: screenshots FOLDER [field]\n", stderr);
    return 2;
  }
  MainWindow window(std::make_unique<QuietPrompts>());
  window.resize(1280, 800);
  window.show();
  Album album(window, QString::fromLocal8Bit(argv[1]));
  if (fieldWanted) {
    walkField(window, album);
  } else {
    walk(window, album);
  }
  return 0;
}
