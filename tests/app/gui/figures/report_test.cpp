// Report, export and --render: real files in a folder of their own, drawn on the offscreen platform.
#include "app/gui/figures/export_files.h"
#include "app/gui/figures/picture_files.h"
#include "app/gui/figures/render_command.h"
#include "app/gui/figures/report_html.h"
#include "app/gui/figures/report_layout.h"
#include "app/gui/figures/report_pdf.h"
#include "app/gui/figures/report_tables.h"
#include "core/export/calibration_json.h"
#include "core/export/tables.h"
#include "tests/app/gui/figures/example_results.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include <algorithm>
#include <thread>

using namespace straightedge;
using namespace straightedge::gui;

namespace {

QByteArray contentOf(const QString& file) {
  QFile in(file);
  return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
}

QStringList filesBelow(const QString& folder) {
  QStringList names;
  QDirIterator each(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
  while (each.hasNext()) {
    names << QDir(folder).relativeFilePath(each.next());
  }
  names.sort();
  return names;
}

template <typename Block>
QList<Block> blocksOf(const ReportContent& content) {
  QList<Block> found;
  for (const ReportBlock& block : content.blocks) {
    if (const auto* each = std::get_if<Block>(&block)) {
      found.append(*each);
    }
  }
  return found;
}

qsizetype pagesOf(const QByteArray& pdf) { return pdf.count("/Type /Page\n"); }

constexpr ExportChoices everything{.tablesJson = true, .plotsSvg = true, .plotsPdf = true, .reportHtml = true};

} // namespace

class ReportTest : public QObject {
  Q_OBJECT

private slots:
  void numbersFiguresAndTables();
  void saysPassOrFail();
  void listsCoefficientsWithTheirDigits();
  void tableAsTextHasTabs();
  void keepsHeadingsWithWhatFollows();
  void repeatsNothingAndLosesNothing();
  void pdfHasPages();
  void htmlIsWholeAndEscaped();
  void drawsTheSameInAnyThread();
  void exportWritesFilesThatRead();
  void exportLeavesNothingAfterAnError();
  void exportLeavesNothingAfterCancelling();
  void renderDrawsWithTheSweep();
  void renderDrawsWhatTheFileHolds();
  void renderRefuses_data();
  void renderRefuses();
  void renderRefusesAnotherSweep();
};

void ReportTest::numbersFiguresAndTables() {
  const ReportContent content = angleReport(gui::testing::exampleResults());
  const auto figures = blocksOf<ReportFigure>(content);
  QVERIFY(figures.size() >= 20);
  for (int i = 0; i < figures.size(); ++i) {
    QVERIFY2(figures[i].caption.startsWith(QStringLiteral("Figure %1. ").arg(i + 1)), qPrintable(figures[i].caption));
    QVERIFY(figures[i].spec.title.isEmpty() && figures[i].spec.note.isEmpty());
  }
  int number = 0;
  for (const ReportTable& table : blocksOf<ReportTable>(content)) {
    if (!table.caption.isEmpty()) {
      QVERIFY2(table.caption.startsWith(QStringLiteral("Table %1. ").arg(++number)), qPrintable(table.caption));
      for (const QStringList& row : table.rows) {
        QCOMPARE(row.size(), table.header.size());
      }
    }
  }
  QVERIFY(number >= 8); // models, comparison, three budgets, verification, three coefficient tables
  QCOMPARE(content.subtitle, QStringLiteral("S <42> · 0007"));
}

void ReportTest::saysPassOrFail() {
  const auto results = gui::testing::exampleResults();
  QVERIFY(verdictSentence(*results->verification).startsWith("Passed: largest error 0."));
  results->verification = gui::testing::valueOf(
      angle::verify(results->calibration, results->calibration.models.front(), *results->sweep, 0.01));
  QVERIFY(verdictSentence(*results->verification).startsWith("Failed: largest error 0."));
  const auto paragraphs = blocksOf<ReportParagraph>(angleReport(results));
  QVERIFY(std::ranges::any_of(paragraphs,
                              [](const ReportParagraph& each) { return each.tone == ReportParagraph::Tone::Bad; }));
  results->verification.reset();
  QVERIFY(blocksOf<ReportParagraph>(angleReport(results)).front().text.startsWith("No fresh sweep"));
}

void ReportTest::listsCoefficientsWithTheirDigits() {
  const auto run = gui::testing::exampleRun();
  const ReportTable harmonic = coefficientsTable(run.result.models[0]);
  QCOMPARE(harmonic.rows.size(), 5);
  QVERIFY(std::abs(harmonic.rows[1][1].toDouble() - 8.15440090802) < 1e-6);
  const ReportTable table = coefficientsTable(run.result.models[2]);
  QCOMPARE(table.header.size(), 6);
  QCOMPARE(table.rows.size(), 22);
  QVERIFY(std::abs(table.rows[0][1].toDouble() - 98.0584231815) < 1e-4);
  QCOMPARE(coefficientsTable(run.result.models[2], 8).rows.size(), 3);
  QVERIFY(coefficientsTable(run.result.models[2], 8).caption.contains("first 8 of 64"));
}

void ReportTest::tableAsTextHasTabs() {
  const auto run = gui::testing::exampleRun();
  const QStringList lines = tableAsText(modelsTable(run.result)).split('\n', Qt::SkipEmptyParts);
  QCOMPARE(lines.size(), 4);
  QCOMPARE(lines[1].split('\t').first(), QStringLiteral("harmonic:4"));
  QCOMPARE(lines[2].split('\t')[1], QStringLiteral("32"));
}

void ReportTest::keepsHeadingsWithWhatFollows() {
  const auto box = [](double height, bool keep) {
    ReportBox each;
    each.height = height;
    each.spaceBefore = 10.0;
    each.keepWithNext = keep;
    return each;
  };
  const auto pages = paginate({box(80, false), box(5, true), box(30, false)}, 100.0);
  QCOMPARE(pages.size(), 2);
  QCOMPARE(pages[0].size(), 1);
  QCOMPARE(pages[1].size(), 2);
  QCOMPARE(pages[1][0].y, 0.0); // no space at the top of a page
  QCOMPARE(pages[1][1].y, 15.0);
}

void ReportTest::repeatsNothingAndLosesNothing() {
  const QList<ReportBox> boxes = reportBoxes(angleReport(gui::testing::exampleResults()), 640.0);
  constexpr double height = 950.0;
  int next = 0;
  int headersRepeated = 0;
  for (const auto& page : paginate(boxes, height)) {
    if (page.front().box != next) { // a table goes on: its header, then its next row
      QCOMPARE(page.front().box, boxes[next].repeats);
      QVERIFY(page.size() > 1);
      ++headersRepeated;
    } else {
      QCOMPARE(boxes[next].repeats, -1); // no row without its header
    }
    for (const PlacedBox& placed : page) {
      if (placed.box == next) {
        ++next;
      } else {
        QCOMPARE(&placed, &page.front());
      }
      QVERIFY(placed.y + boxes[placed.box].height <= height);
    }
  }
  QCOMPARE(next, static_cast<int>(boxes.size()));
  QVERIFY(headersRepeated >= 1); // the comparison is longer than what its figures leave of a page
}

void ReportTest::pdfHasPages() {
  const QByteArray pdf = reportAsPdf(angleReport(gui::testing::exampleResults()));
  QVERIFY(pdf.startsWith("%PDF-"));
  QVERIFY(pdf.trimmed().endsWith("%%EOF"));
  QVERIFY2(pagesOf(pdf) >= 8, qPrintable(QString::number(pagesOf(pdf))));
}

void ReportTest::htmlIsWholeAndEscaped() {
  const QByteArray html = reportAsHtml(angleReport(gui::testing::exampleResults()));
  QVERIFY(html.startsWith("<!DOCTYPE html>"));
  QVERIFY(html.trimmed().endsWith("</html>"));
  QVERIFY(html.contains("S &lt;42&gt;"));
  QVERIFY(!html.contains("S <42>"));
  QCOMPARE(html.count("<figure>"), blocksOf<ReportFigure>(angleReport(gui::testing::exampleResults())).size());
  QVERIFY(!html.contains("src=\"http")); // needs no other file
}

void ReportTest::drawsTheSameInAnyThread() {
  const QList<NamedFigure> figures = angleFigures(gui::testing::exampleResults());
  QVERIFY(figures.size() >= 8);
  const auto draw = [&figures] {
    QList<QByteArray> pictures;
    for (qsizetype i = 0; i < 8; ++i) {
      pictures << plotAs(PictureFormat::Png, figures[i].make()) << plotAs(PictureFormat::Svg, figures[i].make());
    }
    return pictures;
  };
  QList<QByteArray> first;
  QList<QByteArray> second;
  std::thread one([&first, &draw] { first = draw(); });
  std::thread two([&second, &draw] { second = draw(); });
  const QList<QByteArray> here = draw();
  one.join();
  two.join();
  QVERIFY(first == here);
  QVERIFY(second == here);
}

void ReportTest::exportWritesFilesThatRead() {
  const QTemporaryDir folder;
  const auto results = gui::testing::exampleResults();
  const auto files = filesToWrite(results, everything);
  double last = 0.0;
  JobControl job;
  job.progress = [&last](double fraction) { last = fraction; };
  const Result<QStringList> written = writeFiles(files, folder.filePath("new/out"), job);
  QVERIFY2(written.has_value(), written ? "" : written.error().message().c_str());
  QCOMPARE(last, 1.0);
  QStringList sorted = *written;
  sorted.sort();
  const QDir out(folder.filePath("new/out"));
  QCOMPARE(filesBelow(out.path()), sorted);
  QVERIFY(sorted.contains("linear-32.csv") && sorted.contains("lut-64.json") && sorted.contains("plots/residual.svg"));

  const auto calibration = exporting::readCalibration(out.filePath("calibration.json").toStdString());
  QVERIFY(calibration.has_value());
  QCOMPARE(calibration->models.size(), std::size_t{3});
  const auto one = exporting::readCalibration(out.filePath("lut-64.json").toStdString());
  QVERIFY(one && one->models.size() == 1);
  QCOMPARE(one->models[0].name.text(), std::string("lut:64"));
  const auto sweep = angle::readSweepCsv(out.filePath("sweep.csv").toStdString());
  QVERIFY(sweep && sweep->encoderDeg == results->sweep->encoderDeg && sweep->sensorDeg == results->sweep->sensorDeg);
  const auto comparison =
      exporting::comparisonFromCsv(contentOf(out.filePath("comparison.csv")).toStdString(), "comparison.csv");
  QVERIFY(comparison && comparison->rows.size() == results->comparison->rows.size());
  QVERIFY(contentOf(out.filePath("linear-32.csv")).startsWith("reading_deg,correction_deg"));

  for (const QString& name : sorted) {
    const QByteArray bytes = contentOf(out.filePath(name));
    QVERIFY2(!bytes.isEmpty(), qPrintable(name));
    if (name.endsWith(".png")) {
      QCOMPARE(QImage::fromData(bytes).size(), QSize(1920, 1080));
    } else if (name.endsWith(".svg")) {
      QXmlStreamReader xml(bytes);
      while (!xml.atEnd()) {
        xml.readNext();
      }
      QVERIFY2(!xml.hasError(), qPrintable(name + xml.errorString()));
    } else if (name.endsWith(".pdf")) {
      QVERIFY2(bytes.startsWith("%PDF-"), qPrintable(name));
    }
  }
}

void ReportTest::exportLeavesNothingAfterAnError() {
  const QTemporaryDir folder;
  QFile old(folder.filePath("calibration.json"));
  QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
  old.close();
  const std::vector<FileToWrite> files{{"calibration.json", [] { return QByteArray("new"); }},
                                       {"blocked/x.csv", [] { return QByteArray("x"); }}};
  QFile blocked(folder.filePath("blocked"));
  QVERIFY(blocked.open(QIODevice::WriteOnly)); // a file stands where a folder is to be
  const Result<QStringList> written = writeFiles(files, folder.path(), {});
  QVERIFY(!written.has_value());
  QCOMPARE(written.error().kind, ErrorKind::Storage);
  QVERIFY(written.error().message().find("blocked") != std::string::npos);
  QCOMPARE(contentOf(folder.filePath("calibration.json")), QByteArray("old"));
  QCOMPARE(filesBelow(folder.path()), (QStringList{"blocked", "calibration.json"}));
}

void ReportTest::exportLeavesNothingAfterCancelling() {
  const QTemporaryDir folder;
  std::stop_source stop;
  JobControl job;
  job.stop = stop.get_token();
  const std::vector<FileToWrite> files{{"a.txt",
                                        [&stop] {
                                          stop.request_stop();
                                          return QByteArray("a");
                                        }},
                                       {"b.txt", [] { return QByteArray("b"); }}};
  const Result<QStringList> written = writeFiles(files, folder.path(), job);
  QVERIFY(!written.has_value());
  QCOMPARE(written.error().kind, ErrorKind::Cancelled);
  QCOMPARE(filesBelow(folder.path()), QStringList());
}

void ReportTest::renderDrawsWithTheSweep() {
  const QTemporaryDir folder;
  QFile calibration(folder.filePath("calibration.json"));
  QVERIFY(calibration.open(QIODevice::WriteOnly));
  calibration.write(QByteArray::fromStdString(exporting::calibrationToJson(gui::testing::exampleRun().result)));
  calibration.close();
  const QString out = folder.filePath("out");
  QCOMPARE(renderCalibration(
               {calibration.fileName(), "--out", out, "--sweep", QString::fromStdString(gui::testing::exampleFile())}),
           0);
  const QStringList names = filesBelow(out);
  for (const char* name : {"report.pdf", "report.html", "plots/correction-curve.png", "plots/correction-curve.svg",
                           "plots/correction-curve.pdf", "plots/comparison-maximum.png"}) {
    QVERIFY2(names.contains(name), name);
  }
}

void ReportTest::renderDrawsWhatTheFileHolds() {
  const QTemporaryDir folder;
  QFile calibration(folder.filePath("calibration.json"));
  QVERIFY(calibration.open(QIODevice::WriteOnly));
  calibration.write(QByteArray::fromStdString(exporting::calibrationToJson(gui::testing::exampleRun().result)));
  calibration.close();
  QCOMPARE(renderCalibration({calibration.fileName(), "--out", folder.filePath("out"), "--plots"}), 0);
  const QStringList names = filesBelow(folder.filePath("out"));
  QVERIFY(names.contains("plots/models.png"));
  QVERIFY(!names.contains("report.pdf"));
  QVERIFY(!names.contains("plots/correction-curve.png"));
}

void ReportTest::renderRefuses_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<int>("code");
  QTest::newRow("nothing") << QStringList{} << 2;
  QTest::newRow("no folder") << QStringList{"calibration.json"} << 2;
  QTest::newRow("no value") << QStringList{"calibration.json", "--out"} << 2;
  QTest::newRow("unknown option") << QStringList{"calibration.json", "--out", "x", "--colour"} << 2;
  QTest::newRow("two files") << QStringList{"a.json", "b.json", "--out", "x"} << 2;
  QTest::newRow("no such file") << QStringList{"/nonexistent/a.json", "--out", "x"} << 3;
  QTest::newRow("not a calibration") << QStringList{QString::fromStdString(gui::testing::exampleFile()), "--out", "x"}
                                     << 3;
}

void ReportTest::renderRefuses() {
  QFETCH(const QStringList, arguments);
  QFETCH(const int, code);
  QCOMPARE(renderCalibration(arguments), code);
  QVERIFY(!QDir("x").exists());
}

void ReportTest::renderRefusesAnotherSweep() {
  const QTemporaryDir folder;
  QFile calibration(folder.filePath("calibration.json"));
  QVERIFY(calibration.open(QIODevice::WriteOnly));
  calibration.write(QByteArray::fromStdString(exporting::calibrationToJson(gui::testing::exampleRun().result)));
  calibration.close();
  angle::Sweep other = gui::testing::exampleSweep();
  other.sensorDeg[3] += 1.0;
  QFile sweep(folder.filePath("other.csv"));
  QVERIFY(sweep.open(QIODevice::WriteOnly));
  sweep.write(QByteArray::fromStdString(angle::sweepToCsv(other)));
  sweep.close();
  QCOMPARE(renderCalibration({calibration.fileName(), "--out", folder.filePath("out"), "--sweep", sweep.fileName()}),
           3);
  QVERIFY(!QDir(folder.filePath("out")).exists());
}

QTEST_MAIN(ReportTest)
#include "report_test.moc"
