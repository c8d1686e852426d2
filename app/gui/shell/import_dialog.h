// The preview of a CSV file: its first rows, how each column is understood, and a way to say otherwise.
#pragma once

#include "app/gui/shell/import_presenter.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QPushButton;
class QRadioButton;
class QTableWidget;

namespace straightedge::gui {

class ImportDialog : public QDialog {
  Q_OBJECT
public:
  /// `canVerify`: a calibration sweep is there, so the file may also be a fresh sweep to verify it.
  ImportDialog(const QString& file, const angle::CsvPreview& preview, bool preferVerification, bool canVerify,
               QWidget* parent);
  const angle::SweepMapping& mapping() const { return m_presenter.mapping(); }
  bool forVerification() const;
  QString problem() const { return m_presenter.problem(); }
  QComboBox* roleBox(std::size_t column) const { return m_roles[static_cast<qsizetype>(column)]; }
  QPushButton* importButton() const { return m_import; }

private:
  QTableWidget* makeTable();
  QWidget* makeUse(bool preferVerification);
  void refresh();

  ImportPresenter m_presenter;
  QList<QComboBox*> m_roles;
  QTableWidget* m_table = nullptr;
  QLabel* m_problem = nullptr;
  QPushButton* m_import = nullptr;
  QRadioButton* m_verification = nullptr;
};

} // namespace straightedge::gui
