// What the import preview decides, without widgets: which column is what, and what stands in the way.
#pragma once

#include "core/angle/sweep_csv.h"

#include <QString>
#include <QStringList>

namespace straightedge::gui {

class ImportPresenter {
public:
  explicit ImportPresenter(angle::CsvPreview preview);

  const angle::CsvPreview& preview() const { return m_preview; }
  const angle::SweepMapping& mapping() const { return m_mapping; }
  /// A role other than Ignored that another column had goes over to this one.
  void setRole(std::size_t column, angle::SweepColumn role);
  /// Why the sweep cannot be read as it stands; empty when it can.
  QString problem() const;

  QString layoutText() const;                  ///< "Separator: semicolon · decimal comma · first row holds the titles"
  QString rangeText(std::size_t column) const; ///< "0 … 348.75", or "no numbers"

  static const std::vector<angle::SweepColumn>& roles();
  static QString roleText(angle::SweepColumn role);

private:
  angle::CsvPreview m_preview;
  angle::SweepMapping m_mapping;
  bool m_changed = false;
};

} // namespace straightedge::gui
