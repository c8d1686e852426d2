#include "app/gui/shell/step_bar.h"

#include <QButtonGroup>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QStyleOption>
#include <QVBoxLayout>

namespace straightedge::gui {

namespace {

constexpr qreal circleRadius = 11.0;
constexpr qreal circleX = 26.0; // centre, from the rail's left edge

QColor goodColor(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < 128 ? QColor(0x4c, 0xb3, 0x7c) : QColor(0x1e, 0x8a, 0x54);
}

QColor badColor(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < 128 ? QColor(0xe8, 0x6d, 0x62) : QColor(0xc4, 0x3a, 0x31);
}

} // namespace

StepButton::StepButton(int index, int count, const QString& title, const QString& hint, QWidget* parent)
    : QAbstractButton(parent), m_index(index), m_count(count), m_hint(hint) {
  setText(title);
  setObjectName("step" + title);
  setAccessibleName(tr("Step %1: %2").arg(index + 1).arg(title));
  setCheckable(true);
  setFocusPolicy(Qt::TabFocus);
  setAttribute(Qt::WA_Hover);
  updateToolTip();
}

void StepButton::setState(const StepState& state) {
  if (state == m_state) {
    return;
  }
  m_state = state;
  updateToolTip();
  update();
}

void StepButton::updateToolTip() {
  const QString key =
      QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + m_index)).toString(QKeySequence::NativeText);
  QString tip = QStringLiteral("<b>%1</b> (%2)<br>%3").arg(text(), key, m_hint.toHtmlEscaped());
  if (!m_state.note.isEmpty()) {
    tip += QStringLiteral("<br><br>%1").arg(m_state.note.toHtmlEscaped());
  }
  setToolTip(tip);
  setAccessibleDescription(m_state.note);
}

QSize StepButton::sizeHint() const {
  const QFontMetrics metrics(font());
  return {168, qMax(44, metrics.height() * 2 + 8)};
}

QColor StepButton::circleColor() const {
  switch (m_state.progress) {
  case StepProgress::Done:
    return goodColor(palette());
  case StepProgress::Failed:
    return badColor(palette());
  case StepProgress::Available:
    return isChecked() ? palette().color(QPalette::Highlight) : palette().color(QPalette::Text);
  case StepProgress::Missing:
    break;
  }
  return isChecked() ? palette().color(QPalette::Highlight) : palette().color(QPalette::PlaceholderText);
}

void StepButton::paintCircle(QPainter& painter, const QRectF& circle) const {
  const QColor color = circleColor();
  const bool solid = isChecked() || m_state.progress == StepProgress::Done || m_state.progress == StepProgress::Failed;
  QPen outline(color, 1.5);
  if (m_state.progress == StepProgress::Missing && !isChecked()) {
    outline.setStyle(Qt::DotLine);
  }
  painter.setPen(outline);
  painter.setBrush(solid ? QBrush(color) : QBrush(palette().color(QPalette::Window)));
  painter.drawEllipse(circle);

  const QColor sign = solid ? QColor(Qt::white) : color;
  painter.setPen(QPen(sign, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  const QPointF c = circle.center();
  if (m_state.progress == StepProgress::Done) {
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(QPolygonF({c + QPointF(-4.5, 0.3), c + QPointF(-1.3, 3.6), c + QPointF(4.8, -3.4)}));
  } else if (m_state.progress == StepProgress::Failed) {
    painter.drawLine(c + QPointF(0, -5), c + QPointF(0, 1.2));
    painter.drawPoint(c + QPointF(0, 4.6));
  } else {
    QFont number = font();
    number.setBold(true);
    painter.setFont(number);
    painter.drawText(circle, Qt::AlignCenter, QString::number(m_index + 1));
  }
}

void StepButton::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF area = QRectF(rect()).adjusted(6, 2, -6, -2);
  if (isChecked() || underMouse()) {
    QColor fill = palette().color(QPalette::Highlight);
    fill.setAlphaF(isChecked() ? 0.14F : 0.06F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawRoundedRect(area, 6, 6);
  }
  if (hasFocus()) {
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(area.adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
  }

  const QPointF centre(circleX, height() / 2.0);
  painter.setPen(QPen(palette().color(QPalette::Mid), 1.5));
  if (m_index > 0) {
    painter.drawLine(QPointF(circleX, 0), centre - QPointF(0, circleRadius + 2));
  }
  if (m_index + 1 < m_count) {
    painter.drawLine(centre + QPointF(0, circleRadius + 2), QPointF(circleX, height()));
  }
  paintCircle(painter,
              QRectF(centre - QPointF(circleRadius, circleRadius), QSizeF(2 * circleRadius, 2 * circleRadius)));

  QFont label = font();
  label.setBold(isChecked());
  painter.setFont(label);
  const bool faint = m_state.progress == StepProgress::Missing && !isChecked();
  painter.setPen(palette().color(faint ? QPalette::PlaceholderText : QPalette::WindowText));
  painter.drawText(QRectF(circleX + circleRadius + 11, 0, width() - circleX - circleRadius - 18, height()),
                   Qt::AlignVCenter | Qt::AlignLeft, text());
}

StepBar::StepBar(QWidget* parent) : QWidget(parent) {
  setObjectName("stepBar");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 10, 1, 10);
  layout->setSpacing(0);
  m_entries = new QVBoxLayout;
  m_entries->setSpacing(0);
  layout->addLayout(m_entries);
  layout->addStretch(1);
  m_group = new QButtonGroup(this);
  m_group->setExclusive(true);
  connect(m_group, &QButtonGroup::idClicked, this, &StepBar::chosen);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
}

void StepBar::setSteps(std::span<const StepEntry> steps) {
  for (StepButton* button : m_buttons) {
    m_group->removeButton(button);
    delete button;
  }
  m_buttons.clear();
  m_current = -1;
  const auto count = static_cast<int>(steps.size());
  for (const StepEntry& step : steps) {
    const auto index = static_cast<int>(m_buttons.size());
    auto* button = new StepButton(index, count, tr(step.title), tr(step.hint), this);
    m_group->addButton(button, index);
    m_entries->addWidget(button);
    m_buttons.push_back(button);
  }
}

void StepBar::setCurrent(int index) {
  m_current = index;
  if (index >= 0) {
    m_buttons[static_cast<std::size_t>(index)]->setChecked(true);
  }
}

void StepBar::setState(std::size_t step, const StepState& state) { m_buttons[step]->setState(state); }

void StepBar::addFoot(QWidget* widget) { layout()->addWidget(widget); }

void StepBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Window));
  painter.fillRect(QRect(width() - 1, 0, 1, height()), palette().color(QPalette::Mid));
}

void StepBar::keyPressEvent(QKeyEvent* event) {
  const int step = event->key() == Qt::Key_Down ? 1 : event->key() == Qt::Key_Up ? -1 : 0;
  const int next = m_current + step;
  if (step != 0 && next >= 0 && next < static_cast<int>(m_buttons.size())) {
    m_buttons[static_cast<std::size_t>(next)]->setFocus(Qt::TabFocusReason);
    emit chosen(next);
    return;
  }
  QWidget::keyPressEvent(event);
}

} // namespace straightedge::gui
