#include "app/gui/field_steps/field_page_words.h"
#include "app/gui/shell/field_step_catalogue.h"
#include "app/gui/shell/help_window.h"
#include "app/gui/shell/import_presenter.h"
#include "app/gui/shell/line_icon.h"
#include "app/gui/shell/program_start.h"
#include "app/gui/shell/recent_files.h"
#include "app/gui/shell/step_catalogue.h"
#include "app/gui/shell/table_clipboard.h"
#include "app/gui/shell/theme.h"
#include "core/field/block_names.h"

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QListWidget>
#include <QMap>
#include <QRegularExpression>
#include <QSettings>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace straightedge::gui {

class ShellPartsTest : public QObject {
  Q_OBJECT
private slots:
  void initTestCase();
  void options_data();
  void options();
  void aMissingDisplayIsExplained();
  void importNeedsBothAngles();
  void aRoleBelongsToOneColumn();
  void textIsReadableInBothThemes();
  void iconsFollowTheTheme();
  void recentFilesKeepTheLatest();
  void tablesAreCopiedWithTitles();
  void helpLinksLeadSomewhere();
  void everyStepAndBlockHasItsPage();

private:
  QTemporaryDir m_home;
};

void ShellPartsTest::initTestCase() {
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_home.path());
  prepareApplication(*qApp);
}

void ShellPartsTest::options_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QString>("means");
  QTest::newRow("none") << QStringList{} << "";
  QTest::newRow("file") << QStringList{"a.sedge"} << "a.sedge";
  QTest::newRow("file like an option") << QStringList{"--", "--help"} << "--help";
  QTest::newRow("simulated") << QStringList{"--simulated"} << "simulated";
  QTest::newRow("help") << QStringList{"-h"} << "help";
  QTest::newRow("version") << QStringList{"--version"} << "version";
  QTest::newRow("render") << QStringList{"--render", "a.json", "--out", "b"} << "render";
  QTest::newRow("Qt's own") << QStringList{"-platform", "xcb", "a.csv"} << "a.csv";
  QTest::newRow("unknown") << QStringList{"--fast"} << "unknown option --fast; see straightedge --help";
  QTest::newRow("two files") << QStringList{"a", "b"}
                             << "one file at a time, 2 were given; start the program once for each";
  QTest::newRow("both") << QStringList{"--simulated", "a"}
                        << "--simulated begins a new calibration; leave the file out";
}

void ShellPartsTest::options() {
  QFETCH(QStringList, arguments);
  QFETCH(QString, means);
  const ProgramOptions options = parseProgramOptions(arguments);
  const QString understood = !options.problem.isEmpty() ? options.problem
                             : options.help             ? "help"
                             : options.version          ? "version"
                             : options.render           ? "render"
                             : options.simulated        ? "simulated"
                                                        : options.files.join(' ');
  QCOMPARE(understood, means);
}

void ShellPartsTest::aMissingDisplayIsExplained() {
  const QByteArray platform = qgetenv("QT_QPA_PLATFORM");
  const QByteArray display = qgetenv("DISPLAY");
  const QByteArray wayland = qgetenv("WAYLAND_DISPLAY");
  qunsetenv("QT_QPA_PLATFORM");
  qunsetenv("DISPLAY");
  qunsetenv("WAYLAND_DISPLAY");
  QVERIFY(missingDisplay().contains("straightedge-cli"));
  qputenv("DISPLAY", ":0");
  QVERIFY(missingDisplay().isEmpty());
  qunsetenv("DISPLAY");
  qputenv("QT_QPA_PLATFORM", platform);
  QVERIFY(missingDisplay().isEmpty());
  if (!display.isEmpty()) {
    qputenv("DISPLAY", display);
  }
  if (!wayland.isEmpty()) {
    qputenv("WAYLAND_DISPLAY", wayland);
  }
}

namespace {
angle::CsvPreview threeColumns() {
  using enum angle::SweepColumn;
  angle::CsvPreview preview;
  preview.columns = {
      {"encoder_deg", Encoder, 0.0, 348.75}, {"sensor_deg", Sensor, 3.16, 352.79}, {"note", Ignored, {}, {}}};
  preview.rowCount = 32;
  preview.layout = {';', ',', true};
  return preview;
}
} // namespace

void ShellPartsTest::importNeedsBothAngles() {
  using enum angle::SweepColumn;
  ImportPresenter presenter(threeColumns());
  QCOMPARE(presenter.problem(), QString());
  QCOMPARE(presenter.layoutText(), "Separator: semicolon · decimal comma · titles in the first row · 32 rows");
  QCOMPARE(presenter.rangeText(0), "0 … 348.75");
  QCOMPARE(presenter.rangeText(2), "no numbers");
  presenter.setRole(1, Ignored);
  QCOMPARE(presenter.problem(), "Choose the column that holds the sensor angle.");
  presenter.setRole(2, Sensor);
  QCOMPARE(presenter.problem(), "The column “note” holds no numbers.");
  presenter.setRole(1, Sensor);
  presenter.setRole(0, Ignored);
  QCOMPARE(presenter.problem(), "Choose the column that holds the encoder (reference) angle.");
}

void ShellPartsTest::aRoleBelongsToOneColumn() {
  using enum angle::SweepColumn;
  ImportPresenter presenter(threeColumns());
  presenter.setRole(1, Encoder);
  QVERIFY((presenter.mapping() == angle::SweepMapping{Ignored, Encoder, Ignored}));
}

namespace {
/// Contrast of two colours after WCAG 2.1: 4.5 and more is readable.
double contrast(const QColor& a, const QColor& b) {
  const auto luminance = [](const QColor& c) {
    const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
  };
  const double la = luminance(a);
  const double lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}
} // namespace

void ShellPartsTest::textIsReadableInBothThemes() {
  for (const QPalette& palette : {lightPalette(), darkPalette()}) {
    for (const auto background : {QPalette::Window, QPalette::Base, QPalette::Button, QPalette::AlternateBase}) {
      for (const auto text : {QPalette::Text, QPalette::PlaceholderText, QPalette::Link}) {
        const double ratio = contrast(palette.color(text), palette.color(background));
        QVERIFY2(
            ratio >= 4.2,
            qPrintable(
                QString("%1 on %2: %3").arg(palette.color(text).name(), palette.color(background).name()).arg(ratio)));
      }
    }
  }
}

void ShellPartsTest::iconsFollowTheTheme() {
  const QDir folder(":/icons");
  const QStringList files = folder.entryList({"*.svg"});
  QVERIFY(files.size() >= 12);
  for (const ThemeChoice theme : {ThemeChoice::Light, ThemeChoice::Dark}) {
    applyTheme(*qApp, theme);
    const QColor ink = qApp->palette().color(QPalette::ButtonText);
    for (const QString& file : files) {
      if (file == "straightedge.svg") {
        continue; // the program's own, in its own colours
      }
      const QImage picture = lineIcon(file.chopped(4)).pixmap(64, 64).toImage();
      int inked = 0;
      for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
          const QColor pixel = picture.pixelColor(x, y);
          inked += pixel.alpha() > 250 && qAbs(pixel.lightness() - ink.lightness()) < 12 ? 1 : 0;
        }
      }
      QVERIFY2(inked > 30, qPrintable(file));
    }
  }
  applyTheme(*qApp, ThemeChoice::Light);
}

void ShellPartsTest::recentFilesKeepTheLatest() {
  RecentFiles recent;
  for (int i = 0; i < 20; ++i) {
    recent.add(QString("/tmp/%1.sedge").arg(i));
  }
  recent.add("/tmp/12.sedge"); // again: goes to the front, not in twice
  QCOMPARE(recent.files().size(), RecentFiles::maximum);
  QCOMPARE(recent.files()[0], "/tmp/12.sedge");
  QCOMPARE(recent.files()[1], "/tmp/19.sedge");
  QCOMPARE(recent.files().count("/tmp/12.sedge"), 1);
  recent.remove("/tmp/19.sedge");
  QCOMPARE(recent.files()[1], "/tmp/18.sedge");
}

void ShellPartsTest::tablesAreCopiedWithTitles() {
  QTableWidget table(2, 2);
  table.setHorizontalHeaderLabels({"Model", "Error (°)"});
  table.setItem(0, 0, new QTableWidgetItem("linear:32"));
  table.setItem(0, 1, new QTableWidgetItem("0.174"));
  table.setItem(1, 0, new QTableWidgetItem("lut:64"));
  table.setItem(1, 1, new QTableWidgetItem("1.152"));
  QVERIFY(copyFrom(&table));
  QCOMPARE(QApplication::clipboard()->text(), "Model\tError (°)\nlinear:32\t0.174\nlut:64\t1.152");
  table.setCurrentCell(1, 1);
  QVERIFY(copyFrom(&table));
  QCOMPARE(QApplication::clipboard()->text(), "1.152");
  QVERIFY(!copyFrom(nullptr));
}

void ShellPartsTest::helpLinksLeadSomewhere() {
  const QDir folder(":/help");
  const QStringList files = folder.entryList({"*.html"});
  QVERIFY(files.size() >= 11);
  const QRegularExpression link("href=\"([^\"]+)\"");
  for (const QString& file : files) {
    QFile page(folder.filePath(file));
    QVERIFY(page.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(page.readAll());
    auto matches = link.globalMatch(text);
    while (matches.hasNext()) {
      const QString target = matches.next().captured(1);
      QVERIFY2(QFile::exists(folder.filePath(target)), qPrintable(file + " -> " + target));
    }
  }
}

void ShellPartsTest::everyStepAndBlockHasItsPage() {
  // What each page has to say, beside the parts that every block's page has.
  const QMap<QString, QStringList> terms{
      {"field-nonlinearity", {"polynomial", "plateau", "order", "foretold"}},
      {"field-probe-temperature", {"PT100", "chamber", "hysteresis", "lag", "uncertainty"}},
      {"field-offset", {"zero-field chamber", "drift", "PT100"}},
      {"field-sensitivity", {"slope", "intercept", "cubic", "locked"}},
      {"field-electronics", {"climate chamber", "electronics", "drift"}},
      {"field-electronics-sensitivity", {"gain", "electronics", "future work"}},
      {"field-axis-matrix", {"orientation", "tilt", "angles between the axes", "package"}},
      {"field-joint", {"Levenberg", "block after block", "weight|count"}},
      {"field-verify", {"limit", "peak", "one sigma", "surface", "full scale"}},
      {"field-uncertainty", {"expanded uncertainty", "residual", "repeatability", "95"}},
      {"field-review", {"plateaus", "sweeps", "sphere"}},
      {"field-fit", {"order", "reference temperature", "blocks"}},
      {"field-compare", {"coefficients", "multiplications"}},
      {"field-export", {"calibration.json", "report", "OpenGL"}},
  };
  QStringList wanted = terms.keys();
  for (const StepEntry& step : fieldStepCatalogue()) {
    wanted << QString(step.helpPage);
  }
  for (const StepEntry& step : stepCatalogue()) {
    wanted << QString(step.helpPage);
  }
  for (const auto& [block, word] : straightedge::field::blockWords) {
    wanted << blockHelpPage(block);
    QVERIFY2(terms.contains(blockHelpPage(block)), qPrintable(blockHelpPage(block)));
  }
  HelpWindow help;
  const auto* contents = help.findChild<QListWidget*>();
  QStringList listed;
  for (int row = 0; row < contents->count(); ++row) {
    listed << contents->item(row)->data(Qt::UserRole).toString();
  }
  for (const QString& page : wanted) {
    help.showPage(page);
    QCOMPARE(help.currentPage(), page);
    QVERIFY2(listed.contains(page), qPrintable(page + " is not among the contents"));
    QVERIFY2(help.text().size() > 400, qPrintable(page));
    QString text = help.text();
    for (const QString& term : terms.value(page)) {
      QVERIFY2(text.contains(QRegularExpression(term, QRegularExpression::CaseInsensitiveOption)),
               qPrintable(page + " does not say: " + term));
    }
    const bool ofABlock = page.startsWith("field-") &&
                          !QStringList({"field-review", "field-fit", "field-compare", "field-export"}).contains(page);
    for (const char* part : {"How it is measured", "Formula", "What the figures show", "Source"}) {
      QVERIFY2(!ofABlock || text.contains(part), qPrintable(page + " has no part: " + part));
    }
    QVERIFY2(!ofABlock || page == "field-uncertainty" || text.contains("costs"), qPrintable(page));
  }
  // Every page is listed, and every page of the field calibration is reached by links from its overview.
  const QDir folder(":/help");
  for (const QString& file : folder.entryList({"*.html"})) {
    QVERIFY2(listed.contains(file.section('.', 0, 0)), qPrintable(file));
  }
  const QRegularExpression link("href=\"([^\"]+)[.]html\"");
  QStringList reached{"field"};
  for (qsizetype i = 0; i < reached.size(); ++i) {
    QFile page(folder.filePath(reached[i] + ".html"));
    QVERIFY(page.open(QIODevice::ReadOnly));
    auto matches = link.globalMatch(QString::fromUtf8(page.readAll()));
    while (matches.hasNext()) {
      const QString target = matches.next().captured(1);
      if (!reached.contains(target)) {
        reached << target;
      }
    }
  }
  for (const QString& page : terms.keys()) {
    QVERIFY2(reached.contains(page), qPrintable(page + " cannot be reached"));
  }
}

} // namespace straightedge::gui

QTEST_MAIN(straightedge::gui::ShellPartsTest)
#include "shell_parts_test.moc"
