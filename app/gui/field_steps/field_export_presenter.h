// What the step Export writes of a field calibration.
#pragma once

#include "app/gui/document/field_document.h"
#include "app/gui/steps/export_presenter.h"

namespace straightedge::gui {

class FieldExportPresenter : public ExportPresenter {
  Q_OBJECT
public:
  FieldExportPresenter(FieldDocument& document, JobRunner& jobs, QObject* parent = nullptr);
  QString missing() const override;

protected:
  std::vector<FileToWrite> files(FilesFor use) const override;

private:
  FieldDocument& m_field;
};

} // namespace straightedge::gui
