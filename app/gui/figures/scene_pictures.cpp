#include "app/gui/figures/scene_pictures.h"

#include "app/gui/figures/picture_files.h"

#include <QBuffer>

namespace straightedge::gui {

namespace {

/// As many pixels as an exported plot has, but larger letters: on paper the picture is narrower than on a screen.
constexpr QSize scenePictureSize{640, 360};
constexpr double scenePictureScale = 3.0;
static_assert(scenePictureSize.width() * 3 == exportedPlotSize.width() * 2);

} // namespace

QByteArray ScenePictures::png(const NamedFigure& figure) {
  if (const auto drawn = m_drawn.constFind(figure.stem); drawn != m_drawn.constEnd()) {
    return *drawn;
  }
  const QImage image = m_artist.picture(figure.scene(), scenePictureSize, scenePictureScale);
  QByteArray bytes;
  if (!image.isNull()) {
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
  }
  m_drawn.insert(figure.stem, bytes);
  return bytes;
}

} // namespace straightedge::gui
