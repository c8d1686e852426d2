#include "app/gui/bench/bench_presenter.h"

#include "app/gui/bench/device_words.h"
#include "devices/bench/bench_folder.h"

#include <QSettings>

#include <algorithm>

namespace straightedge::gui {

namespace {

devices::DeviceLister listerOr(const devices::DeviceLister& lister, const devices::ProfileSet& profiles) {
  return lister ? lister : [profiles] { return devices::listDevices(profiles); };
}

} // namespace

BenchPresenter::BenchPresenter(JobRunner& jobs, Options options, QObject* parent)
    : QObject(parent), m_kind(options.kind),
      m_draft(std::move(options.roles), devices::readProfiles(devices::userProfileFolder())),
      m_watch(listerOr(options.lister, m_draft.profiles()), options.byEvents),
      m_opener(jobs, options.kind, listerOr(options.lister, m_draft.profiles())) {
  connect(&m_watch, &DeviceWatch::changed, this, [this] {
    emit devicesChanged();
    emit rolesChanged(); // what may fill them
  });
  connect(&m_opener, &BenchOpener::rolesRead, this, &BenchPresenter::rolesRead);
  connect(&m_opener, &BenchOpener::stateChanged, this, [this] {
    const std::optional<Error>& failed = m_opener.problem();
    if (m_opener.state() == BenchOpener::State::Closed && failed) {
      setProblem(QString::fromStdString(failed->message()));
      m_opener.forgetProblem();
      m_watch.lookNow(); // what kept it from opening may be seen from outside, too
    }
    emit stateChanged();
    emit devicesChanged();
    emit rolesChanged();
    emit savedChanged();
  });
  readSaved();
  const QString last = QSettings().value(QStringLiteral("bench/") + m_kind).toString();
  if (m_saved.contains(last)) {
    load(last);
  }
}

void BenchPresenter::setProblem(const QString& problem) {
  if (problem != m_problem) {
    m_problem = problem;
    emit problemChanged();
  }
}

void BenchPresenter::changed() {
  setProblem({});
  emit devicesChanged(); // which role each fills
  emit rolesChanged();
  emit savedChanged();
}

const RoleSlot* BenchPresenter::slotOf(devices::InstrumentRole role) const {
  const auto found = std::ranges::find(m_draft.roles(), role, &RoleSlot::role);
  return found == m_draft.roles().end() ? nullptr : &*found;
}

void BenchPresenter::assign(devices::InstrumentRole role, int device) {
  const auto index = static_cast<std::size_t>(device);
  if (!mayEdit() || device < 0 || index >= devices().size()) {
    return;
  }
  const Result<void> assigned = m_draft.assign(role, devices()[index]);
  changed();
  if (!assigned) {
    setProblem(plainMessage(assigned.error()));
  }
}

void BenchPresenter::clear(devices::InstrumentRole role) {
  if (mayEdit()) {
    m_draft.clear(role);
    changed();
  }
}

void BenchPresenter::chooseInstrument(devices::InstrumentRole role, int index) {
  const std::vector<std::string> ids = m_draft.choices(role, devices());
  if (mayEdit() && index >= 0 && static_cast<std::size_t>(index) < ids.size()) {
    m_draft.chooseInstrument(role, ids[static_cast<std::size_t>(index)]);
    changed();
  }
}

void BenchPresenter::setInstrument(devices::InstrumentRole role, const devices::BenchInstrument& changedInstrument) {
  if (mayEdit()) {
    m_draft.setInstrument(role, changedInstrument);
    changed();
  }
}

void BenchPresenter::setPairing(const devices::PairingRule& rule) {
  if (mayEdit() && !(m_draft.bench().pairing == rule)) {
    m_draft.setPairing(rule);
    emit savedChanged();
  }
}

QString BenchPresenter::benchName() const { return QString::fromStdString(m_draft.bench().name); }

bool BenchPresenter::isChanged() const { return !(m_draft.bench() == m_asSaved); }

void BenchPresenter::readSaved() {
  m_saved.clear();
  for (const std::string& name : devices::savedBenchNames()) {
    const auto bench = devices::readBench(name);
    // One that cannot be read is offered all the same: choosing it says what is wrong with its file.
    const bool fits = !bench || std::ranges::any_of(m_draft.roles(), [&](const RoleSlot& slot) {
      return slot.needed && bench->filling(slot.role) != nullptr;
    });
    if (fits) {
      m_saved << QString::fromStdString(name);
    }
  }
}

void BenchPresenter::remember(const QString& name) { QSettings().setValue(QStringLiteral("bench/") + m_kind, name); }

void BenchPresenter::load(const QString& name) {
  if (!mayEdit()) {
    return;
  }
  auto bench = devices::readBench(name.toStdString());
  if (!bench) {
    emit savedChanged(); // the list shows again what is loaded
    setProblem(QString::fromStdString(bench.error().message()));
    return;
  }
  bench->name = name.toStdString(); // the file's: by that it is found again
  m_draft.setBench(*std::move(bench));
  m_asSaved = m_draft.bench();
  remember(name);
  changed();
}

void BenchPresenter::startAnew() {
  if (mayEdit()) {
    m_draft.setBench({});
    m_asSaved = {};
    remember({});
    changed();
  }
}

bool BenchPresenter::save(const QString& name) {
  devices::SavedBench bench = m_draft.bench();
  bench.name = name.trimmed().toStdString();
  if (bench.instruments.empty()) {
    setProblem(tr("The bench has no instruments yet; fill a role first"));
    return false;
  }
  if (const auto checked = devices::saveBench(bench); !checked) {
    setProblem(plainMessage(checked.error()));
    return false;
  }
  m_draft.setBench(bench);
  m_asSaved = std::move(bench);
  remember(name.trimmed());
  readSaved();
  changed();
  return true;
}

void BenchPresenter::deleteSaved(const QString& name) {
  if (const auto deleted = devices::deleteBench(name.toStdString()); !deleted) {
    setProblem(plainMessage(deleted.error()));
    return;
  }
  if (name == benchName()) {
    m_draft.setName({}); // the roles stay as they are, unsaved
    m_asSaved = {};
    remember({});
  }
  readSaved();
  changed();
}

void BenchPresenter::open() {
  if (m_opener.state() != BenchOpener::State::Closed) {
    return;
  }
  if (const Result<void> checked = m_draft.check(); !checked) {
    setProblem(plainMessage(checked.error()));
    return;
  }
  setProblem({});
  devices::SavedBench bench = m_draft.bench();
  if (bench.name.empty()) {
    bench.name = tr("Instruments").toStdString();
  }
  m_opener.open(bench, m_draft.profiles());
}

void BenchPresenter::close() {
  setProblem({});
  m_opener.close();
}

QString BenchPresenter::statusText() const {
  switch (m_opener.state()) {
  case BenchOpener::State::Opening:
    return tr("Opening the instruments…");
  case BenchOpener::State::Open:
    return m_capturing ? tr("Capturing; the instruments belong to the capture until it ends.")
                       : tr("Connected. Each role shows what its instrument reads.");
  case BenchOpener::State::Closed:
    break;
  }
  return tr("Not connected. Fill the roles, then connect.");
}

void BenchPresenter::setShown(bool shown) {
  m_watch.setWatching(shown);
  m_opener.setShown(shown);
}

void BenchPresenter::setCapturing(bool capturing) {
  m_capturing = capturing;
  m_opener.setCapturing(capturing);
}

} // namespace straightedge::gui
