// One role of the bench: a place to drop a device on, a list to choose one from, and what it reads right now.
#pragma once

#include "app/gui/bench/bench_presenter.h"

#include <QFrame>

class QComboBox;
class QLabel;
class QToolButton;

namespace straightedge::gui {

class TintedLabel;

class RoleRow : public QFrame {
  Q_OBJECT
public:
  explicit RoleRow(const RoleSlot& slot, QWidget* parent = nullptr);

  void showRole(const BenchPresenter::RoleView& view, bool mayEdit);
  void showReading(const BenchPresenter::RoleView& view);
  devices::InstrumentRole role() const { return m_role; }

signals:
  void deviceDropped(const QString& key);
  void deviceChosen(int device); ///< -1: nobody
  void instrumentChosen(int index);
  void settingsWanted();

protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  void setTarget(bool target);

  const devices::InstrumentRole m_role;
  QLabel* m_value = nullptr;
  QComboBox* m_device = nullptr;
  QComboBox* m_instrument = nullptr;
  QToolButton* m_settings = nullptr;
  TintedLabel* m_caution = nullptr;
  TintedLabel* m_fault = nullptr;
  bool m_target = false; ///< a device hovers over it
};

} // namespace straightedge::gui
