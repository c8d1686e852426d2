// What the window says and does about real instruments, without widgets: what is plugged in, who fills which role, the
// saved benches, opening, live readings. For any kind of calibration: the roles are a parameter.
#pragma once

#include "app/gui/bench/bench_draft.h"
#include "app/gui/bench/bench_opener.h"
#include "app/gui/bench/device_watch.h"

#include <QStringList>

namespace straightedge::gui {

/// GUI thread.
class BenchPresenter : public QObject {
  Q_OBJECT
public:
  struct Options {
    QString kind; ///< "angle", "field": the bench used last is remembered by it
    std::vector<RoleSlot> roles;
    devices::DeviceLister lister = {}; ///< empty: what is really there
    bool byEvents = true;              ///< as DeviceWatch
  };
  struct DeviceRow {
    QString title;   ///< "US Digital QSB encoder reader"
    QString where;   ///< "0403:6001, serial FT-1"
    QString use;     ///< what it can be, or which role it fills
    QString caution; ///< "Not yet tried on hardware. …"; may be empty
    QString problem; ///< why it cannot be opened; empty: nothing is known to be in the way
    QString remedy;
    bool useful = false; ///< it may fill one of the roles
  };
  struct RoleChoice {
    QString text;
    int device = -1; ///< index into devices(); -1: nobody; -2: one that is not plugged in
  };
  struct RoleView {
    RoleSlot slot;
    std::vector<RoleChoice> choices; ///< nobody first
    int chosen = 0;
    std::vector<QString> instruments; ///< what the device may be taken for
    int instrument = 0;
    QString caution;
    QString value; ///< live; empty while there is none
    QString fault; ///< why there is none
    bool filled = false;
    bool hasSettings = false;
  };

  BenchPresenter(JobRunner& jobs, Options options, QObject* parent = nullptr);

  // Devices
  const std::vector<devices::ListedDevice>& devices() const { return m_watch.devices(); }
  std::vector<DeviceRow> deviceRows() const;
  QString devicesNote() const; ///< while nothing can be listed: why, and what works all the same
  DeviceWatch& watch() { return m_watch; }

  // Roles
  const BenchDraft& draft() const { return m_draft; }
  std::vector<RoleView> roleViews() const;
  std::vector<devices::InstrumentRole> rolesFor(int device) const;
  bool mayEdit() const { return m_opener.state() == BenchOpener::State::Closed; }
  bool mayClose() const { return !m_capturing; } ///< and open: not during a capture
  void assign(devices::InstrumentRole role, int device);
  void clear(devices::InstrumentRole role);
  void chooseInstrument(devices::InstrumentRole role, int index); ///< into RoleView::instruments
  void setInstrument(devices::InstrumentRole role, const devices::BenchInstrument& changed);
  void setPairing(const devices::PairingRule& rule);

  // Saved benches
  QStringList savedNames() const { return m_saved; }
  QString benchName() const;
  bool isChanged() const; ///< since it was loaded or saved
  void load(const QString& name);
  void startAnew();
  bool save(const QString& name);
  void deleteSaved(const QString& name);

  // Opening
  BenchOpener& opener() { return m_opener; }
  const BenchOpener& opener() const { return m_opener; }
  void open();
  void close();
  QString statusText() const;
  QString problem() const { return m_problem; } ///< the last thing that went wrong, with its remedy

  void setShown(bool shown); ///< watches devices and reads roles only while somebody looks
  void setCapturing(bool capturing);

signals:
  void devicesChanged();
  void rolesChanged(); ///< who fills them
  void rolesRead();    ///< values and faults
  void savedChanged();
  void stateChanged();
  void problemChanged();

private:
  void setProblem(const QString& problem);
  void readSaved();
  void remember(const QString& name);
  void changed();
  RoleView roleView(const RoleSlot& slot) const;
  const RoleSlot* slotOf(devices::InstrumentRole role) const;

  const QString m_kind;
  BenchDraft m_draft;
  DeviceWatch m_watch;
  BenchOpener m_opener;
  QStringList m_saved;
  devices::SavedBench m_asSaved; ///< the draft as it was loaded or saved last
  QString m_problem;
  bool m_capturing = false;
};

} // namespace straightedge::gui
