#include "app/gui/steps/placeholder_step.h"

#include <QLabel>
#include <QVBoxLayout>

namespace straightedge::gui {

PlaceholderStep::PlaceholderStep(const QString& title, const QString& helpPage, const QString& instead, QWidget* parent)
    : StepPage(parent), m_title(title), m_helpPage(helpPage) {
  auto* layout = new QVBoxLayout(this);
  auto* label = new QLabel(instead, this);
  label->setTextFormat(Qt::RichText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  label->setWordWrap(true);
  label->setMaximumWidth(fontMetrics().averageCharWidth() * 100);
  layout->addStretch(1);
  layout->addWidget(label, 0, Qt::AlignHCenter);
  layout->addStretch(2);
}

} // namespace straightedge::gui
