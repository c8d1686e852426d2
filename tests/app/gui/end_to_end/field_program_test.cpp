// The command line and the desktop application together: `field fit --plots --report` as a user runs it.
#include <QDir>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace {

const QString campaignFile = QStringLiteral(STRAIGHTEDGE_TEST_DATA "/field/campaign.csv");

struct Ended {
  int code = -1;
  QByteArray err;
};

/// No display: the program has to do without.
Ended runProgram(const QString& name, const QStringList& arguments, const QString& input = {}) {
  QProcess program;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  for (const char* variable : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
    environment.remove(QLatin1String(variable));
  }
  const QTemporaryDir ownFolder; // Qt complains of one that is not there or open to others
  environment.insert(QStringLiteral("XDG_RUNTIME_DIR"), ownFolder.path());
  program.setProcessEnvironment(environment);
  if (!input.isEmpty()) {
    program.setStandardInputFile(input);
  }
  program.start(QStringLiteral(STRAIGHTEDGE_BINARY_DIR "/") + name, arguments);
  if (!program.waitForFinished(240000)) {
    return {-1, "did not end"};
  }
  return {program.exitStatus() == QProcess::NormalExit ? program.exitCode() : -1, program.readAllStandardError()};
}

QStringList filesIn(const QString& folder, const QString& pattern) {
  return QDir(folder).entryList({pattern}, QDir::Files, QDir::Name);
}

} // namespace

class FieldProgramTest : public QObject {
  Q_OBJECT

private slots:
  void fitDrawsPlotsAndReport();
  void jointFitOfStandardInputIsReported();
  void renderRefusesOneLine();
};

void FieldProgramTest::fitDrawsPlotsAndReport() {
  const QTemporaryDir folder;
  const Ended run =
      runProgram("straightedge-cli", {"field", "fit", campaignFile, "--out", folder.path(), "--plots", "--report"});
  QVERIFY2(run.code == 0, run.err.constData());
  QCOMPARE(filesIn(folder.path(), "*"), QStringList({"calibration.json", "coefficients.csv", "nonlinearity-orders.csv",
                                                     "report.html", "report.pdf", "verification.csv"}));
  const QString plots = folder.filePath("plots");
  const QStringList pictures = filesIn(plots, "*.png");
  QCOMPARE(pictures.size(), 39);
  QCOMPARE(filesIn(plots, "*.svg").size(), pictures.size());
  QCOMPARE(filesIn(plots, "*.pdf").size(), pictures.size());
  for (const QString& picture : pictures) {
    QCOMPARE(QImage(plots + QLatin1Char('/') + picture).size(), QSize(1920, 1080));
  }
}

void FieldProgramTest::jointFitOfStandardInputIsReported() {
  const QTemporaryDir folder;
  const Ended run = runProgram(
      "straightedge-cli", {"field", "fit", "-", "--out", folder.path(), "--method", "joint", "--report"}, campaignFile);
  QVERIFY2(run.code == 0, run.err.constData());
  QFile html(folder.filePath("report.html"));
  QVERIFY(html.open(QIODevice::ReadOnly));
  const QByteArray text = html.readAll();
  QVERIFY(text.contains("All blocks were fitted together"));
  QVERIFY(text.contains("from which the joint fit started"));
  QVERIFY(!QDir(folder.filePath("plots")).exists());
}

void FieldProgramTest::renderRefusesOneLine() {
  const QTemporaryDir folder;
  const Ended run = runProgram("straightedge", {"--render", campaignFile, "--out", folder.filePath("out")});
  QCOMPARE(run.code, 3);
  QVERIFY2(run.err.startsWith("straightedge: ") && run.err.count('\n') == 1, run.err.constData());
}

QTEST_GUILESS_MAIN(FieldProgramTest)
#include "field_program_test.moc"
