#include "app/gui/shell/details_dialog.h"

#include "core/base/number_text.h"

#include <QDate>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace straightedge::gui {

namespace {

/// A number as people type it: a comma is a decimal mark too.
std::optional<double> numberIn(const QLineEdit& field) {
  QString text = field.text().trimmed();
  const auto value = parseDouble(text.replace(',', '.').toStdString());
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::string textIn(const QLineEdit& field) { return field.text().trimmed().toStdString(); }

} // namespace

DetailsDialog::DetailsDialog(const Traceability& traceability, ReferenceUnit unit, QWidget* parent)
    : QDialog(parent), m_unit(std::move(unit)) {
  setObjectName("detailsDialog");
  setWindowTitle(tr("Details"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(18, 16, 18, 16);
  layout->setSpacing(12);
  auto* intro = new QLabel(tr("These details are written into every result and report."), this);
  intro->setForegroundRole(QPalette::PlaceholderText);
  layout->addWidget(intro);

  auto* device = addGroup(tr("Sensor under calibration"));
  m_serial = addText(*device, tr("&Serial number"), traceability.deviceSerial, "deviceSerial");
  m_model = addText(*device, tr("&Model"), traceability.deviceModel, "deviceModel");

  auto* reference = addGroup(tr("Reference instrument"));
  const auto& instrument = traceability.reference;
  m_referenceModel = addText(*reference, tr("M&odel"), instrument.model, "referenceModel");
  m_referenceSerial = addText(*reference, tr("S&erial number"), instrument.serial, "referenceSerial");
  m_certificate = addText(*reference, tr("&Certificate"), instrument.certificate, "certificate");
  m_due = addText(*reference, tr("Calibration &due"), instrument.due, "due");
  m_due->setPlaceholderText(tr("YYYY-MM-DD"));
  m_uncertainty =
      addText(*reference, tr("Expanded &uncertainty (%1, k = 2)").arg(m_unit.symbol),
              instrument.uncertainty > 0.0 ? formatDouble(instrument.uncertainty) : std::string(), "uncertainty");
  m_uncertainty->setPlaceholderText(tr("not stated"));

  auto* circumstances = addGroup(tr("Circumstances"));
  m_operator = addText(*circumstances, tr("O&perator"), traceability.operatorName, "operator");
  m_ambient = addText(*circumstances, tr("&Ambient temperature (°C)"),
                      traceability.ambientC ? formatDouble(*traceability.ambientC) : std::string(), "ambient");
  m_ambient->setPlaceholderText(tr("not measured"));

  m_problem = new QLabel(this);
  m_problem->setObjectName("detailsProblem");
  m_problem->setWordWrap(true);
  m_problem->setMinimumHeight(m_problem->fontMetrics().height());
  layout->addWidget(m_problem);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  m_ok = buttons->button(QDialogButtonBox::Ok);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  layout->addWidget(buttons);
  alignLabels();
  resize(460, sizeHint().height());
  check();
}

QFormLayout* DetailsDialog::addGroup(const QString& title) {
  auto* group = new QGroupBox(title, this);
  auto* form = new QFormLayout(group);
  form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  form->setLabelAlignment(Qt::AlignLeft);
  layout()->addWidget(group);
  return form;
}

void DetailsDialog::alignLabels() {
  // The groups have forms of their own; their fields should still begin at one line.
  int widest = 0;
  const auto groups = findChildren<QGroupBox*>();
  QList<QLabel*> labels;
  for (const QGroupBox* group : groups) {
    labels += group->findChildren<QLabel*>();
  }
  for (const QLabel* label : std::as_const(labels)) {
    widest = std::max(widest, label->sizeHint().width());
  }
  for (QLabel* label : std::as_const(labels)) {
    label->setMinimumWidth(widest);
  }
}

QLineEdit* DetailsDialog::addText(QFormLayout& form, const QString& label, const std::string& value, const char* name) {
  auto* field = new QLineEdit(QString::fromStdString(value), this);
  field->setObjectName(name);
  field->setMaxLength(200);
  connect(field, &QLineEdit::textChanged, this, &DetailsDialog::check);
  form.addRow(label, field);
  return field;
}

void DetailsDialog::check() {
  if (m_ok == nullptr) {
    return; // still being built
  }
  QString problem;
  if (const QString due = m_due->text().trimmed(); !due.isEmpty() && !QDate::fromString(due, Qt::ISODate).isValid()) {
    problem = tr("“Calibration due” is no date of the form YYYY-MM-DD.");
  } else if (const auto value = numberIn(*m_uncertainty);
             !m_uncertainty->text().trimmed().isEmpty() && (!value || *value < 0.0 || *value > m_unit.largest)) {
    problem = tr("“Expanded uncertainty” must be a number of %1 from 0 to %2.").arg(m_unit.name).arg(m_unit.largest);
  } else if (const auto ambient = numberIn(*m_ambient);
             !m_ambient->text().trimmed().isEmpty() && (!ambient || *ambient < -273.15 || *ambient > 1000.0)) {
    problem = tr("“Ambient temperature” must be a number of degrees Celsius from −273.15 to 1000.");
  }
  m_problem->setText(problem);
  m_ok->setEnabled(problem.isEmpty());
}

Traceability DetailsDialog::traceability() const {
  Traceability result;
  result.deviceSerial = textIn(*m_serial);
  result.deviceModel = textIn(*m_model);
  result.operatorName = textIn(*m_operator);
  result.reference.model = textIn(*m_referenceModel);
  result.reference.serial = textIn(*m_referenceSerial);
  result.reference.certificate = textIn(*m_certificate);
  result.reference.due = textIn(*m_due);
  result.reference.uncertainty = numberIn(*m_uncertainty).value_or(0.0);
  result.ambientC = numberIn(*m_ambient);
  return result;
}

} // namespace straightedge::gui
