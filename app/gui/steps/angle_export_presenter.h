// What the step Export writes of an angle calibration.
#pragma once

#include "app/gui/document/angle_document.h"
#include "app/gui/steps/export_presenter.h"

namespace straightedge::gui {

class AngleExportPresenter : public ExportPresenter {
  Q_OBJECT
public:
  AngleExportPresenter(AngleDocument& document, JobRunner& jobs, QObject* parent = nullptr);
  QString missing() const override;

protected:
  std::vector<FileToWrite> files(FilesFor use) const override;

private:
  AngleDocument& m_angle;
};

} // namespace straightedge::gui
