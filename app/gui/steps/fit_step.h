// Step Fit: the correction curve with all chosen models over it, what they leave, harmonics, families of sizes.
#pragma once

#include "app/gui/steps/fit_presenter.h"
#include "app/gui/steps/step_page.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSplitter;
class QToolButton;

namespace straightedge::gui {

class ModelChooser;
class ModelList;
class NoticeList;

class FitStep : public StepPage {
  Q_OBJECT
public:
  explicit FitStep(StepContext context, QWidget* parent = nullptr);

  QString title() const override;
  QString helpPage() const override;
  QString missing() const override;
  void entered() override;
  void left() override;

private:
  QWidget* makeSide();
  QWidget* makePlots();
  QWidget* makeModels();
  void refresh(); ///< while shown at once, otherwise when entered
  void showPlots();
  FitView view() const;

  FitPresenter m_presenter;
  bool m_shown = false;
  bool m_stale = true;
  NoticeList* m_notices = nullptr;
  QComboBox* m_curve = nullptr;
  QLabel* m_curveText = nullptr;
  ModelChooser* m_chooser = nullptr;
  QComboBox* m_view = nullptr;
  QToolButton* m_magnifier = nullptr;
  QSplitter* m_plots = nullptr;
  PlotView* m_upper = nullptr;
  PlotView* m_lower = nullptr;
  ModelList* m_models = nullptr;
  QPushButton* m_remove = nullptr;
  QPushButton* m_copy = nullptr;
};

} // namespace straightedge::gui
