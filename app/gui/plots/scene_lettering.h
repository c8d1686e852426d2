// Texts of three-dimensional pictures that keep clear of one another. Private to plots.
#pragma once

#include <QColor>
#include <QList>
#include <QPointF>
#include <QRectF>
#include <QString>

class QFont;
class QPainter;

namespace straightedge::gui {

/// Remembers where it has written.
class SceneLettering {
public:
  /// `halo`: colour of the background, drawn about texts beside points so that they can be read over anything.
  SceneLettering(QPainter& painter, const QRectF& area, const QColor& halo)
      : m_painter(painter), m_area(area), m_halo(halo) {}

  /// Not over a text that is there already: false, and nothing is written.
  bool writeIfFree(const QRectF& place, const QString& text);

  /// Lines beside a point, away from another one and within the area; moved down or up where there is text already.
  void writeBeside(const QPointF& point, const QPointF& awayFrom, const QStringList& lines, const QFont& font,
                   const QColor& first, const QColor& others);

  const QList<QRectF>& taken() const { return m_taken; } ///< so far

private:
  bool isFree(const QRectF& place) const;

  QPainter& m_painter;
  QRectF m_area;
  QColor m_halo;
  QList<QRectF> m_taken;
};

} // namespace straightedge::gui
