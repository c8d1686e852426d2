#include "app/gui/shell/action_card.h"

#include "app/gui/shell/line_icon.h"

#include <QPainter>

namespace straightedge::gui {

namespace {
constexpr int iconExtent = 26;
constexpr int cardPadding = 14;
} // namespace

ActionCard::ActionCard(const QString& icon, const QString& title, const QString& description, QWidget* parent)
    : QAbstractButton(parent), m_icon(icon), m_description(description) {
  setText(title);
  setAccessibleDescription(description);
  setAttribute(Qt::WA_Hover);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QFont ActionCard::titleFont() const {
  QFont title = font();
  title.setBold(true);
  title.setPointSizeF(title.pointSizeF() * 1.08);
  return title;
}

QSize ActionCard::sizeHint() const {
  const QFontMetrics title(titleFont());
  const QFontMetrics body(font());
  QString plain = text();
  plain.remove('&');
  return {3 * cardPadding + iconExtent + qMax(title.horizontalAdvance(plain), body.horizontalAdvance(m_description)) +
              4,
          2 * cardPadding + title.height() + body.height() + 2};
}

QSize ActionCard::minimumSizeHint() const { return {220, sizeHint().height()}; }

void ActionCard::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF area = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  const QColor accent = palette().color(QPalette::Highlight);
  QColor fill = palette().color(QPalette::Base);
  if (isDown()) {
    fill = palette().color(QPalette::AlternateBase);
  }
  painter.setBrush(fill);
  painter.setPen(QPen(underMouse() || hasFocus() ? accent : palette().color(QPalette::Mid), hasFocus() ? 1.5 : 1.0));
  painter.drawRoundedRect(area, 7, 7);

  const QRectF icon(cardPadding + 2, (height() - iconExtent) / 2.0, iconExtent, iconExtent);
  paintLineIcon(painter, icon, m_icon, accent);
  const int left = 2 * cardPadding + iconExtent + 4;
  const QFontMetrics title(titleFont());
  const QFontMetrics body(font());
  const int top = (height() - title.height() - body.height() - 2) / 2;
  const int room = width() - left - cardPadding;
  painter.setFont(titleFont());
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(QRect(left, top, room, title.height()), Qt::AlignLeft | Qt::AlignVCenter | Qt::TextShowMnemonic,
                   text());
  painter.setFont(font());
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(QRect(left, top + title.height() + 2, room, body.height()), Qt::AlignLeft | Qt::AlignVCenter,
                   body.elidedText(m_description, Qt::ElideRight, room));
}

} // namespace straightedge::gui
