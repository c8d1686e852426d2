// Real instruments for a step Connect: what is plugged in, the roles that they fill, saved benches, connecting. Of any
// kind of calibration; a page embeds it with the roles that it needs.
#pragma once

#include "app/gui/bench/bench_presenter.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QPushButton;

namespace straightedge::gui {

class BenchConsole;
class DeviceList;
class RoleRow;
class TintedLabel;

class BenchPanel : public QWidget {
  Q_OBJECT
public:
  /// `presenter` outlives the panel.
  explicit BenchPanel(BenchPresenter& presenter, QWidget* parent = nullptr);

  /// Made once, for the page to place; the panel has the switch that shows and hides it.
  BenchConsole& console() { return *m_console; }

private:
  QWidget* makeDevices();
  QWidget* makeRoles();
  QWidget* makePairing();
  void connectPresenter();
  void showDevices();
  void showDevice();
  void showRoles();
  void showReadings();
  void showPairing();
  void showState();
  void showProblem();
  void openMenu(int device, const QPoint& globalPosition);
  void openSettings(devices::InstrumentRole role);
  int deviceOf(const QString& key) const;

  BenchPresenter& m_presenter;
  TintedLabel* m_devicesNote = nullptr;
  DeviceList* m_devices = nullptr;
  TintedLabel* m_deviceWhere = nullptr;
  TintedLabel* m_deviceProblem = nullptr;
  QPushButton* m_copyCommand = nullptr;
  std::vector<RoleRow*> m_roles;
  QWidget* m_pairing = nullptr;
  QComboBox* m_pairingRule = nullptr;
  QDoubleSpinBox* m_pairingAge = nullptr;
  TintedLabel* m_problem = nullptr;
  TintedLabel* m_status = nullptr;
  QPushButton* m_connect = nullptr;
  QPushButton* m_showConsole = nullptr;
  BenchConsole* m_console = nullptr;
  QString m_command; ///< that mends what keeps the chosen device from opening
};

} // namespace straightedge::gui
