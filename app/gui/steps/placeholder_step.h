// A page for a step that is not built yet: its name, and what to do instead.
#pragma once

#include "app/gui/steps/step_page.h"

namespace straightedge::gui {

class PlaceholderStep : public StepPage {
  Q_OBJECT
public:
  /// `instead`: rich text for the page.
  PlaceholderStep(const QString& title, const QString& helpPage, const QString& instead, QWidget* parent);
  QString title() const override { return m_title; }
  QString helpPage() const override { return m_helpPage; }

private:
  QString m_title;
  QString m_helpPage;
};

} // namespace straightedge::gui
