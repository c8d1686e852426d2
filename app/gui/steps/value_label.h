// A number with a caption above it, in figures that do not jump about while they change.
#pragma once

#include "app/gui/steps/step_colors.h"

#include <QString>
#include <QWidget>

#include <optional>

class QLabel;

namespace straightedge::gui {

class ValueLabel : public QWidget {
  Q_OBJECT
public:
  enum class Size : std::uint8_t { Small, Medium, Large };

  ValueLabel(const QString& caption, Size size, std::optional<StepColor> color = std::nullopt,
             QWidget* parent = nullptr);

  void setText(const QString& text);
  QString text() const;
  void setCaption(const QString& caption);

protected:
  void changeEvent(QEvent* event) override;

private:
  void applyColors();

  std::optional<StepColor> m_color;
  QLabel* m_caption;
  QLabel* m_value;
};

} // namespace straightedge::gui
