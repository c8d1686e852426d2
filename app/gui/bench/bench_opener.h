// A bench of real instruments while it is being opened, open and read, and closed again; and the console's commands.
#pragma once

#include "app/gui/bench/dialogue_log.h"
#include "app/gui/bench/role_reader.h"

#include <QObject>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace straightedge::gui {

class JobRunner;

/// GUI thread. Instruments are touched by jobs (opening, closing) and by a thread of the RoleReader.
class BenchOpener : public QObject {
  Q_OBJECT
public:
  enum class State : std::uint8_t { Closed, Opening, Open };

  /// `kind` tells this opener's jobs from another's: "angle". `lister` finds devices; listDevices() if it is empty.
  BenchOpener(JobRunner& jobs, const QString& kind, devices::DeviceLister lister = {}, QObject* parent = nullptr);
  ~BenchOpener() override;

  State state() const { return m_state; }
  void open(const devices::SavedBench& bench, const devices::ProfileSet& profiles);
  void cancel(); ///< of opening
  void close();  ///< at once as the window sees it; the instruments are given back by a job

  const std::shared_ptr<devices::OpenedBench>& bench() const { return m_bench; } ///< null unless open
  const std::optional<Error>& problem() const { return m_problem; }              ///< of the last try to open
  void forgetProblem();

  /// Live reading of every role while open, not during a capture.
  void setShown(bool shown);
  void setCapturing(bool capturing);
  const RoleState* role(devices::InstrumentRole role) const; ///< null: not read (yet)

  DialogueLog& dialogue() const { return *m_dialogue; }
  bool canSay() const { return m_state == State::Open && !m_capturing; }
  void say(std::size_t instrument, const std::string& bytes);

signals:
  void stateChanged();
  void opened(const std::shared_ptr<devices::OpenedBench>& bench);
  void closed(); ///< whoever has the bench lets go of it
  void rolesRead();
  void angleRead(double encoderDeg, double sensorDeg); ///< of the same round, where both were read
  void angleLost();                                    ///< one of them was read before and could not be now
  void said(int instrument, const QString& problem);   ///< empty: it was sent, and what was answered is in the dialogue

private:
  struct Gate;
  void setState(State state);
  void take(std::shared_ptr<devices::OpenedBench> bench);
  void takeRoles(std::vector<RoleState> states);
  void updateReading();

  JobRunner& m_jobs;
  const QString m_openKey;
  const devices::DeviceLister m_lister;
  const std::shared_ptr<Gate> m_gate;
  const std::shared_ptr<DialogueLog> m_dialogue = std::make_shared<DialogueLog>();
  State m_state = State::Closed;
  std::shared_ptr<devices::OpenedBench> m_bench;
  std::unique_ptr<RoleReader> m_reader;
  std::vector<RoleState> m_roles;
  std::optional<Error> m_problem;
  bool m_angleShown = false;
  bool m_shown = false;
  bool m_capturing = false;
  int m_closings = 0;
};

} // namespace straightedge::gui
