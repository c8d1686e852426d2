// The three-dimensional view: rendered without a screen, turned by hand.
#include "app/gui/plots/surface_scene.h"
#include "app/gui/plots/surface_view.h"

#include <QDir>
#include <QSet>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>

#include <cmath>
#include <limits>

namespace straightedge::gui {
namespace {

SurfaceSpec residualField() {
  SurfaceSpec spec;
  spec.title = QStringLiteral("Residual after correction");
  spec.xTitle = QStringLiteral("Field (T)");
  spec.yTitle = QStringLiteral("Temperature θ (°C)");
  spec.zTitle = QStringLiteral("Residual (µT)");
  for (int i = 0; i < 41; ++i) {
    spec.x << -2.0 + 0.1 * i;
  }
  for (int j = 0; j < 31; ++j) {
    spec.y << 10.0 + j;
  }
  for (const double y : spec.y) {
    for (const double x : spec.x) {
      spec.z << 40.0 * std::sin(2.0 * x) * std::cos(0.2 * (y - 25.0)) + 3.0 * x * x;
    }
  }
  spec.z[15 * 41 + 20] = std::numeric_limits<double>::quiet_NaN();
  return spec;
}

int coloursIn(const QImage& image) {
  QSet<QRgb> colours;
  for (int y = 0; y < image.height(); y += 2) {
    for (int x = 0; x < image.width(); x += 2) {
      colours.insert(image.pixel(x, y));
    }
  }
  return static_cast<int>(colours.size());
}

} // namespace

class SurfaceViewTest : public QObject {
  Q_OBJECT
private slots:
  void startsWhenShown();
  void dragTurnsAndWheelZooms();
  void savesPng();
  void emptySpecIsNoTrouble();
  void gallery();
};

void SurfaceViewTest::startsWhenShown() {
  SurfaceView view;
  view.resize(640, 480);
  view.setSpec(residualField());
  QVERIFY(!view.isStarted());
  QSignalSpy painted(&view, &SurfaceView::painted);
  view.show();
  QVERIFY(!painted.isEmpty() || painted.wait(60000));
  QVERIFY2(view.isStarted(), "no EGL here: libgl1-mesa-dri is among the dependencies");
  const QImage shown = view.grab().toImage();
  QVERIFY2(coloursIn(shown) > 1000, qPrintable(QString::number(coloursIn(shown))));
  QCOMPARE(view.picture({300, 200}, 2.0).size(), QSize(600, 400));
}

void SurfaceViewTest::dragTurnsAndWheelZooms() {
  SurfaceView view;
  view.resize(400, 300);
  view.setSpec(residualField());
  const QImage before = view.grab().toImage();
  const double azimuth = view.azimuth();
  const double elevation = view.elevation();
  QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, {200, 150});
  QTest::mouseMove(&view, {250, 160});
  QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, {250, 160});
  QVERIFY(std::abs(view.azimuth() - (azimuth - 20.0)) < 1e-9);
  QVERIFY(std::abs(view.elevation() - (elevation + 4.0)) < 1e-9);
  QVERIFY(view.grab().toImage() != before);
  QWheelEvent wheel({200, 150}, view.mapToGlobal(QPointF(200, 150)), {}, {0, 240}, Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&view, &wheel);
  QVERIFY(view.zoom() > 1.2);
  QTest::mouseDClick(&view, Qt::LeftButton, Qt::NoModifier, {200, 150});
  QCOMPARE(view.azimuth(), azimuth);
  QCOMPARE(view.zoom(), 1.0);
  QCOMPARE(view.grab().toImage(), before);
}

void SurfaceViewTest::savesPng() {
  const QTemporaryDir folder;
  SurfaceView view;
  view.resize(320, 240);
  view.setSpec(residualField());
  QString problem;
  QVERIFY(view.saveAs(folder.filePath("surface.png"), &problem));
  QCOMPARE(QImage(folder.filePath("surface.png")).size(), QSize(640, 480));
  QVERIFY(!view.saveAs(folder.filePath("surface.svg"), &problem));
  QVERIFY(problem.contains(QStringLiteral("surface.svg")));
}

void SurfaceViewTest::emptySpecIsNoTrouble() {
  SurfaceView view;
  view.resize(320, 240);
  QVERIFY(!view.grab().isNull());
  SurfaceSpec wrong = residualField();
  wrong.z.removeLast();
  view.setSpec(wrong);
  QVERIFY(!view.grab().isNull());
}

void SurfaceViewTest::gallery() {
  QDir folder(QStringLiteral(STRAIGHTEDGE_BINARY_DIR "/../gallery"));
  QVERIFY(folder.mkpath(QStringLiteral(".")));
  SurfaceView view;
  view.setSpec(residualField());
  for (const PlotTheme theme : {PlotTheme::Light, PlotTheme::Dark}) {
    view.setTheme(theme);
    for (const double scale : {1.0, 2.0}) {
      const QString name =
          QStringLiteral("surface-800-%1x-%2.png").arg(scale).arg(theme == PlotTheme::Dark ? "dark" : "light");
      QVERIFY(view.picture({800, 600}, scale).save(folder.filePath(name)));
    }
  }
}

} // namespace straightedge::gui

QTEST_MAIN(straightedge::gui::SurfaceViewTest)
#include "surface_view_test.moc"
