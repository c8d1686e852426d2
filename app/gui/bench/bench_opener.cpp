#include "app/gui/bench/bench_opener.h"

#include "app/gui/jobs/job_runner.h"

#include <algorithm>
#include <utility>

namespace straightedge::gui {

/// Instruments are opened after those of the bench before were given back: one at a time holds them.
struct BenchOpener::Gate {
  std::mutex mutex;
  std::condition_variable_any changed;
  int held = 0; ///< benches that are being opened or closed

  bool enter(const std::stop_token& stop) {
    std::unique_lock lock(mutex);
    const bool free = changed.wait(lock, stop, [this] { return held == 0; });
    held += free ? 1 : 0;
    return free;
  }
  void add() {
    const std::lock_guard lock(mutex);
    ++held;
  }
  void leave() {
    const std::lock_guard lock(mutex);
    --held;
    changed.notify_all();
  }
};

BenchOpener::BenchOpener(JobRunner& jobs, const QString& kind, devices::DeviceLister lister, QObject* parent)
    : QObject(parent), m_jobs(jobs), m_openKey(QStringLiteral("open-bench-") + kind), m_lister(std::move(lister)),
      m_gate(std::make_shared<Gate>()) {
  connect(&jobs, &JobRunner::jobEnded, this, [this](const QString& key, bool cancelled) {
    if (key == m_openKey && cancelled && m_state == State::Opening) {
      setState(State::Closed);
    }
  });
}

BenchOpener::~BenchOpener() {
  if (m_reader) {
    m_reader->silence();
  }
}

void BenchOpener::setState(State state) {
  if (std::exchange(m_state, state) != state) {
    emit stateChanged();
  }
}

void BenchOpener::open(const devices::SavedBench& bench, const devices::ProfileSet& profiles) {
  if (m_state != State::Closed) {
    return;
  }
  m_problem.reset();
  m_dialogue->clear();
  setState(State::Opening);
  using Opened = std::shared_ptr<devices::OpenedBench>;
  m_jobs.run<Opened>(
      m_openKey, tr("Opening the instruments"),
      [bench, profiles, lister = m_lister, gate = m_gate,
       log = m_dialogue](const JobControl& control) -> Result<Opened> {
        const Error taken{ErrorKind::Instrument, "opening was cancelled", "connect again", bench.name};
        if (!gate->enter(control.stop)) {
          return std::unexpected(taken);
        }
        const std::shared_ptr<void> inside(nullptr, [gate](void*) { gate->leave(); });
        auto opened = devices::OpenedBench::open(bench, profiles, lister,
                                                 [log](const devices::BenchExchange& said) { log->add(said); });
        if (!opened) {
          return std::unexpected(std::move(opened.error()));
        }
        if (control.stopRequested()) { // nobody would close it
          opened->reset();
          return std::unexpected(taken);
        }
        return Opened(*std::move(opened));
      },
      [this](Result<Opened> result) {
        if (result) {
          take(*std::move(result));
        } else {
          m_problem = std::move(result.error());
          setState(State::Closed);
        }
      });
}

void BenchOpener::cancel() {
  if (m_state == State::Opening) {
    m_jobs.cancel(m_openKey);
    setState(State::Closed);
  }
}

void BenchOpener::take(std::shared_ptr<devices::OpenedBench> bench) {
  m_bench = std::move(bench);
  m_roles.clear();
  setState(State::Open);
  emit opened(m_bench); // asks for the roles, before another thread uses the bench
  if (m_state != State::Open) {
    return; // whoever heard it could not use the bench
  }
  m_reader = std::make_unique<RoleReader>(
      m_bench, RoleReader::Listener{
                   .read =
                       [this](std::vector<RoleState> states) {
                         QMetaObject::invokeMethod(
                             this, [this, states = std::move(states)] { takeRoles(states); }, Qt::QueuedConnection);
                       },
                   .said =
                       [this](std::size_t instrument, const Result<std::string>& answer) {
                         const QString problem = answer ? QString() : QString::fromStdString(answer.error().message());
                         QMetaObject::invokeMethod(
                             this, [this, instrument, problem] { emit said(static_cast<int>(instrument), problem); },
                             Qt::QueuedConnection);
                       }});
  updateReading();
}

void BenchOpener::close() {
  cancel();
  if (m_state != State::Open) {
    return;
  }
  if (m_reader) {
    m_reader->silence();
  }
  m_roles.clear();
  setState(State::Closed);
  emit closed();
  emit rolesRead();
  // The reading in hand may last until its instrument answers or its deadline passes; so may giving them back.
  struct Leaving {
    std::unique_ptr<RoleReader> reader;
    std::shared_ptr<devices::OpenedBench> bench;
    std::shared_ptr<Gate> gate;
    ~Leaving() {
      reader.reset();
      bench.reset();
      gate->leave();
    }
  };
  m_gate->add();
  auto leaving = std::make_shared<std::unique_ptr<Leaving>>(
      std::make_unique<Leaving>(std::move(m_reader), std::move(m_bench), m_gate));
  m_jobs.run<int>(
      QStringLiteral("close-%1-%2").arg(m_openKey).arg(++m_closings), tr("Closing the instruments"),
      [leaving](const JobControl&) -> Result<int> {
        leaving->reset();
        return 0;
      },
      [](const Result<int>&) {});
}

void BenchOpener::forgetProblem() { m_problem.reset(); }

void BenchOpener::setShown(bool shown) {
  m_shown = shown;
  updateReading();
}

void BenchOpener::setCapturing(bool capturing) {
  if (std::exchange(m_capturing, capturing) != capturing) {
    updateReading();
    emit stateChanged();
  }
}

void BenchOpener::updateReading() {
  if (m_reader) {
    m_reader->setReading(m_shown && !m_capturing);
  }
}

const RoleState* BenchOpener::role(devices::InstrumentRole role) const {
  const auto found = std::ranges::find(m_roles, role, &RoleState::role);
  return found == m_roles.end() ? nullptr : &*found;
}

void BenchOpener::takeRoles(std::vector<RoleState> states) {
  if (m_state != State::Open || m_capturing) {
    return; // sent before that
  }
  m_roles = std::move(states);
  emit rolesRead();
  const auto angle = [this](devices::InstrumentRole wanted) {
    const RoleState* state = role(wanted);
    return state != nullptr && state->reading && !state->reading->values.empty()
               ? std::optional(state->reading->values.front())
               : std::nullopt;
  };
  const auto encoder = angle(devices::InstrumentRole::AngleReference);
  const auto sensor = angle(devices::InstrumentRole::AngleSensor);
  if (encoder && sensor) {
    m_angleShown = true;
    emit angleRead(*encoder, *sensor);
  } else if (std::exchange(m_angleShown, false)) {
    emit angleLost();
  }
}

void BenchOpener::say(std::size_t instrument, const std::string& bytes) {
  if (canSay() && m_reader) {
    m_reader->say(instrument, bytes);
  }
}

} // namespace straightedge::gui
