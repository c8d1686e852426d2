#include "tests/app/gui/field_capture/test_classes.h"

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

int main(int argc, char** argv) {
  using namespace straightedge::gui;
  QTemporaryDir home; // scratch files and settings of the test, never the user's
  qputenv("XDG_DATA_HOME", home.path().toUtf8());
  qputenv("XDG_CONFIG_HOME", home.path().toUtf8());
  const QApplication application(argc, argv);
  const QStringList arguments = QCoreApplication::arguments();
  if (arguments.size() == 3 && arguments[1] == QStringLiteral("--capture-into")) {
    return captureCampaignUntilKilled(arguments[2]);
  }
  int failed = 0;
  for (const auto& make :
       {makeFieldBenchLinkTest, makeFieldPlanShapeTest, makeFieldCapturePresenterTest, makeFieldCapturePagesTest}) {
    failed += QTest::qExec(make().get(), arguments);
  }
  return failed;
}
