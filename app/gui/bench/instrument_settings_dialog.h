// What can be chosen about one instrument: its own settings, the line's baud rate, its latency.
#pragma once

#include "devices/bench/saved_bench.h"
#include "devices/instruments/profile_files.h"

#include <QDialog>

#include <functional>
#include <map>
#include <string>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QPushButton;

namespace straightedge::gui {

class TintedLabel;

/// Ok is possible only with settings that the instrument accepts; what is wrong is said below the form.
class InstrumentSettingsDialog : public QDialog {
  Q_OBJECT
public:
  InstrumentSettingsDialog(devices::BenchInstrument instrument, const devices::ProfileSet& profiles,
                           QWidget* parent = nullptr);
  devices::BenchInstrument instrument() const; ///< as the form says

private:
  void addSettings(QFormLayout& form);
  void addLine(QFormLayout& form);
  void check();

  const devices::BenchInstrument m_before;
  const devices::ProfileSet m_profiles;
  std::map<std::string, std::function<QString()>> m_fields; ///< by key: what stands in it
  std::map<std::string, QString> m_defaults;
  QComboBox* m_baud = nullptr; ///< null: not a serial line
  QDoubleSpinBox* m_latency = nullptr;
  TintedLabel* m_problem = nullptr;
  QPushButton* m_ok = nullptr;
};

} // namespace straightedge::gui
