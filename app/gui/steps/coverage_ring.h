// The turn as a ring that fills while it is measured: outside with the rising, inside with the falling direction.
#pragma once

#include <QWidget>

#include <array>
#include <optional>
#include <vector>

namespace straightedge::gui {

/// Degrees clockwise from the top.
class CoverageRing : public QWidget {
  Q_OBJECT
public:
  explicit CoverageRing(QWidget* parent = nullptr);

  /// Planned angles of one turn; the ring's segments reach half way to the next.
  void setPlan(std::vector<double> turnDeg, bool bothDirections);
  void clear();
  void measure(double encoderDeg, int direction); ///< takes effect with the next update()
  void setCaption(const QString& text, const QString& below);

  int coveredPercent() const; ///< of the planned angles, in all planned directions

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  std::size_t segmentOf(double encoderDeg) const;
  void drawBand(QPainter& painter, const QRectF& square, double width, std::size_t direction) const;

  std::vector<double> m_planned; ///< ascending in [0, 360)
  bool m_bothDirections = false;
  std::array<std::vector<bool>, 2> m_measured;
  std::optional<double> m_shaftDeg;
  QString m_caption, m_below;
};

} // namespace straightedge::gui
