#include "app/gui/steps/placeholder_step.h"

#include <QLabel>
#include <QVBoxLayout>

namespace straightedge::gui {

PlaceholderStep::PlaceholderStep(const QString& title, const QString& helpPage, QWidget* parent)
    : StepPage(parent), m_title(title), m_helpPage(helpPage) {
  auto* layout = new QVBoxLayout(this);
  auto* label = new QLabel(PlaceholderStep::missing(), this);
  label->setAlignment(Qt::AlignCenter);
  label->setWordWrap(true);
  layout->addWidget(label);
}

QString PlaceholderStep::missing() const { return tr("The step %1 is not part of this build.").arg(m_title); }

} // namespace straightedge::gui
