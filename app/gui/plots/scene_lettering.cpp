#include "app/gui/plots/scene_lettering.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace straightedge::gui {

bool SceneLettering::isFree(const QRectF& place) const {
  return std::ranges::none_of(m_taken,
                              [&place](const QRectF& other) { return place.adjusted(-4, -1, 4, 1).intersects(other); });
}

bool SceneLettering::writeIfFree(const QRectF& place, const QString& text) {
  if (!isFree(place)) {
    return false;
  }
  m_taken << place;
  m_painter.drawText(place, Qt::AlignCenter | Qt::TextDontClip, text);
  return true;
}

void SceneLettering::writeBeside(const QPointF& point, const QPointF& awayFrom, const QStringList& lines,
                                 const QFont& font, const QColor& first, const QColor& others) {
  const QFontMetricsF metrics(font);
  double width = 0.0;
  for (const QString& line : lines) {
    width = std::max(width, metrics.horizontalAdvance(line) + 2.0);
  }
  const QSizeF size(width, metrics.height() * static_cast<double>(lines.size()));
  QPointF away = point - awayFrom;
  const double distance = std::hypot(away.x(), away.y());
  away = distance > 1.0 ? away / distance : QPointF(0.0, -1.0);
  constexpr double gap = 8.0;
  const QPointF middle = point + away * gap + QPointF(0.5 * size.width() * away.x(), 0.5 * size.height() * away.y());
  QRectF place(middle - QPointF(0.5 * size.width(), 0.5 * size.height()), size);
  const auto inside = [this](QRectF box) {
    box.moveLeft(std::clamp(box.left(), m_area.left(), std::max(m_area.left(), m_area.right() - box.width())));
    box.moveTop(std::clamp(box.top(), m_area.top(), std::max(m_area.top(), m_area.bottom() - box.height())));
    return box;
  };
  place = inside(place);
  const QRectF wished = place;
  for (int step = 1; !isFree(place) && step < 40; ++step) { // nearest free place above or below
    const int steps = (step + 1) / 2;                       // 1 below, 1 above, 2 below, …
    const double shift = 4.0 * steps * (step % 2 == 1 ? 1.0 : -1.0);
    place = inside(wished.translated(0.0, shift));
  }
  m_taken << place;
  m_painter.setFont(font);
  const int side = away.x() > 0.3 ? Qt::AlignLeft : away.x() < -0.3 ? Qt::AlignRight : Qt::AlignHCenter;
  for (qsizetype i = 0; i < lines.size(); ++i) {
    const QRectF line(place.left(), place.top() + static_cast<double>(i) * metrics.height(), place.width(),
                      metrics.height());
    const int flags = side | Qt::AlignVCenter | Qt::TextDontClip;
    m_painter.setPen(m_halo);
    for (const QPointF& aside : {QPointF(-1, 0), QPointF(1, 0), QPointF(0, -1), QPointF(0, 1)}) {
      m_painter.drawText(line.translated(aside), flags, lines[i]);
    }
    m_painter.setPen(i == 0 ? first : others);
    m_painter.drawText(line, flags, lines[i]);
  }
}

} // namespace straightedge::gui
