// A page for a step that is not built yet: its name, what is missing, nothing else.
#pragma once

#include "app/gui/steps/step_page.h"

namespace straightedge::gui {

class PlaceholderStep : public StepPage {
  Q_OBJECT
public:
  PlaceholderStep(const QString& title, const QString& helpPage, QWidget* parent);
  QString title() const override { return m_title; }
  QString helpPage() const override { return m_helpPage; }
  QString missing() const override;

private:
  QString m_title;
  QString m_helpPage;
};

} // namespace straightedge::gui
