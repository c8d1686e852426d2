#include "app/gui/shell/message_bar.h"

#include "app/gui/shell/line_icon.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

namespace straightedge::gui {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent), m_text(new QLabel(this)) {
  setObjectName("messageBar");
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(16, 8, 8, 8);
  m_text->setWordWrap(true);
  m_text->setTextFormat(Qt::PlainText);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout->addWidget(m_text, 1);
  auto* close = new QToolButton(this);
  close->setAutoRaise(true);
  close->setIcon(lineIcon("close"));
  close->setToolTip(tr("Dismiss"));
  close->setAccessibleName(tr("Dismiss the message"));
  connect(close, &QToolButton::clicked, this, &MessageBar::dismiss);
  layout->addWidget(close, 0, Qt::AlignTop);
  hide();
}

void MessageBar::showMessage(const QString& text, Kind kind) {
  m_kind = kind;
  m_text->setText(text);
  setAccessibleName(text);
  show();
  update();
}

void MessageBar::dismiss() { hide(); }

QString MessageBar::text() const { return isHidden() ? QString() : m_text->text(); }

void MessageBar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    update();
  }
}

void MessageBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QColor mark = m_kind == Kind::Problem ? QColor(0xd2, 0x4b, 0x3f) : palette().color(QPalette::Highlight);
  QColor wash = mark;
  wash.setAlphaF(0.12F);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  painter.fillRect(rect(), wash);
  painter.fillRect(QRect(0, 0, 4, height()), mark);
  painter.fillRect(QRect(0, height() - 1, width(), 1), palette().color(QPalette::Mid));
}

} // namespace straightedge::gui
