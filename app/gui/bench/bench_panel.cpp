#include "app/gui/bench/bench_panel.h"

#include "app/gui/bench/bench_colors.h"
#include "app/gui/bench/bench_console.h"
#include "app/gui/bench/device_list.h"
#include "app/gui/bench/device_words.h"
#include "app/gui/bench/instrument_settings_dialog.h"
#include "app/gui/bench/role_row.h"
#include "app/gui/bench/saved_bench_row.h"
#include "app/gui/bench/tinted_label.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QMenu>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace straightedge::gui {

namespace {

QLabel* heading(const QString& text, QWidget* buddy, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  QFont bold = label->font();
  bold.setBold(true);
  label->setFont(bold);
  label->setBuddy(buddy);
  return label;
}

} // namespace

BenchPanel::BenchPanel(BenchPresenter& presenter, QWidget* parent) : QWidget(parent), m_presenter(presenter) {
  setObjectName(QStringLiteral("benchPanel"));
  m_console = new BenchConsole(presenter, this);
  m_console->hide();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(new SavedBenchRow(presenter, this));
  layout->addWidget(makeDevices());
  layout->addWidget(makeRoles());
  layout->addWidget(makePairing());
  m_problem = new TintedLabel(faultColor, this);
  m_problem->setObjectName(QStringLiteral("benchProblem"));
  layout->addWidget(m_problem);
  m_status = new TintedLabel([](const QPalette& palette) { return palette.color(QPalette::WindowText); }, this);
  m_status->setObjectName(QStringLiteral("instrumentsStatus"));
  layout->addWidget(m_status);
  auto* buttons = new QHBoxLayout;
  m_connect = new QPushButton(this);
  m_connect->setObjectName(QStringLiteral("openBench"));
  m_showConsole = new QPushButton(tr("Console"), this);
  m_showConsole->setObjectName(QStringLiteral("showConsole"));
  m_showConsole->setCheckable(true);
  m_showConsole->setToolTip(tr("What is said with the instruments (Ctrl+K)"));
  buttons->addWidget(m_connect);
  buttons->addStretch(1);
  buttons->addWidget(m_showConsole);
  layout->addLayout(buttons);
  connectPresenter();
  showDevices();
  showRoles();
  showPairing();
  showState();
  showProblem();
}

QWidget* BenchPanel::makeDevices() {
  auto* box = new QWidget(this);
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  m_devices = new DeviceList(box);
  m_devices->setObjectName(QStringLiteral("devices"));
  m_devicesNote = new TintedLabel(quietColor, box);
  m_devicesNote->setObjectName(QStringLiteral("devicesNote"));
  m_deviceWhere = new TintedLabel(quietColor, box);
  m_deviceWhere->setObjectName(QStringLiteral("deviceWhere"));
  m_deviceProblem = new TintedLabel(faultColor, box);
  m_deviceProblem->setObjectName(QStringLiteral("deviceProblem"));
  m_copyCommand = new QPushButton(tr("Copy the command"), box);
  m_copyCommand->setObjectName(QStringLiteral("copyCommand"));
  layout->addWidget(heading(tr("Plugged &in"), m_devices, box));
  layout->addWidget(m_devicesNote);
  layout->addWidget(m_devices);
  layout->addWidget(m_deviceWhere);
  layout->addWidget(m_deviceProblem);
  auto* row = new QHBoxLayout;
  row->addWidget(m_copyCommand);
  row->addStretch(1);
  layout->addLayout(row);
  return box;
}

QWidget* BenchPanel::makeRoles() {
  auto* box = new QWidget(this);
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(heading(tr("Roles: drag a device here, or choose one"), nullptr, box));
  for (const RoleSlot& slot : m_presenter.draft().roles()) {
    auto* row = new RoleRow(slot, box);
    m_roles.push_back(row);
    layout->addWidget(row);
    const devices::InstrumentRole role = slot.role;
    connect(row, &RoleRow::deviceDropped, this,
            [this, role](const QString& key) { m_presenter.assign(role, deviceOf(key)); });
    connect(row, &RoleRow::deviceChosen, this, [this, role](int device) {
      if (device == -1) {
        m_presenter.clear(role);
      } else {
        m_presenter.assign(role, device);
      }
    });
    connect(row, &RoleRow::instrumentChosen, this,
            [this, role](int index) { m_presenter.chooseInstrument(role, index); });
    connect(row, &RoleRow::settingsWanted, this, [this, role] { openSettings(role); });
  }
  return box;
}

QWidget* BenchPanel::makePairing() {
  m_pairing = new QWidget(this);
  auto* layout = new QHBoxLayout(m_pairing);
  layout->setContentsMargins(0, 0, 0, 0);
  m_pairingRule = new QComboBox(m_pairing);
  m_pairingRule->setObjectName(QStringLiteral("pairingRule"));
  m_pairingRule->addItem(tr("one after the other"), static_cast<int>(devices::PairingKind::AsRead));
  m_pairingRule->addItem(tr("interpolated to the encoder's time"), static_cast<int>(devices::PairingKind::Interpolate));
  m_pairingRule->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_pairingRule->setMinimumContentsLength(16);
  m_pairingRule->setToolTip(tr("How a reading of the sensor and one of the encoder become a pair.\n"
                               "One after the other suits a shaft that stands; interpolated needs readings before and "
                               "after the encoder's, not older than the time beside."));
  m_pairingAge = new QDoubleSpinBox(m_pairing);
  m_pairingAge->setObjectName(QStringLiteral("pairingAge"));
  m_pairingAge->setRange(0.001, 60.0);
  m_pairingAge->setDecimals(3);
  m_pairingAge->setSuffix(tr(" s"));
  m_pairingAge->setToolTip(tr("A sensor reading older than this makes no pair"));
  layout->addWidget(heading(tr("&Pairing"), m_pairingRule, m_pairing));
  layout->addWidget(m_pairingRule, 1);
  layout->addWidget(m_pairingAge);
  bool hasEncoder = false;
  for (const RoleSlot& slot : m_presenter.draft().roles()) {
    hasEncoder = hasEncoder || slot.role == devices::InstrumentRole::AngleReference;
  }
  m_pairing->setVisible(hasEncoder); // a field calibration's plan has rules of its own
  const auto edited = [this] {
    m_presenter.setPairing(
        {static_cast<devices::PairingKind>(m_pairingRule->currentData().toInt()), m_pairingAge->value()});
    showState();
  };
  connect(m_pairingRule, &QComboBox::activated, this, edited);
  connect(m_pairingAge, &QDoubleSpinBox::valueChanged, this, edited);
  return m_pairing;
}

void BenchPanel::connectPresenter() {
  connect(&m_presenter, &BenchPresenter::devicesChanged, this, &BenchPanel::showDevices);
  connect(&m_presenter, &BenchPresenter::rolesChanged, this, &BenchPanel::showRoles);
  connect(&m_presenter, &BenchPresenter::rolesRead, this, &BenchPanel::showReadings);
  connect(&m_presenter, &BenchPresenter::savedChanged, this, &BenchPanel::showPairing);
  connect(&m_presenter, &BenchPresenter::stateChanged, this, &BenchPanel::showState);
  connect(&m_presenter, &BenchPresenter::problemChanged, this, &BenchPanel::showProblem);
  connect(m_devices, &QListWidget::currentRowChanged, this, &BenchPanel::showDevice);
  connect(m_devices, &DeviceList::menuWanted, this, &BenchPanel::openMenu);
  connect(m_copyCommand, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(m_command); });
  connect(m_connect, &QPushButton::clicked, this, [this] {
    switch (m_presenter.opener().state()) {
    case BenchOpener::State::Closed:
      m_presenter.open();
      return;
    case BenchOpener::State::Opening:
      m_presenter.opener().cancel();
      return;
    case BenchOpener::State::Open:
      m_presenter.close();
      return;
    }
  });
  connect(m_showConsole, &QPushButton::toggled, m_console, &QWidget::setVisible);
  auto* key = new QShortcut(QKeySequence(Qt::CTRL | Qt::Key_K), this);
  connect(key, &QShortcut::activated, m_showConsole, &QPushButton::toggle);
}

int BenchPanel::deviceOf(const QString& key) const {
  for (std::size_t i = 0; i < m_presenter.devices().size(); ++i) {
    if (deviceKey(m_presenter.devices()[i]) == key) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

void BenchPanel::showDevices() {
  QStringList keys;
  for (const devices::ListedDevice& device : m_presenter.devices()) {
    keys << deviceKey(device);
  }
  m_devices->setDevices(m_presenter.deviceRows(), keys);
  m_devices->setVisible(!keys.isEmpty());
  m_devicesNote->setTextOrHide(m_presenter.devicesNote());
  showDevice();
}

void BenchPanel::showDevice() {
  const std::vector<BenchPresenter::DeviceRow> rows = m_presenter.deviceRows();
  const auto index = static_cast<std::size_t>(m_devices->currentRow());
  if (m_devices->currentRow() < 0 || index >= rows.size()) {
    m_deviceWhere->setTextOrHide({});
    m_deviceProblem->setTextOrHide({});
    m_copyCommand->hide();
    return;
  }
  const BenchPresenter::DeviceRow& row = rows[index];
  m_deviceWhere->setTextOrHide(row.where + (row.caution.isEmpty() ? QString() : QLatin1Char('\n') + row.caution));
  m_deviceProblem->setTextOrHide(
      row.problem.isEmpty() ? QString() : tr("Cannot be opened: %1. To mend it, %2.").arg(row.problem, row.remedy));
  m_command = commandIn(row.remedy).value_or(QString());
  m_copyCommand->setText(tr("Copy “%1”").arg(m_command));
  m_copyCommand->setVisible(!row.problem.isEmpty() && !m_command.isEmpty());
}

void BenchPanel::showRoles() {
  const std::vector<BenchPresenter::RoleView> views = m_presenter.roleViews();
  for (std::size_t i = 0; i < views.size(); ++i) {
    m_roles[i]->showRole(views[i], m_presenter.mayEdit());
  }
}

void BenchPanel::showReadings() {
  const std::vector<BenchPresenter::RoleView> views = m_presenter.roleViews();
  for (std::size_t i = 0; i < views.size(); ++i) {
    m_roles[i]->showReading(views[i]);
  }
}

void BenchPanel::showPairing() {
  const devices::PairingRule& rule = m_presenter.draft().bench().pairing;
  const QSignalBlocker quietRule(m_pairingRule);
  const QSignalBlocker quietAge(m_pairingAge);
  m_pairingRule->setCurrentIndex(m_pairingRule->findData(static_cast<int>(rule.kind)));
  m_pairingAge->setValue(rule.maxAgeS);
  showState();
}

void BenchPanel::showState() {
  const bool edits = m_presenter.mayEdit();
  m_pairing->setEnabled(edits);
  m_pairingAge->setEnabled(m_presenter.draft().bench().pairing.kind == devices::PairingKind::Interpolate);
  const BenchOpener::State state = m_presenter.opener().state();
  m_connect->setText(state == BenchOpener::State::Closed    ? tr("&Connect")
                     : state == BenchOpener::State::Opening ? tr("&Cancel")
                                                            : tr("&Disconnect"));
  m_connect->setEnabled(m_presenter.mayClose());
  m_connect->setDefault(state == BenchOpener::State::Closed);
  m_status->setTextOrHide(m_presenter.statusText());
}

void BenchPanel::showProblem() { m_problem->setTextOrHide(m_presenter.problem()); }

void BenchPanel::openMenu(int device, const QPoint& globalPosition) {
  const std::vector<BenchPresenter::DeviceRow> rows = m_presenter.deviceRows();
  if (device < 0 || static_cast<std::size_t>(device) >= rows.size()) {
    return;
  }
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("deviceMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const QString key = deviceKey(m_presenter.devices()[static_cast<std::size_t>(device)]);
  for (const devices::InstrumentRole role : m_presenter.rolesFor(device)) {
    for (const RoleSlot& slot : m_presenter.draft().roles()) {
      if (slot.role == role) {
        QAction* use = menu->addAction(tr("Use as: %1").arg(slot.title), this,
                                       [this, role, key] { m_presenter.assign(role, deviceOf(key)); });
        use->setEnabled(m_presenter.mayEdit());
      }
    }
  }
  menu->addSeparator();
  menu->addAction(tr("Copy its address"), this, [where = rows[static_cast<std::size_t>(device)].where] {
    QGuiApplication::clipboard()->setText(where);
  });
  if (const auto command = commandIn(rows[static_cast<std::size_t>(device)].remedy)) {
    menu->addAction(tr("Copy “%1”").arg(*command), this,
                    [text = *command] { QGuiApplication::clipboard()->setText(text); });
  }
  menu->popup(globalPosition);
}

void BenchPanel::openSettings(devices::InstrumentRole role) {
  const devices::BenchInstrument* filling = m_presenter.draft().filling(role);
  if (filling == nullptr) {
    return;
  }
  auto* dialog = new InstrumentSettingsDialog(*filling, m_presenter.draft().profiles(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this,
          [this, role, dialog] { m_presenter.setInstrument(role, dialog->instrument()); });
  dialog->open();
}

} // namespace straightedge::gui
