#include "app/gui/steps/value_label.h"

#include <QLabel>
#include <QVBoxLayout>

namespace straightedge::gui {

namespace {

double factorOf(ValueLabel::Size size) {
  switch (size) {
  case ValueLabel::Size::Small:
    return 1.15;
  case ValueLabel::Size::Medium:
    return 1.5;
  case ValueLabel::Size::Large:
    return 2.6;
  }
  return 1.0;
}

} // namespace

ValueLabel::ValueLabel(const QString& caption, Size size, QPalette::ColorRole role, QWidget* parent)
    : QWidget(parent), m_caption(new QLabel(caption, this)), m_value(new QLabel(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 6);
  layout->setSpacing(0);
  layout->addWidget(m_caption);
  layout->addWidget(m_value);
  QFont figures = font();
  figures.setPointSizeF(figures.pointSizeF() * factorOf(size));
  figures.setWeight(size == Size::Small ? QFont::Medium : QFont::DemiBold);
  m_value->setFont(figures);
  m_value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_value->setAccessibleName(caption);
  if (size == Size::Large) { // room for the widest reading, so that nothing moves
    m_value->setMinimumWidth(m_value->fontMetrics().horizontalAdvance(QStringLiteral("000.0000°")));
  }
  m_caption->setForegroundRole(QPalette::PlaceholderText);
  m_value->setForegroundRole(role);
}

void ValueLabel::setText(const QString& text) {
  if (text != m_value->text()) {
    m_value->setText(text);
  }
}

QString ValueLabel::text() const { return m_value->text(); }

void ValueLabel::setCaption(const QString& caption) { m_caption->setText(caption); }

} // namespace straightedge::gui
