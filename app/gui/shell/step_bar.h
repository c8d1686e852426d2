// The rail of steps at the left: where one is, what is done, what is missing.
#pragma once

#include "app/gui/shell/step_entry.h"

#include <QAbstractButton>
#include <QWidget>

#include <span>
#include <vector>

class QButtonGroup;
class QVBoxLayout;

namespace straightedge::gui {

/// One entry of the rail.
class StepButton : public QAbstractButton {
  Q_OBJECT
public:
  StepButton(int index, int count, const QString& title, const QString& hint, QWidget* parent);
  void setState(const StepState& state);
  const StepState& state() const { return m_state; }
  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  void updateToolTip();
  QColor circleColor() const;
  void paintCircle(QPainter& painter, const QRectF& circle) const;

  int m_index;
  int m_count;
  QString m_hint;
  StepState m_state;
};

class StepBar : public QWidget {
  Q_OBJECT
public:
  explicit StepBar(QWidget* parent = nullptr);
  void setSteps(std::span<const StepEntry> steps); ///< none of them is current
  void setCurrent(int index);
  int current() const { return m_current; }
  void setState(std::size_t step, const StepState& state);
  StepButton* button(std::size_t step) const { return m_buttons[step]; }
  /// A widget at the foot of the rail.
  void addFoot(QWidget* widget);

signals:
  void chosen(int index);

protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  QVBoxLayout* m_entries = nullptr;
  QButtonGroup* m_group = nullptr;
  std::vector<StepButton*> m_buttons;
  int m_current = -1;
};

} // namespace straightedge::gui
