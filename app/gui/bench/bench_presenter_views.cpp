// What the presenter shows of devices and roles.
#include "app/gui/bench/bench_presenter.h"
#include "app/gui/bench/device_words.h"

#include <algorithm>

namespace straightedge::gui {

std::vector<BenchPresenter::DeviceRow> BenchPresenter::deviceRows() const {
  std::vector<DeviceRow> rows;
  for (const devices::ListedDevice& device : devices()) {
    DeviceRow row;
    row.title = deviceTitle(device);
    row.where = deviceWhere(device);
    row.use = deviceUse(device, m_draft.roles());
    row.caution = device.instrument.empty() ? QString() : instrumentCaution(device.instrument, m_draft.profiles());
    row.problem = QString::fromStdString(device.problem);
    row.remedy = QString::fromStdString(device.remedy);
    row.useful =
        std::ranges::any_of(m_draft.roles(), [&](const RoleSlot& slot) { return m_draft.mayFill(slot.role, device); });
    QStringList fills;
    for (const devices::BenchInstrument& one : m_draft.bench().instruments) {
      for (const devices::InstrumentRole role : one.roles) {
        if (const RoleSlot* slot = slotOf(role); slot != nullptr && BenchDraft::isSame(one, device)) {
          fills << slot->title;
        }
      }
    }
    if (!fills.isEmpty()) {
      row.use = tr("Used as: %1").arg(fills.join(QStringLiteral(", ")));
      if (m_opener.state() == BenchOpener::State::Open) { // held by this program: no problem
        row.problem.clear();
        row.remedy.clear();
      }
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

QString BenchPresenter::devicesNote() const {
  if (!m_watch.hasLooked()) {
    return tr("Looking at what is plugged in…");
  }
  if (m_watch.problem()) {
    return plainMessage(*m_watch.problem());
  }
  return devices().empty()
             ? tr("Nothing is plugged in, or this computer has no USB. An instrument appears here as soon "
                  "as it is plugged in. The simulated bench works without any.")
             : QString();
}

BenchPresenter::RoleView BenchPresenter::roleView(const RoleSlot& slot) const {
  RoleView view;
  view.slot = slot;
  view.choices.push_back({tr("Nobody"), -1});
  const devices::BenchInstrument* filling = m_draft.filling(slot.role);
  view.filled = filling != nullptr;
  for (std::size_t i = 0; i < devices().size(); ++i) {
    const devices::ListedDevice& device = devices()[i];
    const bool fills = filling != nullptr && BenchDraft::isSame(*filling, device);
    if (fills || m_draft.mayFill(slot.role, device)) {
      view.chosen = fills ? static_cast<int>(view.choices.size()) : view.chosen;
      const QString where =
          device.serial.empty() ? QString() : QStringLiteral(" ") + QString::fromStdString(device.serial);
      view.choices.push_back({deviceTitle(device) + where, static_cast<int>(i)});
    }
  }
  if (filling == nullptr) {
    return view;
  }
  if (view.chosen == 0) {
    const std::string& mark = filling->serial.empty() ? filling->port : filling->serial;
    view.choices.push_back(
        {tr("%1 %2 (not plugged in)")
             .arg(instrumentTitle(filling->instrument, m_draft.profiles()), QString::fromStdString(mark)),
         -2});
    view.chosen = static_cast<int>(view.choices.size()) - 1;
  }
  for (const std::string& id : m_draft.choices(slot.role, devices())) {
    view.instrument = id == filling->instrument ? static_cast<int>(view.instruments.size()) : view.instrument;
    view.instruments.push_back(instrumentTitle(id, m_draft.profiles()));
  }
  view.caution = instrumentCaution(filling->instrument, m_draft.profiles());
  view.hasSettings = true;
  if (const RoleState* state = m_opener.role(slot.role)) {
    view.value = state->reading ? roleReadingText(slot.role, *state->reading) : QString();
    view.fault = state->fault ? QString::fromStdString(state->fault->message()) : QString();
  }
  return view;
}

std::vector<BenchPresenter::RoleView> BenchPresenter::roleViews() const {
  std::vector<RoleView> views;
  for (const RoleSlot& slot : m_draft.roles()) {
    views.push_back(roleView(slot));
  }
  return views;
}

std::vector<devices::InstrumentRole> BenchPresenter::rolesFor(int device) const {
  std::vector<devices::InstrumentRole> roles;
  const auto index = static_cast<std::size_t>(device);
  for (const RoleSlot& slot : m_draft.roles()) {
    if (device >= 0 && index < devices().size() && m_draft.mayFill(slot.role, devices()[index])) {
      roles.push_back(slot.role);
    }
  }
  return roles;
}

} // namespace straightedge::gui
