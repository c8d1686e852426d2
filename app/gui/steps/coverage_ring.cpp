#include "app/gui/steps/coverage_ring.h"

#include "app/gui/steps/step_colors.h"
#include "core/angle/angles.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace straightedge::gui {

namespace {

// More segments than this could not be told apart; the ring then shows so many sectors.
constexpr std::size_t mostSegments = 360;

// QPainter counts sixteenths of a degree, anticlockwise from three o'clock.
int painterAngle(double deg) { return static_cast<int>(std::lround((90.0 - deg) * 16.0)); }

} // namespace

CoverageRing::CoverageRing(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAccessibleName(tr("Coverage of the turn"));
}

void CoverageRing::setPlan(std::vector<double> turnDeg, bool bothDirections) {
  if (turnDeg.size() > mostSegments) {
    turnDeg.resize(mostSegments);
    for (std::size_t i = 0; i < mostSegments; ++i) {
      turnDeg[i] = static_cast<double>(i) * 360.0 / static_cast<double>(mostSegments);
    }
  }
  for (double& deg : turnDeg) {
    deg = angle::wrap360(deg);
  }
  std::ranges::sort(turnDeg);
  m_planned = std::move(turnDeg);
  m_bothDirections = bothDirections;
  clear();
}

void CoverageRing::clear() {
  for (auto& measured : m_measured) {
    measured.assign(m_planned.size(), false);
  }
  m_shaftDeg.reset();
  update();
}

std::size_t CoverageRing::segmentOf(double encoderDeg) const {
  const double deg = angle::wrap360(encoderDeg);
  const auto above = static_cast<std::size_t>(std::ranges::lower_bound(m_planned, deg) - m_planned.begin());
  const std::size_t count = m_planned.size();
  const std::size_t upper = above % count;
  const std::size_t lower = (above + count - 1) % count;
  const bool upperIsNearer =
      std::abs(angle::wrap180(m_planned[upper] - deg)) <= std::abs(angle::wrap180(m_planned[lower] - deg));
  return upperIsNearer ? upper : lower;
}

void CoverageRing::measure(double encoderDeg, int direction) {
  m_shaftDeg = angle::wrap360(encoderDeg);
  if (!m_planned.empty()) {
    m_measured[direction < 0 ? 1U : 0U][segmentOf(encoderDeg)] = true;
  }
}

void CoverageRing::setCaption(const QString& text, const QString& below) {
  if (text != m_caption || below != m_below) {
    m_caption = text;
    m_below = below;
    update();
  }
}

int CoverageRing::coveredPercent() const {
  const std::size_t planned = m_planned.size() * (m_bothDirections ? 2 : 1);
  auto measured = std::ranges::count(m_measured[0], true);
  measured += m_bothDirections ? std::ranges::count(m_measured[1], true) : 0;
  return planned == 0 ? 0 : static_cast<int>(static_cast<std::size_t>(measured) * 100 / planned);
}

QSize CoverageRing::sizeHint() const { return {220, 220}; }

QSize CoverageRing::minimumSizeHint() const { return {160, 160}; }

void CoverageRing::drawBand(QPainter& painter, const QRectF& square, double width, std::size_t direction) const {
  painter.setPen(QPen(stepColor(*this, StepColor::Faint), width, Qt::SolidLine, Qt::FlatCap));
  painter.drawArc(square, 0, 360 * 16);
  const QColor color = stepColor(*this, direction == 0 ? StepColor::Sensor : StepColor::Warning);
  painter.setPen(QPen(color, width, Qt::SolidLine, Qt::FlatCap));
  const std::size_t count = m_planned.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!m_measured[direction][i]) {
      continue;
    }
    std::size_t last = i; // neighbours join into one arc, drawn from half way before to half way after
    while (last + 1 < count && m_measured[direction][last + 1]) {
      ++last;
    }
    const double before = angle::wrap360(m_planned[i] - m_planned[(i + count - 1) % count]);
    const double after = angle::wrap360(m_planned[(last + 1) % count] - m_planned[last]);
    const double from = m_planned[i] - before / 2.0;
    const double to = m_planned[last] + after / 2.0;
    painter.drawArc(square, painterAngle(from), painterAngle(to) - painterAngle(from));
    i = last;
  }
}

void CoverageRing::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF center = QRectF(rect()).center();
  const double radius = std::min(width(), height()) / 2.0 - 6.0;
  const double band = std::clamp(radius * 0.13, 6.0, 18.0);
  const auto square = [center](double r) { return QRectF(center.x() - r, center.y() - r, 2 * r, 2 * r); };
  const double outer = radius - band / 2.0;
  drawBand(painter, square(outer), band, 0);
  if (m_bothDirections) {
    drawBand(painter, square(outer - band * 1.35), band, 1);
  }
  if (m_shaftDeg) {
    const double at = *m_shaftDeg * std::numbers::pi / 180.0;
    const QPointF direction(std::sin(at), -std::cos(at));
    painter.setPen(QPen(stepColor(*this, StepColor::Reference), 3.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(center + direction * (radius - band * 1.2), center + direction * (radius + 3.0));
  }
  QFont large = font();
  large.setPointSizeF(large.pointSizeF() * 1.9);
  large.setWeight(QFont::DemiBold);
  const double line = QFontMetricsF(large).height();
  painter.setFont(large);
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(QRectF(center.x() - radius, center.y() - line * 0.85, 2 * radius, line), Qt::AlignCenter, m_caption);
  painter.setFont(font());
  painter.setPen(stepColor(*this, StepColor::Quiet));
  painter.drawText(QRectF(center.x() - radius, center.y() + line * 0.15, 2 * radius, line), Qt::AlignCenter, m_below);
}

} // namespace straightedge::gui
