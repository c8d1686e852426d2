// The command line and the desktop application together: `field fit --plots --report` as a user runs it.
#include <QDir>
#include <QFile>
#include <QImage>
#include <QMap>
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
Ended runProgram(const QString& name, const QStringList& arguments, const QString& input = {},
                 const QMap<QString, QString>& variables = {}) {
  QProcess program;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  for (const char* variable : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
    environment.remove(QLatin1String(variable));
  }
  const QTemporaryDir ownFolder; // Qt complains of one that is not there or open to others
  environment.insert(QStringLiteral("XDG_RUNTIME_DIR"), ownFolder.path());
  for (auto each = variables.cbegin(); each != variables.cend(); ++each) {
    environment.insert(each.key(), each.value());
  }
  program.setProcessEnvironment(environment);
  if (!input.isEmpty()) {
    program.setStandardInputFile(input);
  }
  const QString place = QStringLiteral(STRAIGHTEDGE_BINARY_DIR "/");
  program.start(name.startsWith(QLatin1Char('/')) ? name : place + name, arguments);
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
  void withoutOpenGlTheRestIsWritten();
  void moduleIsFoundWhereItIsInstalled();
  void jointFitOfStandardInputIsReported();
  void sessionsAreDrawnToo_data();
  void sessionsAreDrawnToo();
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
  QCOMPARE(pictures.size(), 39 + 11); // those in space are no vectors
  QCOMPARE(filesIn(plots, "*.svg").size(), 39);
  QCOMPARE(filesIn(plots, "*.pdf").size(), 39);
  for (const QString& picture : pictures) {
    QCOMPARE(QImage(plots + QLatin1Char('/') + picture).size(), QSize(1920, 1080));
  }
}

void FieldProgramTest::withoutOpenGlTheRestIsWritten() {
  const QTemporaryDir folder;
  QVERIFY(runProgram("straightedge-cli", {"field", "fit", campaignFile, "--out", folder.path()}).code == 0);
  const QString out = folder.filePath("out");
  // EGL that knows of no driver: a computer without OpenGL.
  const Ended run = runProgram("straightedge", {"--render", folder.filePath("calibration.json"), "--out", out}, {},
                               {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere.json"}});
  QVERIFY2(run.code == 0, run.err.constData());
  QVERIFY2(run.err.startsWith("straightedge: 1 three-dimensional picture") && run.err.count('\n') == 1,
           run.err.constData());
  QCOMPARE(filesIn(out + "/plots", "*.png").size(), 4);
  QVERIFY(!QFile::exists(out + "/plots/axis-directions.png"));
  QFile html(out + "/report.html");
  QVERIFY(html.open(QIODevice::ReadOnly));
  const QByteArray text = html.readAll();
  QVERIFY(text.contains("three-dimensional pictures are missing") && text.contains("OpenGL 3.2"));
  QVERIFY(QFile::exists(out + "/report.pdf"));
}

void FieldProgramTest::moduleIsFoundWhereItIsInstalled() {
  const QTemporaryDir folder;
  QVERIFY(runProgram("straightedge-cli", {"field", "fit", campaignFile, "--out", folder.path()}).code == 0);
  const QString calibration = folder.filePath("calibration.json");
  const QString program = folder.filePath("opt/bin/straightedge");
  QVERIFY(QDir(folder.path()).mkpath("opt/bin") && QDir(folder.path()).mkpath("opt/lib/straightedge"));
  QVERIFY(QFile::copy(QStringLiteral(STRAIGHTEDGE_BINARY_DIR "/straightedge"), program));
  const Ended without = runProgram(program, {"--render", calibration, "--out", folder.filePath("without"), "--report"});
  QVERIFY2(without.code == 0, without.err.constData());
  QFile html(folder.filePath("without/report.html"));
  QVERIFY(html.open(QIODevice::ReadOnly));
  QVERIFY(html.readAll().contains("lib/straightedge/straightedge_gl.so, which is missing"));
  const QString module = QStringLiteral(STRAIGHTEDGE_BINARY_DIR "/../lib/straightedge/straightedge_gl.so");
  QVERIFY(QFile::copy(module, folder.filePath("opt/lib/straightedge/straightedge_gl.so")));
  const Ended with = runProgram(program, {"--render", calibration, "--out", folder.filePath("with"), "--plots"});
  QVERIFY2(with.code == 0 && with.err.isEmpty(), with.err.constData());
  QCOMPARE(QImage(folder.filePath("with/plots/axis-directions.png")).size(), QSize(1920, 1080));
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

void FieldProgramTest::sessionsAreDrawnToo_data() {
  QTest::addColumn<QStringList>("plan");
  QTest::newRow("angle") << QStringList{"--points", "24"};
  QTest::newRow("field") << QStringList{"--stages", "nonlinearity,verification", "--rows", "3"};
}

void FieldProgramTest::sessionsAreDrawnToo() {
  QFETCH(const QStringList, plan);
  const QString kind = QString::fromLatin1(QTest::currentDataTag());
  const QTemporaryDir folder;
  const QString session = folder.filePath("captured.sedge");
  const Ended captured =
      runProgram("straightedge-cli", QStringList{"capture", kind, "--bench", "simulated", "--session", session} + plan);
  QVERIFY2(captured.code == 0, captured.err.constData());
  const QString out = folder.filePath("out");
  const Ended run = runProgram("straightedge-cli", {kind, "fit", session, "--out", out, "--plots", "--report"});
  QVERIFY2(run.code == 0, run.err.constData());
  QVERIFY(QFile::exists(out + "/report.pdf"));
  QVERIFY(!filesIn(out + "/plots", "*.svg").isEmpty());
}

void FieldProgramTest::renderRefusesOneLine() {
  const QTemporaryDir folder;
  const Ended run = runProgram("straightedge", {"--render", campaignFile, "--out", folder.filePath("out")});
  QCOMPARE(run.code, 3);
  QVERIFY2(run.err.startsWith("straightedge: ") && run.err.count('\n') == 1, run.err.constData());
}

QTEST_GUILESS_MAIN(FieldProgramTest)
#include "field_program_test.moc"
