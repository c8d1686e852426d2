// What ends up on paper: the pixels and files of a plot, whoever paints it.
#include "app/gui/plots/plot_view.h"
#include "app/gui/plots/theme.h"
#include "tests/app/gui/plots/figures.h"

#include <QFile>
#include <QPainter>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <cmath>
#include <limits>
#include <thread>

namespace straightedge::gui {
namespace {

QImage painted(const PlotSpec& spec, const QSize& size, double scale = 1.0, PlotTheme theme = PlotTheme::Light) {
  QImage image(size * scale, QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(scale);
  image.fill(Qt::magenta);
  QPainter painter(&image);
  paintPlot(painter, QRectF(QPointF(0, 0), size), spec, theme);
  painter.end();
  return image;
}

int distance(const QColor& a, const QColor& b) {
  return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
}

int pixelsLike(const QImage& image, const QColor& color) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      count += distance(image.pixelColor(x, y), color) < 40 ? 1 : 0;
    }
  }
  return count;
}

double meanDifference(const QImage& a, const QImage& b) {
  double sum = 0.0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      sum += distance(a.pixelColor(x, y), b.pixelColor(x, y));
    }
  }
  return sum / (3.0 * a.width() * a.height());
}

PlotSpec bare(const QList<double>& x, const QList<double>& y, SeriesStyle style) {
  PlotSpec spec;
  PlotSeries series;
  series.x = x;
  series.y = y;
  series.style = style;
  spec.series << series;
  return spec;
}

const QColor blue = PlotColors::series(SeriesColor::First, PlotTheme::Light);

} // namespace

class PlotPictureTest : public QObject {
  Q_OBJECT
private slots:
  void everyFigureShowsItsSeries_data();
  void everyFigureShowsItsSeries();
  void firstPaintOfLogarithmicAxesHasTheCurve();
  void zeroAndNegativeLeaveTheAxisLogarithmic();
  void stepsAreSteps();
  void barsStandOnZero();
  void gapsStayGaps();
  void emphasisedPointsAreHollow();
  void highResolutionIsTheSameLayoutAndSharper();
  void everySignIsDrawn();
  void clipIsRespected();
  void denseWideLineIsPainted();
  void severalThreadsPaintTheSame();
  void screenAndFileAgree();
  void writesPngSvgPdf();
  void saysWhatKeepsItFromWriting();
};

void PlotPictureTest::everyFigureShowsItsSeries_data() {
  QTest::addColumn<int>("figure");
  for (int i = 0; i < 7; ++i) {
    QTest::addRow("figure %d", i) << i;
  }
}

void PlotPictureTest::everyFigureShowsItsSeries() {
  QFETCH(int, figure);
  const std::array makers = {figures::errorOverAngle, figures::errorVersusStorage, figures::harmonics,
                             figures::residualSteps,  figures::coverageRing,       figures::secondAxis,
                             figures::tinyRange};
  PlotSpec spec = makers.at(static_cast<std::size_t>(figure))();
  for (const PlotTheme theme : {PlotTheme::Light, PlotTheme::Dark}) {
    const QImage all = painted(spec, {700, 450}, 1.0, theme);
    QCOMPARE(pixelsLike(all, Qt::magenta), 0); // the whole area is painted
    for (int s = 0; s < spec.series.size(); ++s) {
      PlotSpec without = spec;
      without.series[s].visible = false;
      without.series[s].name.clear();
      const QColor color = PlotColors::series(spec.series[s].color, theme);
      QVERIFY(pixelsLike(all, color) > pixelsLike(painted(without, {700, 450}, 1.0, theme), color) + 8);
    }
  }
}

void PlotPictureTest::firstPaintOfLogarithmicAxesHasTheCurve() {
  PlotSpec spec = bare({1.0, 10.0, 100.0, 1000.0}, {1.0, 0.1, 0.01, 0.001}, SeriesStyle::Line);
  spec.x.logarithmic = spec.y.logarithmic = true;
  QVERIFY(pixelsLike(painted(spec, {400, 300}), blue) > 100);
  PlotView view;
  view.resize(400, 300);
  view.setSpec(spec);
  QSignalSpy once(&view, &PlotView::painted);
  const QImage shown = view.grab().toImage();
  QCOMPARE(once.size(), 1);
  QVERIFY(pixelsLike(shown, blue) > 100);
}

void PlotPictureTest::zeroAndNegativeLeaveTheAxisLogarithmic() {
  PlotSpec spec = bare({1, 2, 3, 4, 5}, {1.0, 0.0, 0.01, -3.0, 0.0001}, SeriesStyle::Points);
  spec.y.logarithmic = true;
  PlotView view;
  view.resize(600, 400);
  view.setSpec(spec);
  // Equal ratios are equal distances: the axis is still logarithmic, and spans the positive values only.
  const double upper = view.toPixels(1, 0.01).y() - view.toPixels(1, 1.0).y();
  const double lower = view.toPixels(1, 0.0001).y() - view.toPixels(1, 0.01).y();
  QVERIFY(std::abs(upper - lower) < 1e-6);
  QVERIFY(upper > 0.4 * view.plotArea().height());
}

void PlotPictureTest::stepsAreSteps() {
  PlotView view;
  view.resize(600, 400);
  view.setSpec(bare({0.0, 1.0, 2.0, 3.0}, {0.0, 1.0, 0.5, 0.5}, SeriesStyle::Steps));
  const QImage image = view.grab().toImage();
  const auto isLine = [&](double x, double y) {
    const QPointF at = view.toPixels(x, y);
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (distance(image.pixelColor(at.toPoint() + QPoint(dx, dy)), blue) < 120) {
          return true;
        }
      }
    }
    return false;
  };
  for (const double part : {0.2, 0.5, 0.8}) {
    QVERIFY(isLine(part, 0.0));
    QVERIFY(isLine(1.0 + part, 1.0));
    QVERIFY(isLine(1.0, part)); // the riser is where the next value begins
    QVERIFY(!isLine(part, part));
  }
}

void PlotPictureTest::barsStandOnZero() {
  PlotView view;
  view.resize(600, 400);
  view.setSpec(bare({1.0, 2.0, 3.0}, {2.0, -1.0, 3.0}, SeriesStyle::Bars));
  const QImage image = view.grab().toImage();
  const auto filled = [&](double x, double y) {
    return distance(image.pixelColor(view.toPixels(x, y).toPoint()), blue) < 130;
  };
  QVERIFY(filled(1.0, 1.0) && filled(1.3, 1.0) && !filled(1.0, 2.2) && !filled(1.0, -0.3));
  QVERIFY(filled(2.0, -0.5) && !filled(2.0, 0.3));
  QVERIFY(filled(3.0, 2.8) && !filled(2.5, 0.5));
}

void PlotPictureTest::gapsStayGaps() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  PlotView view;
  view.resize(600, 400);
  view.setSpec(bare({0.0, 1.0, 2.0, 3.0, 4.0}, {1.0, 1.0, nan, 1.0, 1.0}, SeriesStyle::Line));
  const QImage image = view.grab().toImage();
  const auto line = [&](double x) {
    const QPoint at = view.toPixels(x, 1.0).toPoint();
    return distance(image.pixelColor(at), blue) < 150 || distance(image.pixelColor(at + QPoint(0, -1)), blue) < 150;
  };
  QVERIFY(line(0.5));
  QVERIFY(!line(2.0));
  QVERIFY(line(3.5));
}

void PlotPictureTest::emphasisedPointsAreHollow() {
  PlotSpec spec = bare({0.0, 1.0}, {0.0, 1.0}, SeriesStyle::Points);
  spec.series[0].emphasised = {false, true};
  PlotView view;
  view.resize(400, 300);
  view.setSpec(spec);
  const QImage image = view.grab().toImage();
  QVERIFY(distance(image.pixelColor(view.toPixels(0.0, 0.0).toPoint()), blue) < 60);
  QVERIFY(distance(image.pixelColor(view.toPixels(1.0, 1.0).toPoint()), Qt::white) < 60);
}

void PlotPictureTest::highResolutionIsTheSameLayoutAndSharper() {
  const PlotSpec spec = figures::errorOverAngle();
  const QSize size(640, 400);
  const QImage once = painted(spec, size);
  const QImage twice = painted(spec, size, 2.0);
  QCOMPARE(twice.size(), size * 2);
  const QImage shrunk = twice.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  QVERIFY2(meanDifference(once, shrunk) < 6.0, qPrintable(QString::number(meanDifference(once, shrunk))));
  const QImage blown = once.scaled(size * 2, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  QVERIFY(meanDifference(twice, blown) > 1.0); // not merely magnified
  PlotView view;
  view.resize(size);
  view.setSpec(spec);
  QCOMPARE(view.picture(size, 2.0).size(), size * 2);
}

void PlotPictureTest::everySignIsDrawn() {
  QList<QImage> images;
  const QString missing(QChar(0xf8ff)); // private use: what a missing sign looks like
  for (const QString& sign :
       {missing, QStringLiteral("θ"), QStringLiteral("°"), QStringLiteral("Ω"), QStringLiteral("µ"),
        QStringLiteral("⁻"), QStringLiteral("⁷"), QStringLiteral("≤"), QStringLiteral("→"), QStringLiteral("−"),
        QStringLiteral("×"), QStringLiteral("["), QStringLiteral("(")}) {
    PlotSpec spec = bare({0.0, 1.0}, {0.0, 1.0}, SeriesStyle::Line);
    spec.x.title = sign;
    const QImage image = painted(spec, {300, 200});
    QVERIFY2(!images.contains(image), qPrintable(sign + QStringLiteral(" looks like another sign")));
    images << image;
  }
}

void PlotPictureTest::clipIsRespected() {
  QImage image(500, 400, QImage::Format_RGB32);
  image.fill(Qt::magenta);
  QPainter painter(&image);
  painter.setClipRect(QRect(50, 40, 400, 300));
  paintPlot(painter, QRectF(20, 10, 460, 380), figures::errorOverAngle(), PlotTheme::Light);
  painter.end();
  QCOMPARE(pixelsLike(image, Qt::magenta), 500 * 400 - 400 * 300); // nothing outside, everything inside
  QCOMPARE(pixelsLike(image.copy(50, 40, 400, 300), Qt::magenta), 0);
}

void PlotPictureTest::denseWideLineIsPainted() {
  QList<double> x;
  QList<double> y;
  for (int i = 0; i < 100000; ++i) {
    x << i;
    y << std::sin(0.001 * i) + 0.2 * std::sin(12.9898 * i * i);
  }
  PlotSpec spec = bare(x, y, SeriesStyle::Line);
  spec.series[0].y[500] = 1e300; // far away, and still quick and right
  spec.y.minimum = -1.5;
  spec.y.maximum = 1.5;
  QVERIFY(pixelsLike(painted(spec, {600, 300}, 2.0), blue) > 20000);
}

void PlotPictureTest::severalThreadsPaintTheSame() {
  const PlotSpec spec = figures::errorVersusStorage();
  const QImage expected = painted(spec, {500, 350});
  std::array<QImage, 3> images;
  {
    std::array<std::jthread, 3> threads;
    for (std::size_t i = 0; i < threads.size(); ++i) {
      threads[i] = std::jthread([&images, &spec, i] { images[i] = painted(spec, {500, 350}); });
    }
  }
  for (const QImage& image : images) {
    QCOMPARE(image, expected);
  }
}

void PlotPictureTest::screenAndFileAgree() {
  PlotView view;
  view.resize(700, 450);
  view.setSpec(figures::errorOverAngle());
  const QImage screen = view.grab().toImage().convertToFormat(QImage::Format_RGB32);
  const QImage picture = view.picture({700, 450}, 1.0).convertToFormat(QImage::Format_RGB32);
  QCOMPARE(screen, picture);
}

void PlotPictureTest::writesPngSvgPdf() {
  const QTemporaryDir folder;
  PlotView view;
  view.resize(700, 450);
  view.setSpec(figures::errorOverAngle());
  QString problem;
  QVERIFY(view.saveAs(folder.filePath("plot.png"), &problem));
  QCOMPARE(QImage(folder.filePath("plot.png")).size(), QSize(1400, 900));

  QVERIFY(view.saveAs(folder.filePath("plot.svg"), &problem));
  QFile svg(folder.filePath("plot.svg"));
  QVERIFY(svg.open(QIODevice::ReadOnly));
  const QString drawing = QString::fromUtf8(svg.readAll());
  QVERIFY(drawing.contains(QStringLiteral("Sensor angle (°)")));
  QVERIFY(drawing.contains(QStringLiteral(">315<")));
  QVERIFY(drawing.contains(blue.name()));
  QVERIFY(drawing.contains(QStringLiteral("<polyline")));

  QVERIFY(view.saveAs(folder.filePath("plot.pdf"), &problem));
  QFile pdf(folder.filePath("plot.pdf"));
  QVERIFY(pdf.open(QIODevice::ReadOnly));
  const QByteArray page = pdf.readAll();
  QVERIFY(page.startsWith("%PDF"));
  QVERIFY(page.contains("/MediaBox [0 0 525"));
  QVERIFY(page.contains("FontFile"));
  QVERIFY(problem.isEmpty());
}

void PlotPictureTest::saysWhatKeepsItFromWriting() {
  const QTemporaryDir folder;
  PlotView view;
  view.setSpec(figures::harmonics());
  QString problem;
  QVERIFY(!view.saveAs(folder.filePath("plot.bmp"), &problem));
  QVERIFY(problem.contains(QStringLiteral("plot.bmp")) && problem.contains(QStringLiteral(".svg")));
  QVERIFY(!QFile::exists(folder.filePath("plot.bmp")));
  QVERIFY(!view.saveAs(folder.filePath("no/such/folder/plot.png"), &problem));
  QVERIFY(problem.contains(QStringLiteral("plot.png")));
}

} // namespace straightedge::gui

QTEST_MAIN(straightedge::gui::PlotPictureTest)
#include "plot_picture_test.moc"
