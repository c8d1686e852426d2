#include "app/gui/bench/tinted_label.h"

#include <QApplication>
#include <QEvent>

namespace straightedge::gui {

TintedLabel::TintedLabel(Color color, QWidget* parent) : QLabel(parent), m_color(color) {
  setWordWrap(true);
  setTextFormat(Qt::PlainText);
  setTextInteractionFlags(Qt::TextSelectableByMouse);
  tint();
}

void TintedLabel::setTextOrHide(const QString& text) {
  setText(text);
  setVisible(!text.isEmpty());
}

void TintedLabel::changeEvent(QEvent* event) {
  QLabel::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && !m_tinting) {
    tint();
  }
}

void TintedLabel::tint() {
  m_tinting = true;
  QPalette own = QApplication::palette(this);
  own.setColor(QPalette::WindowText, m_color(own));
  setPalette(own);
  m_tinting = false;
}

} // namespace straightedge::gui
