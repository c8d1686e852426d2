// Three-dimensional pictures: rendered without a screen, in a thread, by a module that is loaded late; turned by hand.
#include "app/gui/plots/plot_view.h"
#include "app/gui/plots/scene_colors.h"
#include "app/gui/plots/scene_drawing.h"
#include "app/gui/plots/scene_lettering.h"
#include "app/gui/plots/scene_module.h"
#include "app/gui/plots/scene_painting.h"
#include "app/gui/plots/scene_view.h"
#include "app/gui/plots/theme.h"

#include <QDir>
#include <QFile>
#include <QPainter>
#include <QSet>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>

#include <cmath>
#include <limits>

namespace straightedge::gui {
namespace {

SurfaceSpec residualField(SurfaceColors colors = SurfaceColors::Sequential) {
  SurfaceSpec spec;
  spec.title = QStringLiteral("Residual after correction");
  spec.xTitle = QStringLiteral("Field (T)");
  spec.yTitle = QStringLiteral("Temperature θ (°C)");
  spec.zTitle = QStringLiteral("Residual (µT)");
  spec.colors = colors;
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

DirectionsSpec tiltedAxes() {
  DirectionsSpec spec;
  spec.title = QStringLiteral("Directions of the probe's axes against the package");
  spec.note = QStringLiteral("Tilts are drawn 20 times as large; between the axes: x and y 90.17°, x and z 90.06°, "
                             "y and z 90.11°");
  spec.exaggeration = 20.0;
  spec.directions = {{"x, tilted by 0.86°", "package x", SeriesColor::First, {1, 0, 0}, {1.0, 0.012, -0.009}},
                     {"y, tilted by 1.07°", "package y", SeriesColor::Second, {0, 1, 0}, {-0.015, 1.0, 0.011}},
                     {"z, tilted by 0.87°", "package z", SeriesColor::Third, {0, 0, 1}, {0.008, -0.013, 1.0}}};
  return spec;
}

SphereSpec fourOfSix() {
  SphereSpec spec;
  spec.title = QStringLiteral("Orientations covered");
  spec.note = QStringLiteral("4 of 6 directions were measured");
  const char* const names[] = {"+x", "−x", "+y", "−y", "+z", "−z"};
  for (std::size_t i = 0; i < 6; ++i) {
    SphereMark mark;
    mark.name = QString::fromUtf8(names[i]);
    mark.covered = i != 3 && i != 4;
    mark.detail = mark.covered ? QStringLiteral("90 rows, 0.5 to 1.5 T") : QStringLiteral("not measured");
    mark.direction = {0, 0, 0};
    mark.direction.at(i / 2) = i % 2 == 0 ? 1.0 : -1.0;
    spec.marks << mark;
  }
  return spec;
}

QImage shot(SceneView& view) {
  QSignalSpy shown(&view, &SceneView::pictureShown);
  view.update();
  return shown.wait(60000) ? view.grab().toImage() : QImage();
}

QImage requested(SceneView& view, QSize size, double scale) {
  QImage picture;
  bool done = false;
  view.requestPicture(size, scale, [&](const QImage& image) {
    picture = image;
    done = true;
  });
  return QTest::qWaitFor([&done] { return done; }, 60000) ? picture : QImage();
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

/// Pixels about as red as a warm, as blue as a cold height.
std::pair<int, int> redAndBlue(const QImage& image) {
  int red = 0;
  int blue = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor color = image.pixelColor(x, y);
      red += color.red() > color.blue() + 60 ? 1 : 0;
      blue += color.blue() > color.red() + 60 ? 1 : 0;
    }
  }
  return {red, blue};
}

/// Names of the shared libraries in this process.
QByteArray loadedLibraries() {
  QFile maps(QStringLiteral("/proc/self/maps"));
  return maps.open(QIODevice::ReadOnly) ? maps.readAll() : QByteArray();
}

} // namespace

class SceneViewTest : public QObject {
  Q_OBJECT
private slots:
  void openGlIsLoadedByTheFirstPicture(); // first: it stays loaded
  void missingModuleIsSaid();
  void brokenModuleIsSaid();
  void dragTurnsAndWheelZooms();
  void keysTurn();
  void savesPng();
  void emptySpecIsNoTrouble();
  void projectionIsThatOfTheRenderer();
  void colourScales();
  void valuesBelowZeroAreBlue();
  void holesStayOpen();
  void tiltIsDrawnLarger();
  void marksCoveredAreFilled();
  void letteringKeepsClear();
  void chartsStayAsTheyAre();
  void goesAwayWhileItDraws();
  void gallery();
};

void SceneViewTest::openGlIsLoadedByTheFirstPicture() {
  for (const char* library : {"libvtkRenderingOpenGL2", "libGLEW", "swrast_dri", "libLLVM"}) {
    QVERIFY2(!loadedLibraries().contains(library), library); // Qt itself has libEGL, the way to a driver
  }
  SceneView view;
  view.resize(640, 480);
  view.setSpec(residualField());
  view.show();
  const QImage picture = shot(view);
  QVERIFY2(view.isStarted(), qPrintable(view.problem()));
  QVERIFY(loadedLibraries().contains("libvtkRenderingOpenGL2"));
  QVERIFY2(coloursIn(picture) > 1000, qPrintable(QString::number(coloursIn(picture))));
  QCOMPARE(requested(view, {300, 200}, 2.0).size(), QSize(600, 400));
  QCOMPARE(view.accessibleDescription(), QString("Surface of Residual (µT) over Field (T) and Temperature θ (°C)"));
}

void SceneViewTest::missingModuleIsSaid() {
  const SceneRendererOrProblem made = makeSceneRendererFrom({QStringLiteral("/nowhere/straightedge_gl.so")});
  QVERIFY(!made.renderer);
  QVERIFY(made.problem.contains("straightedge_gl.so") && made.problem.contains("missing"));
  const QStringList files = sceneModuleFiles("/opt/s/bin");
  QCOMPARE(files, QStringList({"/opt/s/bin/straightedge_gl.so", "/opt/s/bin/../lib/straightedge/straightedge_gl.so"}));
}

void SceneViewTest::brokenModuleIsSaid() {
  const QTemporaryDir folder;
  const QString file = folder.filePath("straightedge_gl.so");
  QFile broken(file);
  QVERIFY(broken.open(QIODevice::WriteOnly) && broken.write("not a library") > 0);
  broken.close();
  const SceneRendererOrProblem made = makeSceneRendererFrom({file});
  QVERIFY(!made.renderer);
  QVERIFY2(made.problem.contains("could not be loaded") && made.problem.contains(file), qPrintable(made.problem));
}

void SceneViewTest::dragTurnsAndWheelZooms() {
  SceneView view;
  view.resize(400, 300);
  view.setSpec(residualField());
  view.show();
  const QImage before = shot(view);
  const SceneCamera camera = view.camera();
  QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, {200, 150});
  QTest::mouseMove(&view, {250, 160});
  QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, {250, 160});
  QVERIFY(std::abs(view.camera().azimuth - (camera.azimuth - 20.0)) < 1e-9);
  QVERIFY(std::abs(view.camera().elevation - (camera.elevation + 4.0)) < 1e-9);
  QVERIFY(shot(view) != before);
  QWheelEvent wheel({200, 150}, view.mapToGlobal(QPointF(200, 150)), {}, {0, 240}, Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&view, &wheel);
  QVERIFY(view.camera().zoom > 1.2);
  QTest::mouseDClick(&view, Qt::LeftButton, Qt::NoModifier, {200, 150});
  QVERIFY(view.camera() == camera);
  QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, {200, 150});
  QCOMPARE(shot(view), before);
}

void SceneViewTest::keysTurn() {
  SceneView view;
  const SceneCamera camera = view.camera();
  QTest::keyClick(&view, Qt::Key_Right);
  QTest::keyClick(&view, Qt::Key_Up);
  QTest::keyClick(&view, Qt::Key_Plus);
  QCOMPARE(view.camera().azimuth, camera.azimuth + 5.0);
  QCOMPARE(view.camera().elevation, camera.elevation + 5.0);
  QCOMPARE(view.camera().zoom, 1.2);
  QTest::keyClick(&view, Qt::Key_Home);
  QVERIFY(view.camera() == camera);
}

void SceneViewTest::savesPng() {
  const QTemporaryDir folder;
  SceneView view;
  view.resize(320, 240);
  view.setSpec(residualField());
  QStringList answers;
  const auto answer = [&answers](const QString& problem) { answers << problem; };
  view.saveAs(folder.filePath("surface.png"), answer);
  QTRY_COMPARE(answers, QStringList{QString()});
  QCOMPARE(QImage(folder.filePath("surface.png")).size(), QSize(640, 480));
  view.saveAs(folder.filePath("surface.svg"), answer);
  QVERIFY(answers.last().contains("surface.svg") && answers.last().contains("PNG only"));
  view.saveAs(folder.filePath("no/such/surface.png"), answer);
  QTRY_COMPARE(answers.size(), 3);
  QVERIFY(answers.last().contains("cannot be written"));
}

void SceneViewTest::emptySpecIsNoTrouble() {
  SceneView view;
  view.resize(320, 240);
  view.show();
  QVERIFY(!shot(view).isNull());
  SurfaceSpec wrong = residualField();
  wrong.z.removeLast();
  view.setSpec(wrong);
  QVERIFY(!shot(view).isNull());
  QVERIFY(!view.isStarted()); // nothing that OpenGL would have to be started for
}

void SceneViewTest::projectionIsThatOfTheRenderer() {
  // A small ball aside of the middle appears where the letters would be put.
  auto made = makeSceneRenderer();
  QVERIFY2(made.renderer, qPrintable(made.problem));
  const SceneVector place{0.6, -0.3, 0.5};
  SceneGeometry geometry;
  SceneMesh mesh;
  for (const SceneVector& corner : {place, place + SceneVector{0.02, 0, 0}, place + SceneVector{0, 0, 0.02}}) {
    for (const double c : {corner.x, corner.y, corner.z}) {
      mesh.points.push_back(static_cast<float>(c));
    }
    mesh.colors.insert(mesh.colors.end(), {0, 0, 0});
  }
  mesh.triangles = {0, 1, 2};
  geometry.meshes.push_back(mesh);
  SceneFrame frame;
  frame.width = 500;
  frame.height = 300;
  frame.eye = eyeOf({.azimuth = 35.0, .elevation = 20.0, .zoom = 1.3}, {{0.1, 0.1, 0.1}, 1.1}, QSizeF(500, 300));
  const auto pixels = made.renderer->render(geometry, frame);
  QCOMPARE(pixels.size(), std::size_t(500 * 300 * 4));
  double sumX = 0.0;
  double sumY = 0.0;
  int count = 0;
  for (int row = 0; row < 300; ++row) {
    for (int x = 0; x < 500; ++x) {
      if (pixels[static_cast<std::size_t>((row * 500 + x) * 4)] < 128) {
        sumX += x + 0.5;
        sumY += 300 - row - 0.5;
        ++count;
      }
    }
  }
  QVERIFY(count > 3);
  const SceneProjection projection(frame.eye, QSizeF(500, 300));
  const QPointF expected = (projection.at(place) + projection.at(place + SceneVector{0.02, 0, 0}) +
                            projection.at(place + SceneVector{0, 0, 0.02})) /
                           3.0;
  QVERIFY2(
      std::abs(sumX / count - expected.x()) < 1.0 && std::abs(sumY / count - expected.y()) < 1.0,
      qPrintable(QString("%1 %2 / %3 %4").arg(sumX / count).arg(sumY / count).arg(expected.x()).arg(expected.y())));
}

void SceneViewTest::colourScales() {
  QCOMPARE(scaleColor(SurfaceColors::DivergingFromZero, 0.5), QColor(221, 221, 221));
  QCOMPARE(scaleColor(SurfaceColors::DivergingFromZero, 0.0), QColor(59, 76, 192));
  QCOMPARE(scaleColor(SurfaceColors::DivergingFromZero, 1.0), QColor(180, 4, 38));
  QCOMPARE(scaleColor(SurfaceColors::Sequential, 0.0), QColor(68, 1, 84));
  QCOMPARE(colorShare(SurfaceColors::DivergingFromZero, 0.0, -1.0, 3.0), 0.5); // zero stays grey
  QCOMPARE(colorShare(SurfaceColors::DivergingFromZero, 3.0, -1.0, 3.0), 1.0);
  QCOMPARE(colorShare(SurfaceColors::DivergingFromZero, -1.0, -1.0, 3.0), 0.5 - 0.5 / 3.0);
  QCOMPARE(colorShare(SurfaceColors::Sequential, 2.0, -2.0, 6.0), 0.5);
}

void SceneViewTest::valuesBelowZeroAreBlue() {
  SceneArtist artist;
  SurfaceSpec spec = residualField(SurfaceColors::DivergingFromZero);
  spec.zRange = std::pair(-50.0, 50.0);
  for (double& z : spec.z) {
    z = -45.0;
  }
  const auto [coldRed, coldBlue] = redAndBlue(artist.picture(spec, {400, 300}, 1.0));
  for (double& z : spec.z) {
    z = 45.0;
  }
  const auto [warmRed, warmBlue] = redAndBlue(artist.picture(spec, {400, 300}, 1.0));
  QVERIFY(coldBlue > 5 * coldRed && warmRed > 5 * warmBlue); // the colour bar has both
}

void SceneViewTest::holesStayOpen() {
  SceneArtist artist;
  SurfaceSpec spec = residualField(SurfaceColors::DivergingFromZero);
  for (double& z : spec.z) {
    z = 45.0;
  }
  spec.zRange = std::pair(-50.0, 50.0);
  const int whole = redAndBlue(artist.picture(spec, {400, 300}, 1.0)).first;
  for (qsizetype i = 0; i < spec.z.size() / 2; ++i) {
    spec.z[i] = std::numeric_limits<double>::quiet_NaN();
  }
  QVERIFY(redAndBlue(artist.picture(spec, {400, 300}, 1.0)).first < 0.75 * whole);
}

void SceneViewTest::tiltIsDrawnLarger() {
  DirectionsSpec spec = tiltedAxes();
  const auto farthest = [](const DirectionsSpec& directions) {
    // the x arrow's tip: the corner of its body with the largest x
    const auto geometry = makeDirectionsDrawing(directions)->geometry({}, PlotTheme::Light, 1.0);
    const std::vector<float>& points = geometry.meshes.front().points;
    std::size_t best = 0;
    for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
      best = points[i] > points[best] ? i : best;
    }
    return SceneVector{static_cast<double>(points[best]), static_cast<double>(points[best + 1]),
                       static_cast<double>(points[best + 2])};
  };
  const auto angle = [](const SceneVector& v) { return std::atan2(std::hypot(v.y, v.z), v.x); };
  const double truth = std::atan(std::hypot(0.012, 0.009));
  QVERIFY(std::abs(angle(farthest(spec)) - 20.0 * truth) < 1e-5);
  spec.exaggeration = 1.0;
  const SceneVector tip = farthest(spec);
  QVERIFY(std::abs(angle(tip) - truth) < 1e-5);
  QVERIFY(tip.y > 0.0 && tip.z < 0.0); // towards where it leans
}

void SceneViewTest::marksCoveredAreFilled() {
  const auto trianglesOf = [](const SphereSpec& spec) {
    return makeSphereDrawing(spec)->geometry({}, PlotTheme::Light, 1.0).meshes.front();
  };
  SphereSpec spec = fourOfSix();
  spec.marks = {spec.marks[0]};
  const SceneMesh cap = trianglesOf(spec);
  const auto nearPole = [](const SceneMesh& mesh) {
    bool near = false;
    for (std::size_t i = 0; i + 2 < mesh.points.size(); i += 3) {
      near = near || mesh.points[i] > 0.999F;
    }
    return near;
  };
  QVERIFY(nearPole(cap));
  spec.marks[0].covered = false;
  QVERIFY(!nearPole(trianglesOf(spec))); // a ring
}

void SceneViewTest::letteringKeepsClear() {
  // Six labels beside points that are hard to part: none over another, all within the picture.
  QImage image(400, 300, QImage::Format_RGB32);
  QPainter painter(&image);
  const QRectF area(0, 0, 400, 300);
  SceneLettering lettering(painter, area, Qt::white);
  const QFont font = PlotFonts::standard().label;
  for (const QPointF& point :
       {QPointF(200, 140), QPointF(205, 142), QPointF(200, 140), QPointF(395, 290), QPointF(398, 295), QPointF(3, 2)}) {
    lettering.writeBeside(point, QPointF(190, 150), {QStringLiteral("+x (behind)"), QStringLiteral("12 rows")}, font,
                          Qt::black, Qt::darkGray);
  }
  const QList<QRectF> taken = lettering.taken();
  QCOMPARE(taken.size(), 6);
  for (qsizetype i = 0; i < taken.size(); ++i) {
    QVERIFY(area.contains(taken[i]));
    for (qsizetype j = 0; j < i; ++j) {
      QVERIFY2(!taken[i].intersects(taken[j]), qPrintable(QString("%1 over %2").arg(i).arg(j)));
    }
  }
  QVERIFY(!lettering.writeIfFree(taken[2], QStringLiteral("9")));
}

void SceneViewTest::chartsStayAsTheyAre() {
  // The module brings VTK's OpenGL classes into the process: flat plots must not notice.
  PlotSpec spec;
  spec.title = QStringLiteral("Flat");
  PlotSeries series;
  series.x = {0.0, 1.0, 2.0};
  series.y = {0.0, 1.0, 0.5};
  spec.series << series;
  const auto paint = [&spec] {
    QImage image(300, 200, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    paintPlot(painter, QRectF(0, 0, 300, 200), spec, PlotTheme::Light);
    return image;
  };
  const QImage before = paint();
  SceneArtist artist;
  QVERIFY(!artist.picture(tiltedAxes(), {300, 200}, 1.0).isNull());
  QCOMPARE(paint(), before);
}

void SceneViewTest::goesAwayWhileItDraws() {
  for (int i = 0; i < 3; ++i) {
    SceneView view;
    view.resize(900, 700);
    view.setSpec(residualField());
    view.requestPicture({900, 700}, 2.0, [](const QImage&) { QFAIL("delivered to a view that is gone"); });
  }
  QCoreApplication::processEvents();
}

void SceneViewTest::gallery() {
  QDir folder(QStringLiteral(STRAIGHTEDGE_BINARY_DIR "/../gallery"));
  QVERIFY(folder.mkpath(QStringLiteral(".")));
  SceneView view;
  const QList<std::pair<const char*, SceneSpec>> scenes{{"surface", residualField()},
                                                        {"diverging", residualField(SurfaceColors::DivergingFromZero)},
                                                        {"directions", tiltedAxes()},
                                                        {"sphere", fourOfSix()}};
  for (const auto& [stem, spec] : scenes) {
    view.setSpec(spec);
    for (const PlotTheme theme : {PlotTheme::Light, PlotTheme::Dark}) {
      view.setTheme(theme);
      for (const double scale : {1.0, 2.0}) {
        const QString name =
            QStringLiteral("%1-%2x-%3.png").arg(stem).arg(scale).arg(theme == PlotTheme::Dark ? "dark" : "light");
        QVERIFY(requested(view, {700, 480}, scale).save(folder.filePath(name)));
      }
    }
  }
}

} // namespace straightedge::gui

QTEST_MAIN(straightedge::gui::SceneViewTest)
#include "scene_view_test.moc"
