// The table of chosen models: a check mark shows or hides each in the plots, a swatch is its colour there, the one that
// Verify uses is bold.
#pragma once

#include "app/gui/steps/result_table.h"

namespace straightedge::gui {

class FitPresenter;

class ModelList : public ResultTable {
  Q_OBJECT
public:
  explicit ModelList(FitPresenter& presenter, QWidget* parent = nullptr);
  void refresh();

protected:
  void changeEvent(QEvent* event) override; ///< swatches follow the theme

private:
  FitPresenter& m_presenter;
  bool m_filling = false;
};

} // namespace straightedge::gui
