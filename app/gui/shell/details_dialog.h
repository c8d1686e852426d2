// Who, what, with what: the details that travel with every result.
#pragma once

#include "app/gui/shell/reference_unit.h"
#include "core/base/traceability.h"

#include <QDialog>

class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace straightedge::gui {

class DetailsDialog : public QDialog {
  Q_OBJECT
public:
  DetailsDialog(const Traceability& traceability, ReferenceUnit unit, QWidget* parent = nullptr);
  Traceability traceability() const;
  QPushButton* okButton() const { return m_ok; }

private:
  QLineEdit* addText(QFormLayout& form, const QString& label, const std::string& value, const char* name);
  QFormLayout* addGroup(const QString& title);
  void alignLabels();
  void check();

  ReferenceUnit m_unit;
  QLineEdit* m_serial = nullptr;
  QLineEdit* m_model = nullptr;
  QLineEdit* m_operator = nullptr;
  QLineEdit* m_ambient = nullptr;
  QLineEdit* m_referenceModel = nullptr;
  QLineEdit* m_referenceSerial = nullptr;
  QLineEdit* m_certificate = nullptr;
  QLineEdit* m_due = nullptr;
  QLineEdit* m_uncertainty = nullptr;
  QLabel* m_problem = nullptr;
  QPushButton* m_ok = nullptr;
};

} // namespace straightedge::gui
