// Which saved bench is shown, and keeping it: a list, and buttons to save and delete.
#pragma once

#include "app/gui/bench/bench_presenter.h"

#include <QWidget>

class QComboBox;
class QPushButton;

namespace straightedge::gui {

class SavedBenchRow : public QWidget {
  Q_OBJECT
public:
  /// `presenter` outlives it.
  explicit SavedBenchRow(BenchPresenter& presenter, QWidget* parent = nullptr);

private:
  void showSaved();
  void saveAs();
  void deleteBench();

  BenchPresenter& m_presenter;
  QComboBox* m_saved;
  QPushButton* m_save;
  QPushButton* m_saveAs;
  QPushButton* m_delete;
};

} // namespace straightedge::gui
