// Pictures of the four steps for a critical eye: with STRAIGHTEDGE_PICTURES=FOLDER they are written there, light and
// dark; QT_SCALE_FACTOR=2 makes them for 200 %. Without it the test only sees that every step can be drawn.
#include "app/gui/shell/theme.h"
#include "app/gui/steps/step_page.h"
#include "tests/app/gui/steps_fit/document_fixture.h"

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QPalette>
#include <QPixmap>
#include <QTabWidget>

#include <memory>

using namespace straightedge;
using namespace straightedge::gui;
using gui::testing::OpenDocument;

namespace {

void draw(StepPage& page, const QString& name) {
  QCoreApplication::processEvents();
  const QPixmap picture = page.grab();
  QVERIFY(!picture.isNull());
  const QString folder = qEnvironmentVariable("STRAIGHTEDGE_PICTURES");
  if (!folder.isEmpty()) {
    QVERIFY(picture.save(QDir(folder).filePath(name + QStringLiteral(".png"))));
  }
}

std::unique_ptr<StepPage> shown(StepPage* made) {
  std::unique_ptr<StepPage> page(made);
  page->resize(1280, 800);
  page->show();
  page->entered();
  return page;
}

} // namespace

class StepPicturesTest : public QObject {
  Q_OBJECT

private slots:
  void initTestCase();
  void draws_data();
  void draws();
  void drawsEmpty();
};

void StepPicturesTest::initTestCase() { applyTheme(*qApp, ThemeChoice::Light); }

void StepPicturesTest::draws_data() {
  QTest::addColumn<bool>("dark");
  QTest::newRow("light") << false;
  QTest::newRow("dark") << true;
}

void StepPicturesTest::draws() {
  QFETCH(const bool, dark);
  applyTheme(*qApp, dark ? ThemeChoice::Dark : ThemeChoice::Light);
  const QString suffix = dark ? QStringLiteral("-dark") : QStringLiteral("-light");
  OpenDocument open;
  QVERIFY(open.load());
  const StepContext context{open.document, open.bench, open.jobs};
  {
    const auto fit = shown(makeFitStep(context, nullptr));
    auto* views = fit->findChild<QComboBox*>(QStringLiteral("fitView"));
    for (int i = 0; i < views->count(); ++i) {
      views->setCurrentIndex(i);
      draw(*fit, QStringLiteral("fit-%1").arg(i) + suffix);
    }
  }
  {
    const auto compare = shown(makeCompareStep(context, nullptr));
    draw(*compare, QStringLiteral("compare-plot") + suffix);
    auto* tabs = compare->findChild<QTabWidget*>();
    for (int i = 1; i < tabs->count(); ++i) {
      tabs->setCurrentIndex(i);
      draw(*compare, QStringLiteral("compare-%1").arg(i) + suffix);
    }
  }
  open.document.setVerificationSweep(gui::testing::exampleSweep());
  QVERIFY(QTest::qWaitFor([&] { return open.document.verification().has_value(); }, gui::testing::patienceMs));
  draw(*shown(makeVerifyStep(context, nullptr)), QStringLiteral("verify") + suffix);
  draw(*shown(makeExportStep(context, nullptr)), QStringLiteral("export") + suffix);
  applyTheme(*qApp, ThemeChoice::Light);
}

void StepPicturesTest::drawsEmpty() {
  OpenDocument open;
  const StepContext context{open.document, open.bench, open.jobs};
  draw(*shown(makeFitStep(context, nullptr)), QStringLiteral("fit-empty"));
  draw(*shown(makeCompareStep(context, nullptr)), QStringLiteral("compare-empty"));
  draw(*shown(makeVerifyStep(context, nullptr)), QStringLiteral("verify-empty"));
  draw(*shown(makeExportStep(context, nullptr)), QStringLiteral("export-empty"));
}

QTEST_MAIN(StepPicturesTest)
#include "step_pictures_test.moc"
