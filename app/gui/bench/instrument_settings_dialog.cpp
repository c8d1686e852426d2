#include "app/gui/bench/instrument_settings_dialog.h"

#include "app/gui/bench/bench_colors.h"
#include "app/gui/bench/device_words.h"
#include "app/gui/bench/tinted_label.h"
#include "devices/bench/bench_check.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QIntValidator>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace straightedge::gui {

namespace {

QString fromView(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())); }

constexpr double msPerS = 1000.0;

} // namespace

InstrumentSettingsDialog::InstrumentSettingsDialog(devices::BenchInstrument instrument,
                                                   const devices::ProfileSet& profiles, QWidget* parent)
    : QDialog(parent), m_before(std::move(instrument)), m_profiles(profiles) {
  setObjectName(QStringLiteral("instrumentSettings"));
  setWindowTitle(tr("Settings of %1").arg(instrumentTitle(m_before.instrument, m_profiles)));
  auto* layout = new QVBoxLayout(this);
  if (const QString caution = instrumentCaution(m_before.instrument, m_profiles); !caution.isEmpty()) {
    auto* label = new TintedLabel(warningColor, this);
    label->setText(caution);
    layout->addWidget(label);
  }
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  addSettings(*form);
  addLine(*form);
  layout->addLayout(form);
  m_problem = new TintedLabel(faultColor, this);
  m_problem->setObjectName(QStringLiteral("settingsProblem"));
  layout->addWidget(m_problem);
  layout->addStretch(1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  m_ok = buttons->button(QDialogButtonBox::Ok);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  setMinimumWidth(fontMetrics().averageCharWidth() * 70);
  check();
}

void InstrumentSettingsDialog::addSettings(QFormLayout& form) {
  const devices::KnownInstrument* known = devices::knownInstrument(m_before.instrument);
  if (known == nullptr || known->settings == nullptr) {
    return; // a profile's settings are in its file
  }
  for (const devices::SettingDescription& setting : known->settings()) {
    const std::string key(setting.key);
    const auto given = m_before.settings.find(setting.key);
    const QString fallback = fromView(setting.fallback);
    const QString value = given == m_before.settings.end() ? fallback : QString::fromStdString(given->second);
    m_defaults[key] = fallback;
    QWidget* field = nullptr;
    if (setting.choices.empty()) {
      auto* edit = new QLineEdit(value, this);
      m_fields[key] = [edit] { return edit->text().trimmed(); };
      connect(edit, &QLineEdit::textChanged, this, &InstrumentSettingsDialog::check);
      field = edit;
    } else {
      auto* choice = new QComboBox(this);
      for (const std::string_view one : setting.choices) {
        choice->addItem(fromView(one));
      }
      choice->setCurrentText(value);
      m_fields[key] = [choice] { return choice->currentText(); };
      connect(choice, &QComboBox::currentIndexChanged, this, &InstrumentSettingsDialog::check);
      field = choice;
    }
    field->setObjectName(QStringLiteral("setting-") + fromView(setting.key));
    field->setToolTip(fromView(setting.help));
    field->setWhatsThis(fromView(setting.help));
    form.addRow(fromView(setting.label), field);
  }
}

void InstrumentSettingsDialog::addLine(QFormLayout& form) {
  const devices::KnownInstrument* known = devices::knownInstrument(m_before.instrument);
  const devices::Profile* profile = devices::findProfile(m_profiles, m_before.instrument);
  const auto line = known != nullptr     ? known->serial
                    : profile != nullptr ? profile->serial
                                         : std::optional<devices::SerialSettings>();
  if (line) {
    m_baud = new QComboBox(this);
    m_baud->setObjectName(QStringLiteral("baud"));
    m_baud->setEditable(true);
    m_baud->setValidator(new QIntValidator(50, 12'000'000, m_baud));
    m_baud->addItem(tr("as delivered (%1)").arg(line->baud), 0);
    for (const int baud : {9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600}) {
      m_baud->addItem(QString::number(baud), baud);
    }
    if (m_before.baud) {
      m_baud->setEditText(QString::number(*m_before.baud));
    }
    connect(m_baud, &QComboBox::editTextChanged, this, &InstrumentSettingsDialog::check);
    form.addRow(tr("Baud rate"), m_baud);
  }
  m_latency = new QDoubleSpinBox(this);
  m_latency->setObjectName(QStringLiteral("latency"));
  m_latency->setRange(0.0, 60.0 * msPerS);
  m_latency->setDecimals(3);
  m_latency->setSuffix(tr(" ms"));
  m_latency->setValue(m_before.latencyS * msPerS);
  m_latency->setToolTip(tr("From measuring to the time stamp, beside what the driver knows itself"));
  form.addRow(tr("Latency"), m_latency);
}

devices::BenchInstrument InstrumentSettingsDialog::instrument() const {
  devices::BenchInstrument now = m_before;
  now.settings.clear();
  for (const auto& [key, text] : m_fields) {
    if (const QString value = text(); value != m_defaults.at(key)) {
      now.settings[key] = value.toStdString();
    }
  }
  now.baud.reset();
  if (m_baud != nullptr) {
    bool isNumber = false;
    if (const int baud = m_baud->currentText().toInt(&isNumber); isNumber) {
      now.baud = baud;
    }
  }
  now.latencyS = m_latency->value() / msPerS;
  return now;
}

void InstrumentSettingsDialog::check() {
  if (m_ok == nullptr) {
    return; // the form is being made
  }
  const Result<void> checked = devices::checkBenchInstrument(instrument(), m_profiles);
  m_problem->setTextOrHide(checked ? QString() : QString::fromStdString(checked.error().message()));
  m_ok->setEnabled(checked.has_value());
}

} // namespace straightedge::gui
