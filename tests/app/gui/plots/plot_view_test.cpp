// PlotView as a user meets it: what is on the screen, under the pointer, after a key.
#include "app/gui/plots/plot_view.h"
#include "tests/app/gui/plots/figures.h"

#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include <cmath>
#include <limits>
#include <memory>

namespace straightedge::gui {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

PlotSpec lineThrough(const QList<double>& x, const QList<double>& y) {
  PlotSpec spec;
  spec.x.title = QStringLiteral("Sensor angle (°)");
  spec.y.title = QStringLiteral("Error (°)");
  PlotSeries series;
  series.name = QStringLiteral("Line");
  series.x = x;
  series.y = y;
  spec.series << series;
  return spec;
}

void wheel(PlotView& view, const QPointF& at, int notches) {
  QWheelEvent event(at, view.mapToGlobal(at), QPoint(), QPoint(0, 120 * notches), Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&view, &event);
}

void drag(PlotView& view, const QPointF& from, const QPointF& to, Qt::MouseButton button = Qt::LeftButton,
          Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  QTest::mousePress(&view, button, modifiers, from.toPoint());
  for (int step = 1; step <= 5; ++step) {
    QTest::mouseMove(&view, (from + (to - from) * (step / 5.0)).toPoint());
  }
  QTest::mouseRelease(&view, button, modifiers, to.toPoint());
}

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

} // namespace

class PlotViewTest : public QObject {
  Q_OBJECT
private slots:
  void init();
  void cleanup();

  void hoverFindsEveryDensePoint();
  void hoverIsExactDespiteNaN();
  void hoverTellsValuesWithUnits();
  void hoverOnLogarithmicAxesTellsRealValues();
  void hoverOnBars();
  void clickIsNotADrag();
  void wheelZoomsAtThePointer();
  void wheelOverAnAxisZoomsOnlyIt();
  void leftDragPans();
  void rectangleZooms();
  void controlDragSelects();
  void resetsByDoubleClickHomeAndMenu();
  void legendSwitchesByClickAndKey();
  void choicesOutliveNewData();
  void guideIsDragged();
  void keysStepThroughPoints();
  void livePointsExtendTheRange();
  void rightAxisFollowsZoom();
  void menuCopies();
  void namesItselfToScreenReaders();
  void followsThePalette();
  void magnifierShowsALens();

private:
  void show(const PlotSpec& spec);
  void waitForPaint();

  std::unique_ptr<PlotView> m_view;
};

void PlotViewTest::init() {
  m_view = std::make_unique<PlotView>();
  m_view->resize(1200, 600);
}

void PlotViewTest::cleanup() { m_view.reset(); }

void PlotViewTest::waitForPaint() {
  QSignalSpy painted(m_view.get(), &PlotView::painted);
  m_view->update();
  QVERIFY(painted.wait(60000));
}

void PlotViewTest::show(const PlotSpec& spec) {
  QSignalSpy painted(m_view.get(), &PlotView::painted);
  m_view->setSpec(spec);
  m_view->show();
  QVERIFY(!painted.isEmpty() || painted.wait(60000));
  waitForPaint();
}

void PlotViewTest::hoverFindsEveryDensePoint() {
  QList<double> x;
  QList<double> y;
  for (int i = 0; i < 400; ++i) {
    x << i;
    y << std::sin(0.1 * i);
  }
  show(lineThrough(x, y));
  QVERIFY(m_view->toPixels(1, 0).x() - m_view->toPixels(0, 0).x() < 3.0); // denser than the pointer's reach
  QSignalSpy hovered(m_view.get(), &PlotView::pointHovered);
  for (int i = 0; i < 400; ++i) {
    QTest::mouseMove(m_view.get(), QPoint(2, 2));
    QTest::mouseMove(m_view.get(), m_view->toPixels(x[i], y[i]).toPoint());
    QVERIFY(!hovered.isEmpty());
    QCOMPARE(hovered.last().at(0).toInt(), 0);
    // Whole pixels of the test's pointer are coarser than the points: what counts is that no other point is nearer.
    const int found = hovered.last().at(1).toInt();
    const QPointF pointer = m_view->toPixels(x[i], y[i]).toPoint();
    const auto away = [&](int k) { return QLineF(pointer, m_view->toPixels(x[k], y[k])).length(); };
    for (int k = std::max(0, i - 10); k < std::min(400, i + 10); ++k) {
      QVERIFY2(away(found) <= away(k) + 1e-9, qPrintable(QStringLiteral("hover %1 found %2").arg(i).arg(found)));
    }
    QVERIFY(std::abs(found - i) <= 1);
  }
}

void PlotViewTest::hoverIsExactDespiteNaN() {
  QList<double> x;
  QList<double> y;
  for (int i = 0; i < 200; ++i) {
    x << (i % 7 == 3 ? nan : 5.0 * i);
    y << (i % 11 == 5 ? nan : std::cos(0.2 * i));
  }
  show(lineThrough(x, y));
  QSignalSpy hovered(m_view.get(), &PlotView::pointHovered);
  for (int i = 0; i < 200; ++i) {
    if (std::isnan(x[i]) || std::isnan(y[i])) {
      continue;
    }
    QTest::mouseMove(m_view.get(), QPoint(2, 2));
    QTest::mouseMove(m_view.get(), m_view->toPixels(x[i], y[i]).toPoint());
    QCOMPARE(hovered.last().at(1).toInt(), i);
  }
}

void PlotViewTest::hoverTellsValuesWithUnits() {
  PlotSpec spec = lineThrough({0.0, 90.0, 180.0}, {0.5, -0.25, 0.5});
  spec.series[0].pointLabels = QStringList{{}, QStringLiteral("linear:32"), {}};
  show(spec);
  QTest::mouseMove(m_view.get(), m_view->toPixels(90.0, -0.25).toPoint());
  const QStringList lines = {QStringLiteral("linear:32"), QStringLiteral("Line"), QStringLiteral("Sensor angle: 90°"),
                             QStringLiteral("Error: −0.25°")};
  QCOMPARE(m_view->hoverText(), lines);
  QTest::mouseMove(m_view.get(), QPoint(2, 2));
  QVERIFY(m_view->hoverText().isEmpty());
}

void PlotViewTest::hoverOnLogarithmicAxesTellsRealValues() {
  show(figures::errorVersusStorage());
  const PlotSeries& series = m_view->spec().series[2];
  QTest::mouseMove(m_view.get(), m_view->toPixels(series.x[3], series.y[3]).toPoint());
  QVERIFY(m_view->hoverText().contains(QStringLiteral("Storage: 5 entries")));
  QSignalSpy clicked(m_view.get(), &PlotView::pointClicked);
  QTest::mouseClick(m_view.get(), Qt::LeftButton, Qt::NoModifier, m_view->toPixels(series.x[3], series.y[3]).toPoint());
  QCOMPARE(clicked.size(), 1);
  QCOMPARE(clicked[0].at(0).toInt(), 2);
  QCOMPARE(clicked[0].at(1).toInt(), 3);
  QVERIFY(near(m_view->toData(m_view->toPixels(64.0, 0.05)).x(), 64.0, 1e-9));
}

void PlotViewTest::hoverOnBars() {
  show(figures::harmonics());
  const PlotSeries& bars = m_view->spec().series[0];
  QSignalSpy hovered(m_view.get(), &PlotView::pointHovered);
  QTest::mouseMove(m_view.get(), m_view->toPixels(5.0, 0.4 * bars.y[4]).toPoint());
  QCOMPARE(hovered.last().at(1).toInt(), 4);
  QVERIFY(m_view->hoverText().first().startsWith(QStringLiteral("Harmonic: 5")));
}

void PlotViewTest::clickIsNotADrag() {
  show(lineThrough({0.0, 1.0, 2.0}, {0.0, 1.0, 0.0}));
  QSignalSpy clicked(m_view.get(), &PlotView::pointClicked);
  const QPointF point = m_view->toPixels(1.0, 1.0);
  drag(*m_view, point - QPointF(30.0, 0.0), point);
  QVERIFY(clicked.isEmpty());
  m_view->resetZoom();
  drag(*m_view, point, point + QPointF(30.0, 0.0));
  QVERIFY(clicked.isEmpty());
  m_view->resetZoom();
  QTest::mouseClick(m_view.get(), Qt::LeftButton, Qt::NoModifier, (point + QPointF(2.0, 1.0)).toPoint());
  QCOMPARE(clicked.size(), 1);
  QCOMPARE(clicked[0].at(1).toInt(), 1);
  QTest::mouseClick(m_view.get(), Qt::LeftButton, Qt::NoModifier, m_view->toPixels(1.0, 0.0).toPoint());
  QCOMPARE(clicked.size(), 1); // nothing near
}

void PlotViewTest::wheelZoomsAtThePointer() {
  for (const bool logarithmic : {false, true}) {
    PlotSpec spec = lineThrough({1.0, 40.0, 140.0}, {0.1, 2.0, 1.0});
    spec.x.title += logarithmic ? QStringLiteral(" log") : QString();
    spec.x.logarithmic = spec.y.logarithmic = logarithmic;
    show(spec);
    const QPointF pointer = m_view->plotArea().topLeft() + QPointF(200.0, 120.0);
    const QPointF before = m_view->toData(pointer);
    const double width = m_view->visibleRange().width();
    QSignalSpy changed(m_view.get(), &PlotView::visibleRangeChanged);
    wheel(*m_view, pointer, 3);
    const QPointF after = m_view->toData(pointer);
    QCOMPARE(changed.size(), 1);
    QVERIFY(m_view->visibleRange().width() < 0.7 * width);
    // The layout may move by some pixels with the labels; the place on the axes is what is kept.
    QVERIFY(near(after.x(), before.x(), 0.02 * std::abs(before.x())));
    QVERIFY(near(after.y(), before.y(), 0.02 * std::abs(before.y())));
    wheel(*m_view, pointer, -3);
    QVERIFY(near(m_view->visibleRange().width(), width, 0.02 * width));
  }
}

void PlotViewTest::wheelOverAnAxisZoomsOnlyIt() {
  show(lineThrough({0.0, 1.0, 2.0}, {0.0, 1.0, 0.0}));
  const QRectF before = m_view->visibleRange();
  wheel(*m_view, {m_view->plotArea().center().x(), m_view->plotArea().bottom() + 12.0}, 2);
  QVERIFY(m_view->visibleRange().width() < 0.8 * before.width());
  QCOMPARE(m_view->visibleRange().height(), before.height());
  m_view->resetZoom();
  wheel(*m_view, {m_view->plotArea().left() - 12.0, m_view->plotArea().center().y()}, 2);
  QCOMPARE(m_view->visibleRange().width(), before.width());
  QVERIFY(m_view->visibleRange().height() < 0.8 * before.height());
}

void PlotViewTest::leftDragPans() {
  show(lineThrough({0.0, 1.0, 2.0}, {0.0, 1.0, 0.0}));
  const QRectF before = m_view->visibleRange();
  const QPointF from = m_view->plotArea().center() + QPointF(0.0, 60.0);
  const double perPixel = before.width() / m_view->plotArea().width();
  drag(*m_view, from, from + QPointF(100.0, 0.0));
  QVERIFY(near(m_view->visibleRange().left(), before.left() - 100.0 * perPixel, 2.0 * perPixel));
  QVERIFY(near(m_view->visibleRange().width(), before.width(), 1e-9));
}

void PlotViewTest::rectangleZooms() {
  for (const auto& [button, modifier] :
       {std::pair(Qt::LeftButton, Qt::ShiftModifier), std::pair(Qt::RightButton, Qt::NoModifier)}) {
    show(lineThrough({0.0, 50.0, 100.0}, {0.0, 100.0, 0.0}));
    m_view->resetZoom();
    const QPointF a = m_view->toPixels(20.0, 80.0);
    const QPointF b = m_view->toPixels(60.0, 30.0);
    drag(*m_view, a, b, button, modifier);
    const QRectF range = m_view->visibleRange();
    QVERIFY(near(range.left(), 20.0, 0.3));
    QVERIFY(near(range.right(), 60.0, 0.3));
    QVERIFY(near(range.top(), 30.0, 0.5));
    QVERIFY(near(range.bottom(), 80.0, 0.5));
    QVERIFY(m_view->findChild<QMenu*>() == nullptr); // the drag was no click
  }
}

void PlotViewTest::controlDragSelects() {
  QList<double> x;
  QList<double> y;
  for (int i = 0; i < 100; ++i) {
    x << i;
    y << 0.5;
  }
  show(lineThrough(x, y));
  QSignalSpy selected(m_view.get(), &PlotView::pointsSelected);
  drag(*m_view, m_view->toPixels(19.5, 0.52), m_view->toPixels(40.5, 0.48), Qt::LeftButton, Qt::ControlModifier);
  QCOMPARE(selected.size(), 1);
  const auto indices = selected[0].at(1).value<QList<int>>();
  QCOMPARE(indices.size(), 21);
  QCOMPARE(indices.first(), 20);
  QCOMPARE(indices.last(), 40);
  QCOMPARE(m_view->visibleRange().left(), -0.05 * 99.0); // it selects, it does not zoom
}

void PlotViewTest::resetsByDoubleClickHomeAndMenu() {
  show(lineThrough({0.0, 1.0, 2.0}, {0.0, 1.0, 0.0}));
  const QRectF whole = m_view->visibleRange();
  const auto zoomed = [&] {
    m_view->setVisibleRange({0.5, 0.2, 1.0, 0.5});
    return m_view->visibleRange() == QRectF(0.5, 0.2, 1.0, 0.5);
  };
  QVERIFY(zoomed());
  QTest::mouseDClick(m_view.get(), Qt::LeftButton, Qt::NoModifier, m_view->plotArea().center().toPoint());
  QCOMPARE(m_view->visibleRange(), whole);
  QVERIFY(zoomed());
  QTest::keyClick(m_view.get(), Qt::Key_Home);
  QCOMPARE(m_view->visibleRange(), whole);
  QVERIFY(zoomed());
  const std::unique_ptr<QMenu> menu(m_view->makeContextMenu(nullptr));
  menu->findChild<QAction*>(QStringLiteral("resetZoom"))->trigger();
  QCOMPARE(m_view->visibleRange(), whole);
  QTest::keyClick(m_view.get(), Qt::Key_Plus);
  QVERIFY(m_view->visibleRange().width() < whole.width());
  QTest::keyClick(m_view.get(), Qt::Key_Minus);
  QVERIFY(near(m_view->visibleRange().width(), whole.width(), 1e-9));
}

void PlotViewTest::legendSwitchesByClickAndKey() {
  show(figures::errorVersusStorage());
  QSignalSpy toggled(m_view.get(), &PlotView::seriesToggled);
  QTest::mouseClick(m_view.get(), Qt::LeftButton, Qt::NoModifier, m_view->legendEntryRect(1).center().toPoint());
  QCOMPARE(toggled.size(), 1);
  QCOMPARE(toggled[0].at(0).toInt(), 1);
  QCOMPARE(toggled[0].at(1).toBool(), false);
  QVERIFY(!m_view->spec().series[1].visible);
  QVERIFY(!m_view->legendEntryRect(1).isEmpty()); // still there, to switch it on again
  QTest::keyClick(m_view.get(), Qt::Key_2);
  QVERIFY(m_view->spec().series[1].visible);
  QTest::keyClick(m_view.get(), Qt::Key_9); // there are only five
  QCOMPARE(toggled.size(), 2);
}

void PlotViewTest::choicesOutliveNewData() {
  PlotSpec spec = figures::secondAxis();
  show(spec);
  m_view->setSeriesVisible(0, false);
  m_view->setVisibleRange({100.0, 2.0, 300.0, 5.0});
  spec.series[0].y[3] = 7.0;
  m_view->setSpec(spec);
  QVERIFY(!m_view->spec().series[0].visible);
  QCOMPARE(m_view->visibleRange(), QRectF(100.0, 2.0, 300.0, 5.0));
  spec.y.title = QStringLiteral("Something else (T)");
  m_view->setSpec(spec);
  QVERIFY(m_view->spec().series[0].visible);
  QVERIFY(m_view->visibleRange() != QRectF(100.0, 2.0, 300.0, 5.0));
}

void PlotViewTest::guideIsDragged() {
  show(figures::errorVersusStorage());
  QSignalSpy dragged(m_view.get(), &PlotView::guideDragged);
  QSignalSpy dropped(m_view.get(), &PlotView::guideDropped);
  // Whoever listens may bring a new spec with a value that lags behind: the drag goes on.
  connect(m_view.get(), &PlotView::guideDragged, m_view.get(),
          [this] { m_view->setSpec(figures::errorVersusStorage()); });
  const QRectF before = m_view->visibleRange();
  const QPointF from = m_view->toPixels(300.0, 0.05);
  const QPointF to = m_view->toPixels(300.0, 0.5);
  drag(*m_view, from, to);
  QVERIFY(dragged.size() >= 3);
  QCOMPARE(dropped.size(), 1);
  QCOMPARE(dropped[0].at(0).toString(), QStringLiteral("target"));
  QVERIFY(near(std::log10(dropped[0].at(1).toDouble()), std::log10(0.5), 0.02));
  QCOMPARE(m_view->spec().guides[0].value, dropped[0].at(1).toDouble());
  QCOMPARE(m_view->visibleRange(), before); // no pan
  m_view->setGuideValue(QStringLiteral("target"), 0.07);
  QCOMPARE(m_view->spec().guides[0].value, 0.07);
}

void PlotViewTest::keysStepThroughPoints() {
  PlotSpec spec = lineThrough({0.0, 1.0, 2.0, 3.0}, {0.0, nan, 1.0, 0.0});
  spec.series << spec.series[0];
  spec.series[1].name = QStringLiteral("Other");
  spec.series[1].y = {2.0, 2.0, 2.0, 2.0};
  show(spec);
  QSignalSpy hovered(m_view.get(), &PlotView::pointHovered);
  QSignalSpy clicked(m_view.get(), &PlotView::pointClicked);
  QTest::keyClick(m_view.get(), Qt::Key_Right);
  QCOMPARE(hovered.last().at(1).toInt(), 0);
  QTest::keyClick(m_view.get(), Qt::Key_Right);
  QCOMPARE(hovered.last().at(1).toInt(), 2); // over the gap
  QVERIFY(m_view->hoverText().contains(QStringLiteral("Error: 1°")));
  QTest::keyClick(m_view.get(), Qt::Key_Down);
  QCOMPARE(hovered.last().at(0).toInt(), 1);
  QCOMPARE(hovered.last().at(1).toInt(), 2);
  QTest::keyClick(m_view.get(), Qt::Key_Return);
  QCOMPARE(clicked.size(), 1);
  QTest::keyClick(m_view.get(), Qt::Key_Escape);
  QVERIFY(m_view->hoverText().isEmpty());
}

void PlotViewTest::livePointsExtendTheRange() {
  show(lineThrough({0.0, 1.0}, {0.0, 1.0}));
  m_view->appendPoints(0, {2.0, 3.0}, {4.0, 5.0});
  QCOMPARE(m_view->spec().series[0].x.size(), 4);
  QVERIFY(near(m_view->visibleRange().right(), 3.15, 1e-9));
  m_view->appendPoints(7, {1.0}, {1.0}); // no such series
  m_view->appendPoints(0, {1.0}, {});    // lengths differ
  QCOMPARE(m_view->spec().series[0].x.size(), 4);
  QSignalSpy painted(m_view.get(), &PlotView::painted);
  for (int i = 0; i < 50; ++i) {
    m_view->appendPoints(0, {4.0 + i}, {1.0});
  }
  QVERIFY(painted.wait(60000));
  QCOMPARE(painted.size(), 1); // one repaint for all of them
}

void PlotViewTest::rightAxisFollowsZoom() {
  show(figures::secondAxis());
  const QPointF pointer = m_view->plotArea().center();
  QTest::mouseMove(m_view.get(), pointer.toPoint());
  wheel(*m_view, pointer, 2);
  waitForPaint();
  const PlotSeries& temperature = m_view->spec().series[1];
  QSignalSpy hovered(m_view.get(), &PlotView::pointHovered);
  QTest::keyClick(m_view.get(), Qt::Key_Right);
  QTest::keyClick(m_view.get(), Qt::Key_Down);
  QCOMPARE(hovered.last().at(0).toInt(), 1);
  const int index = hovered.last().at(1).toInt();
  QVERIFY(
      m_view->hoverText().last().startsWith(QStringLiteral("Temperature: %1").arg(std::floor(temperature.y[index]))));
  QVERIFY(m_view->hoverText().last().endsWith(QStringLiteral("°C")));
}

void PlotViewTest::menuCopies() {
  show(lineThrough({0.5, 1.5}, {2.5, nan}));
  const std::unique_ptr<QMenu> menu(m_view->makeContextMenu(nullptr));
  menu->findChild<QAction*>(QStringLiteral("copyData"))->trigger();
  const QMimeData* data = QApplication::clipboard()->mimeData();
  QCOMPARE(data->text(), QStringLiteral("Sensor angle (°)\tLine\n0.5\t2.5\n1.5\t\n"));
  QCOMPARE(QString::fromUtf8(data->data(QStringLiteral("text/csv"))),
           QStringLiteral("Sensor angle (°),Line\n0.5,2.5\n1.5,\n"));
  menu->findChild<QAction*>(QStringLiteral("copyPicture"))->trigger();
  QCOMPARE(QApplication::clipboard()->image().size(), m_view->size() * 2);
  // A right click opens it.
  QTest::mouseClick(m_view.get(), Qt::RightButton, Qt::NoModifier, m_view->plotArea().center().toPoint());
  auto* opened = m_view->findChild<QMenu*>();
  QVERIFY(opened != nullptr);
  opened->close();
}

void PlotViewTest::namesItselfToScreenReaders() {
  show(lineThrough({0.0, 1.0}, {0.0, 1.0}));
  QCOMPARE(m_view->accessibleName(), QStringLiteral("Plot of Error over Sensor angle"));
  QVERIFY(m_view->accessibleDescription().contains(QStringLiteral("Line")));
}

void PlotViewTest::followsThePalette() {
  show(lineThrough({0.0, 1.0}, {0.0, 1.0}));
  QCOMPARE(m_view->theme(), PlotTheme::Light);
  QPalette dark;
  dark.setColor(QPalette::Window, QColor(30, 30, 30));
  m_view->setPalette(dark);
  QCOMPARE(m_view->theme(), PlotTheme::Dark);
  QVERIFY(m_view->grab().toImage().pixelColor(3, 3).lightness() < 80);
  m_view->setTheme(PlotTheme::Light);
  QVERIFY(m_view->grab().toImage().pixelColor(3, 3).lightness() > 200);
}

void PlotViewTest::magnifierShowsALens() {
  show(lineThrough({0.0, 1.0, 2.0}, {0.0, 1.0, 0.0}));
  const QPointF pointer = m_view->plotArea().center();
  QTest::mouseMove(m_view.get(), pointer.toPoint());
  const QImage plain = m_view->grab().toImage();
  m_view->setMagnifier(true);
  QVERIFY(m_view->grab().toImage() != plain);
  QTest::mouseMove(m_view.get(), QPoint(2, 2));
  m_view->setMagnifier(false);
  QCOMPARE(m_view->grab().toImage(), plain);
}

} // namespace straightedge::gui

QTEST_MAIN(straightedge::gui::PlotViewTest)
#include "plot_view_test.moc"
