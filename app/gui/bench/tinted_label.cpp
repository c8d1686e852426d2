#include "app/gui/bench/tinted_label.h"

#include <QApplication>

namespace straightedge::gui {

TintedLabel::TintedLabel(Color color, QWidget* parent) : QLabel(parent), m_color(color) {
  setWordWrap(true);
  setTextFormat(Qt::PlainText);
  setTextInteractionFlags(Qt::TextSelectableByMouse);
}

void TintedLabel::setTextOrHide(const QString& text) {
  setText(text);
  setVisible(!text.isEmpty());
}

void TintedLabel::paintEvent(QPaintEvent* event) {
  // Looked at here: whatever way the theme changed, it is painted anew.
  const QPalette theme = QApplication::palette();
  if (const QColor wanted = m_color(theme); palette().color(QPalette::WindowText) != wanted) {
    QPalette own = palette();
    own.setColor(QPalette::WindowText, wanted);
    setPalette(own);
  }
  QLabel::paintEvent(event);
}

} // namespace straightedge::gui
