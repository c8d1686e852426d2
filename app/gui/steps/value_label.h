// A number with a caption above it, in figures that do not jump about while they change.
#pragma once

#include <QPalette>
#include <QString>
#include <QWidget>

class QLabel;

namespace straightedge::gui {

class ValueLabel : public QWidget {
  Q_OBJECT
public:
  enum class Size : std::uint8_t { Small, Medium, Large };

  /// `role` colours the number; a role of the palette follows every change of theme.
  ValueLabel(const QString& caption, Size size, QPalette::ColorRole role = QPalette::WindowText,
             QWidget* parent = nullptr);

  void setText(const QString& text);
  QString text() const;
  void setCaption(const QString& caption);

private:
  QLabel* m_caption;
  QLabel* m_value;
};

} // namespace straightedge::gui
