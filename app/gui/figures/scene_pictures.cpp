#include "app/gui/figures/scene_pictures.h"

#include "app/gui/figures/picture_files.h"

#include <QBuffer>

namespace straightedge::gui {

QByteArray ScenePictures::png(const NamedFigure& figure) {
  if (const auto drawn = m_drawn.constFind(figure.stem); drawn != m_drawn.constEnd()) {
    return *drawn;
  }
  const QImage image = m_artist.picture(figure.scene(), exportedPlotSize, 2.0);
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
