// Paints typical figures in every theme, size and resolution into PNG files beside the program, to be looked at.
#include "app/gui/plots/plot_view.h"
#include "tests/app/gui/plots/figures.h"

#include <QDir>
#include <QImage>
#include <QPainter>
#include <QTest>

#include <array>

namespace straightedge::gui {

class PlotGallery : public QObject {
  Q_OBJECT
private slots:
  void paints_data();
  void paints();
};

void PlotGallery::paints_data() {
  QTest::addColumn<int>("figure");
  const QStringList names = {"errorOverAngle", "errorVersusStorage", "harmonics", "residualSteps",
                             "coverageRing",   "secondAxis",         "tinyRange"};
  for (int i = 0; i < names.size(); ++i) {
    QTest::newRow(qPrintable(names[i])) << i;
  }
}

void PlotGallery::paints() {
  QFETCH(int, figure);
  const std::array makers = {figures::errorOverAngle, figures::errorVersusStorage, figures::harmonics,
                             figures::residualSteps,  figures::coverageRing,       figures::secondAxis,
                             figures::tinyRange};
  const PlotSpec spec = makers.at(static_cast<std::size_t>(figure))();
  QDir folder(QStringLiteral(STRAIGHTEDGE_BINARY_DIR "/../gallery"));
  QVERIFY(folder.mkpath(QStringLiteral(".")));
  for (const QSize size : {QSize(300, 200), QSize(800, 500), QSize(1600, 1000)}) {
    for (const double scale : {1.0, 2.0}) {
      for (const PlotTheme theme : {PlotTheme::Light, PlotTheme::Dark}) {
        QImage image(size * scale, QImage::Format_RGB32);
        image.setDevicePixelRatio(scale);
        QPainter painter(&image);
        paintPlot(painter, QRectF(QPointF(0, 0), size), spec, theme);
        painter.end();
        const QString name = QStringLiteral("%1-%2-%3x-%4.png")
                                 .arg(QTest::currentDataTag())
                                 .arg(size.width())
                                 .arg(scale)
                                 .arg(theme == PlotTheme::Dark ? "dark" : "light");
        QVERIFY(image.save(folder.filePath(name)));
      }
    }
  }
}

} // namespace straightedge::gui

QTEST_MAIN(straightedge::gui::PlotGallery)
#include "plot_gallery.moc"
