#include "app/gui/shell/file_row.h"

#include "app/gui/shell/line_icon.h"

#include <QKeyEvent>
#include <QPainter>
#include <QToolButton>

namespace straightedge::gui {

FileRow::FileRow(const QString& name, const QString& detail, bool exists, const QString& removeTip, QWidget* parent)
    : QAbstractButton(parent), m_detail(detail), m_exists(exists), m_remove(new QToolButton(this)) {
  setText(QString(name).replace('&', "&&"));
  setAccessibleName(name);
  setAccessibleDescription(detail);
  setToolTip(detail);
  setAttribute(Qt::WA_Hover);
  setFocusPolicy(Qt::StrongFocus);
  if (exists) {
    setCursor(Qt::PointingHandCursor);
  }
  m_remove->setAutoRaise(true);
  m_remove->setIcon(lineIcon("close"));
  m_remove->setIconSize({12, 12});
  m_remove->setToolTip(removeTip);
  m_remove->setAccessibleName(removeTip);
  m_remove->setFocusPolicy(Qt::NoFocus); // Delete on the row does the same
  m_remove->setCursor(Qt::ArrowCursor);
  connect(m_remove, &QToolButton::clicked, this, &FileRow::removeRequested);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize FileRow::sizeHint() const { return {240, 2 * fontMetrics().height() + 14}; }

void FileRow::resizeEvent(QResizeEvent* event) {
  QAbstractButton::resizeEvent(event);
  const QSize size = m_remove->sizeHint();
  m_remove->setGeometry(width() - size.width() - 6, (height() - size.height()) / 2, size.width(), size.height());
}

void FileRow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Delete) {
    emit removeRequested();
    return;
  }
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    click();
    return;
  }
  QAbstractButton::keyPressEvent(event);
}

void FileRow::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF area = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  if (underMouse() || hasFocus()) {
    QColor fill = palette().color(QPalette::Highlight);
    fill.setAlphaF(0.08F);
    painter.setBrush(fill);
    painter.setPen(hasFocus() ? QPen(palette().color(QPalette::Highlight)) : QPen(Qt::NoPen));
    painter.drawRoundedRect(area, 5, 5);
  }
  const QFontMetrics metrics(font());
  const int left = 10;
  const int room = m_remove->x() - left - 6;
  const int top = (height() - 2 * metrics.height()) / 2;
  const auto name = m_exists ? QPalette::Text : QPalette::PlaceholderText;
  painter.setPen(palette().color(name));
  painter.drawText(QRect(left, top, room, metrics.height()), Qt::AlignLeft | Qt::AlignVCenter,
                   metrics.elidedText(accessibleName(), Qt::ElideMiddle, room));
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(QRect(left, top + metrics.height(), room, metrics.height()), Qt::AlignLeft | Qt::AlignVCenter,
                   metrics.elidedText(m_detail, Qt::ElideMiddle, room));
}

} // namespace straightedge::gui
