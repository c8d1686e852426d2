// A line of text that wraps, in a colour that follows the theme.
#pragma once

#include <QLabel>

namespace straightedge::gui {

class TintedLabel : public QLabel {
  Q_OBJECT
public:
  using Color = QColor (*)(const QPalette&);
  TintedLabel(Color color, QWidget* parent);
  void setTextOrHide(const QString& text); ///< takes no room where there is none

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  Color m_color;
};

} // namespace straightedge::gui
