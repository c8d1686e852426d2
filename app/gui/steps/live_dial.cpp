#include "app/gui/steps/live_dial.h"

#include "app/gui/steps/step_colors.h"

#include <QPainter>

#include <algorithm>
#include <numbers>

namespace straightedge::gui {

namespace {

QPointF onCircle(QPointF center, double radius, double deg) {
  const double angle = deg * std::numbers::pi / 180.0;
  return center + radius * QPointF(std::sin(angle), -std::cos(angle));
}

void drawNeedle(QPainter& painter, QPointF center, double radius, double deg, const QColor& color, double width) {
  painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(onCircle(center, -0.12 * radius, deg), onCircle(center, radius, deg));
}

} // namespace

LiveDial::LiveDial(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  setAccessibleName(tr("Dial of encoder and sensor angle"));
}

void LiveDial::setReading(double encoderDeg, double sensorDeg) {
  m_reading = Reading{encoderDeg, sensorDeg};
  update();
}

void LiveDial::clearReading() {
  m_reading.reset();
  update();
}

QSize LiveDial::sizeHint() const { return {200, 200}; }

QSize LiveDial::minimumSizeHint() const { return {150, 150}; }

void LiveDial::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF center = QRectF(rect()).center();
  const double outer = std::min(width(), height()) / 2.0 - 2.0;
  const double labels = fontMetrics().height();
  const double scale = outer;
  const QColor text = palette().color(QPalette::WindowText);
  const QColor faint = stepColor(*this, StepColor::Faint);

  painter.setPen(QPen(faint, 1.5));
  painter.setBrush(palette().color(QPalette::Base));
  painter.drawEllipse(center, scale, scale);
  for (int deg = 0; deg < 360; deg += 10) {
    const bool major = deg % 90 == 0;
    painter.setPen(QPen(major ? text : faint, major ? 1.6 : 1.0));
    painter.drawLine(onCircle(center, scale - (major ? 9.0 : 5.0), deg), onCircle(center, scale, deg));
  }
  painter.setPen(stepColor(*this, StepColor::Quiet));
  for (int deg = 0; deg < 360; deg += 90) {
    const QSizeF size(labels * 3.0, labels);
    // Inside the scale; at the sides a label needs its width, above and below its height.
    const QPointF at = onCircle(center, scale - (deg % 180 == 0 ? 1.15 : 1.6) * labels, deg);
    painter.drawText(QRectF(at - QPointF(size.width() / 2, size.height() / 2), size), Qt::AlignCenter,
                     QString::number(deg) + QStringLiteral("°"));
  }
  if (!m_reading) {
    painter.setPen(stepColor(*this, StepColor::Quiet));
    painter.drawText(QRectF(center.x() - scale, center.y() - labels / 2, 2 * scale, labels), Qt::AlignCenter,
                     tr("no reading"));
    return;
  }
  drawNeedle(painter, center, scale * 0.86, m_reading->encoderDeg, stepColor(*this, StepColor::Reference), 5.0);
  drawNeedle(painter, center, scale * 0.78, m_reading->sensorDeg, stepColor(*this, StepColor::Sensor), 2.5);
  painter.setPen(Qt::NoPen);
  painter.setBrush(text);
  painter.drawEllipse(center, 4.0, 4.0);
}

} // namespace straightedge::gui
