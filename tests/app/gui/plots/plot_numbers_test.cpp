// What a plot computes before it paints: scales, ticks, thinning, layout.
#include "app/gui/plots/axis_scale.h"
#include "app/gui/plots/decimation.h"
#include "app/gui/plots/plot_data_text.h"
#include "app/gui/plots/plot_layout.h"
#include "app/gui/plots/plot_window.h"
#include "app/gui/plots/theme.h"
#include "app/gui/plots/ticks.h"
#include "tests/app/gui/plots/figures.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace straightedge::gui {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

PlotSpec oneSeries(const QList<double>& x, const QList<double>& y) {
  PlotSpec spec;
  PlotSeries series;
  series.x = x;
  series.y = y;
  spec.series << series;
  return spec;
}

/// Every text on a plot, for finding overlaps.
QList<PlacedText> textsOf(const PlotLayout& layout) {
  QList<PlacedText> texts = {layout.title,   layout.xTitle,  layout.yTitle,      layout.rightTitle,
                             layout.xRemark, layout.yRemark, layout.rightRemark, layout.note};
  texts += layout.xLabels + layout.yLabels + layout.rightLabels;
  for (const LegendEntry& entry : layout.legend) {
    texts << PlacedText{entry.rect, entry.text};
  }
  texts.removeIf([](const PlacedText& t) { return t.text.isEmpty(); });
  return texts;
}

} // namespace

class PlotNumbersTest : public QObject {
  Q_OBJECT
private slots:
  void scaleGoesThereAndBack();
  void tickLabels_data();
  void tickLabels();
  void remarkHoldsWhatLabelsLeaveOut();
  void logarithmicDecades();
  void readableValues_data();
  void readableValues();
  void marginOfFivePercent();
  void emptyAndOddDataHaveAWindow_data();
  void emptyAndOddDataHaveAWindow();
  void logarithmicAxisCountsWhatItLeavesOut();
  void decimationKeepsTheExtremesOfEveryColumn();
  void decimationKeepsGaps();
  void farPointsAreCutWithoutBending();
  void stepsHoldTheirValue();
  void textsNeverOverlap_data();
  void textsNeverOverlap();
  void legendLeavesThePlotFree();
  void paletteCanBeRead();
  void dataAsTable();
};

void PlotNumbersTest::scaleGoesThereAndBack() {
  const AxisScale linear{1.7e9, 1.7e9 + 1.0, false};
  QVERIFY(std::abs(linear.toUnit(1.7e9 + 0.25) - 0.25) < 1e-6);
  const AxisScale decades{1e-3, 1e3, true};
  QVERIFY(std::abs(decades.toUnit(1.0) - 0.5) < 1e-12);
  QVERIFY(std::abs(decades.fromUnit(1.0 / 6.0) - 1e-2) < 1e-12);
  QVERIFY(std::isnan(decades.toUnit(0.0)));
  QVERIFY(std::isnan(decades.toUnit(-1.0)));
  const AxisScale deepest{1.0, 1.0 + 1e-11, false};
  QCOMPARE(deepest.part(0.499, 0.501), deepest); // doubles resolve no more
}

void PlotNumbersTest::tickLabels_data() {
  QTest::addColumn<double>("minimum");
  QTest::addColumn<double>("maximum");
  QTest::addColumn<int>("count");
  QTest::addColumn<double>("preferred");
  QTest::addColumn<QString>("labels");
  QTest::newRow("turn") << 0.0 << 360.0 << 10 << 45.0 << "0 45 90 135 180 225 270 315 360";
  QTest::newRow("turn, little room") << 0.0 << 360.0 << 5 << 45.0 << "0 90 180 270 360";
  QTest::newRow("eighth of a turn") << 10.0 << 60.0 << 6 << 45.0 << "15 30 45 60";
  QTest::newRow("part of a degree") << 10.0 << 10.5 << 6 << 45.0 << "10.0 10.1 10.2 10.3 10.4 10.5";
  QTest::newRow("around zero") << -0.6 << 0.6 << 8 << 0.0 << "−0.6 −0.4 −0.2 0.0 0.2 0.4 0.6";
  QTest::newRow("integers") << 0.0 << 17.0 << 18 << 1.0 << "0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17";
}

void PlotNumbersTest::tickLabels() {
  QFETCH(double, minimum);
  QFETCH(double, maximum);
  QFETCH(int, count);
  QFETCH(double, preferred);
  QFETCH(QString, labels);
  const Ticks ticks =
      linearTicks({minimum, maximum, false}, count, preferred > 0.0 ? std::optional(preferred) : std::nullopt);
  QCOMPARE(ticks.labels.join(u' '), labels);
  QVERIFY(ticks.remark.isEmpty());
  QCOMPARE(ticks.positions.size(), ticks.labels.size());
}

void PlotNumbersTest::remarkHoldsWhatLabelsLeaveOut() {
  const Ticks ratio = linearTicks({1.0 - 1.1e-9, 1.0 + 1.1e-9, false}, 6);
  QCOMPARE(ratio.labels.join(u' '), QStringLiteral("−1.0 −0.5 0.0 0.5 1.0"));
  QCOMPARE(ratio.remark, QStringLiteral("× 10⁻⁹ + 1"));
  const Ticks epoch = linearTicks({1.7e9, 1.7e9 + 600.0, false}, 7);
  QCOMPARE(epoch.labels.join(u' '), QStringLiteral("0 100 200 300 400 500 600"));
  QCOMPARE(epoch.remark, QStringLiteral("+ 1700000000"));
  const Ticks micro = linearTicks({0.0, 5e-6, false}, 6);
  QCOMPARE(micro.labels.join(u' '), QStringLiteral("0 1 2 3 4 5"));
  QCOMPARE(micro.remark, QStringLiteral("× 10⁻⁶"));
  QCOMPARE(QSet<QString>(ratio.labels.begin(), ratio.labels.end()).size(), ratio.labels.size());
}

void PlotNumbersTest::logarithmicDecades() {
  QCOMPARE(logarithmicTicks({1.0, 1000.0, true}, 5).labels.join(u' '), QStringLiteral("1 10 100 1000"));
  QCOMPARE(logarithmicTicks({1.0, 100.0, true}, 7).labels.join(u' '), QStringLiteral("1 2 5 10 20 50 100"));
  QCOMPARE(logarithmicTicks({1e-7, 1.0, true}, 9).labels.first(), QStringLiteral("10⁻⁷"));
  QVERIFY(logarithmicTicks({1e-20, 1e20, true}, 6).labels.size() <= 6);
  QVERIFY(logarithmicTicks({1.02, 1.04, true}, 5).labels.size() >= 3); // less than a decade
}

void PlotNumbersTest::readableValues_data() {
  QTest::addColumn<double>("value");
  QTest::addColumn<double>("minimum");
  QTest::addColumn<double>("maximum");
  QTest::addColumn<QString>("text");
  QTest::newRow("entries") << 64.0 << 2.0 << 1024.0 << "64";
  QTest::newRow("angle") << 11.25 << 0.0 << 360.0 << "11.25";
  QTest::newRow("negative") << -0.5 << -1.0 << 1.0 << "−0.5";
  QTest::newRow("deviation") << 1.0 + 2.5e-10 << 1.0 - 1e-9 << 1.0 + 1e-9 << "1.00000000025";
  QTest::newRow("small") << 1.25e-7 << 0.0 << 1e-6 << "1.25 × 10⁻⁷";
  QTest::newRow("zero") << 0.0 << -1.0 << 1.0 << "0";
  QTest::newRow("none") << nan << -1.0 << 1.0 << "–";
}

void PlotNumbersTest::readableValues() {
  QFETCH(double, value);
  QFETCH(double, minimum);
  QFETCH(double, maximum);
  QTEST(readableValue(value, {minimum, maximum, false}), "text");
}

void PlotNumbersTest::marginOfFivePercent() {
  const PlotWindow window = wholeWindow(oneSeries({0.0, 10.0}, {-1.0, 3.0}));
  QCOMPARE(window.x.minimum, -0.5);
  QCOMPARE(window.x.maximum, 10.5);
  QCOMPARE(window.y.minimum, -1.2);
  QCOMPARE(window.y.maximum, 3.2);
  PlotSpec fixed = oneSeries({0.0, 10.0}, {-1.0, 3.0});
  fixed.x.minimum = 0.0;
  fixed.x.maximum = 12.0;
  QCOMPARE(wholeWindow(fixed).x, (AxisScale{0.0, 12.0, false}));
  PlotSpec bars = oneSeries({1.0, 2.0}, {4.0, 6.0});
  bars.series[0].style = SeriesStyle::Bars;
  QCOMPARE(wholeWindow(bars).y.minimum, 0.0);
}

void PlotNumbersTest::emptyAndOddDataHaveAWindow_data() {
  QTest::addColumn<QList<double>>("x");
  QTest::addColumn<QList<double>>("y");
  QTest::addColumn<bool>("logarithmic");
  const double infinity = std::numeric_limits<double>::infinity();
  for (const bool logarithmic : {false, true}) {
    const char* kind = logarithmic ? "log" : "linear";
    QTest::addRow("%s none", kind) << QList<double>{} << QList<double>{} << logarithmic;
    QTest::addRow("%s one", kind) << QList<double>{3.0} << QList<double>{5.0} << logarithmic;
    QTest::addRow("%s same", kind) << QList<double>{3.0, 3.0} << QList<double>{5.0, 5.0} << logarithmic;
    QTest::addRow("%s NaN", kind) << QList<double>{nan, 1.0} << QList<double>{5.0, nan} << logarithmic;
    QTest::addRow("%s infinite", kind) << QList<double>{1.0, 2.0} << QList<double>{infinity, 4.0} << logarithmic;
    QTest::addRow("%s ≤ 0", kind) << QList<double>{-1.0, 0.0} << QList<double>{0.0, -2.0} << logarithmic;
    QTest::addRow("%s huge", kind) << QList<double>{1e300, 1.0} << QList<double>{1e-300, 1e300} << logarithmic;
  }
}

void PlotNumbersTest::emptyAndOddDataHaveAWindow() {
  QFETCH(QList<double>, x);
  QFETCH(QList<double>, y);
  QFETCH(bool, logarithmic);
  PlotSpec spec = oneSeries(x, y);
  spec.x.logarithmic = spec.y.logarithmic = logarithmic;
  const PlotWindow window = wholeWindow(spec);
  for (const AxisScale& scale : {window.x, window.y}) {
    QVERIFY(std::isfinite(scale.minimum) && std::isfinite(scale.maximum));
    QVERIFY(scale.minimum < scale.maximum);
    QVERIFY(!logarithmic || scale.minimum > 0.0);
    const Ticks ticks = fittingTicks(scale, 400.0, 12.0, {}, [](const QString& t) { return 7.0 * double(t.size()); });
    QVERIFY(ticks.positions.size() < 50);
  }
}

void PlotNumbersTest::logarithmicAxisCountsWhatItLeavesOut() {
  PlotSpec spec = oneSeries({1, 2, 3, 4, 5}, {0.1, 0.0, -0.5, nan, 0.2});
  QVERIFY(leftOutNote(spec).isEmpty());
  spec.y.logarithmic = true;
  QVERIFY(leftOutNote(spec).startsWith(QStringLiteral("2 values ≤ 0")));
  QVERIFY(layOut(spec, wholeWindow(spec), {0, 0, 800, 500}, PlotFonts::standard()).note.text.contains(u'2'));
  spec.series[0].visible = false;
  QVERIFY(leftOutNote(spec).isEmpty());
}

void PlotNumbersTest::decimationKeepsTheExtremesOfEveryColumn() {
  constexpr std::size_t count = 200000;
  constexpr int columns = 500;
  std::vector<double> x(count);
  std::vector<double> y(count);
  for (std::size_t i = 0; i < count; ++i) {
    x[i] = static_cast<double>(i);
    y[i] = std::sin(0.37 * static_cast<double>(i * i % 9973));
  }
  const AxisScale xScale{0.0, static_cast<double>(count), false};
  const AxisScale yScale{-1.0, 1.0, false};
  for (const bool ascending : {true, false}) {
    const auto points = decimate(x, y, xScale, yScale, columns, ascending);
    QVERIFY(points.size() <= 4U * (columns + 1));
    std::vector<double> low(columns, 2.0);
    std::vector<double> high(columns, -1.0);
    std::vector<double> lowKept = low;
    std::vector<double> highKept = high;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t c = i * columns / count;
      low[c] = std::min(low[c], yScale.toUnit(y[i]));
      high[c] = std::max(high[c], yScale.toUnit(y[i]));
    }
    for (const UnitPoint& p : points) {
      const auto c = static_cast<std::size_t>(p.x * columns);
      lowKept[c] = std::min(lowKept[c], p.y);
      highKept[c] = std::max(highKept[c], p.y);
    }
    QVERIFY(low == lowKept);
    QVERIFY(high == highKept);
    QVERIFY(std::is_sorted(points.begin(), points.end(), [](auto a, auto b) { return a.x < b.x; }));
  }
}

void PlotNumbersTest::decimationKeepsGaps() {
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 0; i < 10000; ++i) {
    x.push_back(i);
    y.push_back(i >= 4000 && i < 5000 ? nan : 1.0);
  }
  const auto points = decimate(x, y, {0.0, 10000.0, false}, {0.0, 2.0, false}, 100, true);
  const auto runs = clippedRuns(points);
  QCOMPARE(runs.size(), 2U);
  QVERIFY(runs[0].back().x < 0.4);
  QVERIFY(runs[1].front().x >= 0.5);
  // NaN in x, too, and values a logarithmic axis cannot show.
  const std::vector<double> few = {1.0, nan, 3.0, 4.0, 5.0};
  const std::vector<double> values = {1.0, 1.0, 1.0, 0.0, 1.0};
  QCOMPARE(clippedRuns(decimate(few, values, {0.0, 6.0, false}, {0.1, 10.0, true}, 100, false)).size(), 3U);
}

void PlotNumbersTest::farPointsAreCutWithoutBending() {
  const auto runs = clippedRuns({{-1e9, -1e9}, {1e9, 1e9}});
  QCOMPARE(runs.size(), 1U);
  for (const UnitPoint& p : runs[0]) {
    QVERIFY(std::abs(p.x - p.y) < 1e-6);
    QVERIFY(p.x > -0.3 && p.x < 1.3);
  }
  QVERIFY(clippedRuns({{-1e9, 5.0}, {1e9, 5.0}}).empty());
}

void PlotNumbersTest::stepsHoldTheirValue() {
  const auto corners = stepCorners({{0.0, 1.0}, {1.0, 2.0}, {nan, nan}, {2.0, 3.0}, {3.0, 4.0}});
  QCOMPARE(corners.size(), 7U);
  QCOMPARE(corners[1].x, 1.0);
  QCOMPARE(corners[1].y, 1.0);
  QCOMPARE(corners[5].x, 3.0);
  QCOMPARE(corners[5].y, 3.0);
}

void PlotNumbersTest::textsNeverOverlap_data() {
  QTest::addColumn<PlotSpec>("spec");
  QTest::addColumn<QSize>("size");
  PlotSpec many = figures::errorVersusStorage();
  for (int i = 0; i < 12; ++i) {
    PlotSeries extra = many.series[0];
    extra.name = QStringLiteral("Another model with a long name %1").arg(i);
    many.series << extra;
  }
  PlotSpec bothTiny = figures::secondAxis();
  for (double& y : bothTiny.series[0].y) {
    y = 1.0 + 1e-9 * y;
  }
  for (double& y : bothTiny.series[1].y) {
    y *= 1e-9;
  }
  const QList<std::pair<const char*, PlotSpec>> specs = {{"angle", figures::errorOverAngle()},
                                                         {"storage", figures::errorVersusStorage()},
                                                         {"harmonics", figures::harmonics()},
                                                         {"second axis", figures::secondAxis()},
                                                         {"tiny range", figures::tinyRange()},
                                                         {"many series", many},
                                                         {"both remarks", bothTiny}};
  for (const auto& [name, spec] : specs) {
    for (const QSize size : {QSize(300, 200), QSize(420, 300), QSize(640, 240), QSize(800, 500), QSize(1600, 1000)}) {
      QTest::addRow("%s %d×%d", name, size.width(), size.height()) << spec << size;
    }
  }
}

void PlotNumbersTest::textsNeverOverlap() {
  QFETCH(PlotSpec, spec);
  QFETCH(QSize, size);
  const QRectF area(QPointF(0, 0), size);
  for (const double zoom : {1.0, 0.37, 0.011}) {
    const PlotWindow window = wholeWindow(spec).part(0.3, 0.4, 0.3 + zoom, 0.4 + zoom);
    const PlotLayout layout = layOut(spec, zoom == 1.0 ? wholeWindow(spec) : window, area, PlotFonts::standard());
    const QList<PlacedText> texts = textsOf(layout);
    QVERIFY(layout.yLabels.size() >= 2 || zoom < 1.0);
    QVERIFY(layout.plot.height() >= 0.3 * size.height());
    QVERIFY(layout.plot.width() >= 0.5 * size.width());
    for (qsizetype i = 0; i < texts.size(); ++i) {
      QVERIFY2(area.contains(texts[i].rect), qPrintable(QStringLiteral("“%1” is cut").arg(texts[i].text)));
      QVERIFY2(!texts[i].rect.intersects(layout.plot.adjusted(1, 1, -1, -1)),
               qPrintable(QStringLiteral("“%1” covers data").arg(texts[i].text)));
      for (qsizetype k = 0; k < i; ++k) {
        QVERIFY2(!texts[i].rect.intersects(texts[k].rect),
                 qPrintable(QStringLiteral("“%1” over “%2”").arg(texts[i].text, texts[k].text)));
      }
    }
  }
}

void PlotNumbersTest::legendLeavesThePlotFree() {
  const PlotSpec spec = figures::errorVersusStorage();
  const PlotLayout layout = layOut(spec, wholeWindow(spec), {0, 0, 800, 500}, PlotFonts::standard());
  QCOMPARE(layout.legend.size(), 5);
  for (const LegendEntry& entry : layout.legend) {
    QVERIFY(!entry.rect.intersects(layout.plot));
  }
}

void PlotNumbersTest::paletteCanBeRead() {
  for (const PlotTheme theme : {PlotTheme::Light, PlotTheme::Dark}) {
    const PlotColors colors = PlotColors::of(theme);
    QVERIFY(contrastRatio(colors.text, colors.background) >= 7.0);
    QVERIFY(contrastRatio(colors.softText, colors.background) >= 4.5);
    for (int role = 0; role <= static_cast<int>(SeriesColor::Bad); ++role) {
      const double ratio = contrastRatio(PlotColors::series(static_cast<SeriesColor>(role), theme), colors.background);
      QVERIFY2(ratio >= 3.0, qPrintable(QStringLiteral("role %1: %2").arg(role).arg(ratio)));
    }
  }
}

void PlotNumbersTest::dataAsTable() {
  PlotSpec spec = oneSeries({0.1, 0.2}, {1.0, nan});
  spec.x.title = QStringLiteral("Angle, sensor (°)");
  spec.series[0].name = QStringLiteral("A");
  spec.series << spec.series[0];
  spec.series[1].name = QStringLiteral("B");
  spec.series[1].y = {3.0, 4.0};
  QCOMPARE(dataAsText(spec, u','), QStringLiteral("\"Angle, sensor (°)\",A,B\n0.1,1,3\n0.2,,4\n"));
  QCOMPARE(dataAsText(spec, u'\t'), QStringLiteral("Angle, sensor (°)\tA\tB\n0.1\t1\t3\n0.2\t\t4\n"));
}

} // namespace straightedge::gui

QTEST_MAIN(straightedge::gui::PlotNumbersTest)
#include "plot_numbers_test.moc"
