#include "app/gui/steps/placeholder_step.h"

#include <QHBoxLayout>
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
  label->setFixedWidth(fontMetrics().averageCharWidth() * 90); // its height then follows from its text
  auto* middle = new QHBoxLayout;
  middle->addStretch(1);
  middle->addWidget(label);
  middle->addStretch(1);
  layout->addStretch(1);
  layout->addLayout(middle);
  layout->addStretch(2);
}

} // namespace straightedge::gui
