#include "tests/app/gui/bench/test_classes.h"

#include <QApplication>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

int main(int argc, char** argv) {
  using namespace straightedge::gui;
  QTemporaryDir home; // benches, settings and scratch files of the test, never the user's
  qputenv("XDG_DATA_HOME", home.path().toUtf8());
  qputenv("XDG_CONFIG_HOME", home.path().toUtf8());
  QApplication application(argc, argv);
  const QStringList arguments = QCoreApplication::arguments();
  if (arguments.size() == 3 && arguments[1] == QStringLiteral("--pictures")) {
    return takeBenchPictures(application, arguments[2]);
  }
  int failed = 0;
  for (const auto& make : {makeBenchDraftTest, makeBenchPresenterTest, makeBenchPanelTest, makeBenchWindowTest}) {
    failed += QTest::qExec(make().get(), arguments);
  }
  return failed;
}
