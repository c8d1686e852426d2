// The stages of a campaign as a list: what is still to be measured, why, how long it takes; repeat and leave out.
#pragma once

#include "app/gui/field_steps/capture_stages.h"

#include <QList>
#include <QWidget>

class QAction;
class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace straightedge::gui {

class StageList : public QWidget {
  Q_OBJECT
public:
  explicit StageList(QWidget* parent = nullptr);

  /// Selection and scrolling stay where the number of stages stays.
  void setStages(std::vector<StageLine> stages);
  /// What may be done with the chosen stages.
  void setRights(bool mayRepeat, bool mayLeaveOut);
  int current() const; ///< -1: none
  void setCurrent(int stage);
  QList<int> selected() const;

signals:
  void chosen(int stage); ///< the current one has changed
  void selectionChanged();
  void repeatWanted(int stage);                            ///< measure it again
  void leaveOutWanted(const QList<int>& stages, bool out); ///< or take them back in

protected:
  void changeEvent(QEvent* event) override;

private:
  void makeActions();
  void fill(QTreeWidgetItem& item, const StageLine& line);
  void showDetail();
  bool wouldLeaveOut() const; ///< some of the selected stages are in
  void leaveOut(bool out);

  std::vector<StageLine> m_lines;
  QTreeWidget* m_tree = nullptr;
  QLabel* m_detail = nullptr;
  QAction* m_repeat = nullptr;
  QAction* m_out = nullptr;
  QAction* m_in = nullptr;
  QPushButton* m_repeatButton = nullptr;
  QPushButton* m_outButton = nullptr;
  bool m_mayLeaveOut = false;
};

} // namespace straightedge::gui
