// Paints the window and its dialogues, light and dark, into PNG files beside the program, to be looked at. Run it with
// QT_SCALE_FACTOR=2 for 200 %.
#include "app/gui/shell/about_dialog.h"
#include "app/gui/shell/details_dialog.h"
#include "app/gui/shell/help_window.h"
#include "app/gui/shell/import_dialog.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/shell/message_bar.h"
#include "app/gui/shell/program_start.h"
#include "tests/app/gui/shell/scripted_prompts.h"

#include <QDir>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace straightedge::gui {

class ShellPictures : public QObject {
  Q_OBJECT
private slots:
  void initTestCase();
  void paints_data();
  void paints();

private:
  void keep(QWidget& widget, const QString& name);
  QTemporaryDir m_home;
};

void ShellPictures::initTestCase() {
  qputenv("XDG_DATA_HOME", m_home.filePath("data").toUtf8());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_home.filePath("config"));
  prepareApplication(*qApp);
}

void ShellPictures::keep(QWidget& widget, const QString& name) {
  QCoreApplication::processEvents();
  QDir folder(QStringLiteral(STRAIGHTEDGE_BINARY_DIR "/../gallery"));
  QVERIFY(folder.mkpath(QStringLiteral(".")));
  const QImage picture = widget.grab().toImage();
  QVERIFY(!picture.isNull());
  const int percent = qRound(picture.devicePixelRatio() * 100);
  QVERIFY(picture.save(folder.filePath(QString("%1-%2-%3.png").arg(name, QTest::currentDataTag()).arg(percent))));
}

void ShellPictures::paints_data() {
  QTest::addColumn<bool>("dark");
  QTest::newRow("light") << false;
  QTest::newRow("dark") << true;
}

void ShellPictures::paints() {
  QFETCH(bool, dark);
  applyTheme(*qApp, dark ? ThemeChoice::Dark : ThemeChoice::Light);
  QSettings().setValue("recentFiles", QStringList{m_home.filePath("spindle-0042.sedge"),
                                                  STRAIGHTEDGE_TEST_DATA "/angle/side_shaft_32.csv"});
  PromptScript script;
  MainWindow window(std::make_unique<ScriptedPrompts>(script));
  window.resize(1240, 780);
  window.show();
  QVERIFY(QTest::qWaitForWindowExposed(&window));
  script.closeAnswer = WindowPrompts::CloseAnswer::KeepForLater;
  window.openExample(":/examples/side_shaft_32.csv");
  QVERIFY(window.closeCalibration());
  keep(window, "shell-start");
  window.messages().showMessage("sweep.csv:17: “abc” is no number; correct the row or remove it",
                                MessageBar::Kind::Problem);
  window.resize(820, 620);
  keep(window, "shell-start-small");
  window.resize(1240, 780);
  window.messages().dismiss();
  window.openExample(":/examples/side_shaft_32.csv");
  QSignalSpy idle(&window.jobs(), &JobRunner::idle);
  QVERIFY(idle.wait(60000));
  keep(window, "shell-window");
  window.newCalibration();
  keep(window, "shell-connect");
  window.importCsv(STRAIGHTEDGE_TEST_DATA "/angle/side_shaft_32.csv");
  QSignalSpy read(&window.jobs(), &JobRunner::idle);
  QVERIFY(read.wait(60000));
  keep(*window.importDialog(), "shell-import");
  window.importDialog()->reject();
  DetailsDialog details(Traceability{}, {"°", "degrees", 180.0}, &window);
  details.show();
  keep(details, "shell-details");
  AboutDialog about(&window);
  about.show();
  keep(about, "shell-about");
  window.showHelp("method");
  keep(*window.helpWindow(), "shell-help");
}

} // namespace straightedge::gui

QTEST_MAIN(straightedge::gui::ShellPictures)
#include "shell_pictures.moc"
