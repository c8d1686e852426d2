// Inside of CalibrationDocument: not for other folders.
#pragma once

#include "app/gui/document/calibration_document.h"
#include "app/gui/document/session_binding.h"

#include <QLockFile>

#include <memory>

namespace straightedge::gui {

struct CalibrationDocument::Life {
  SessionBinding binding;
  QUndoStack undo;
  QString file;
  std::unique_ptr<QLockFile> scratchLock; ///< set while the session is a scratch file
  Traceability traceability;
};

} // namespace straightedge::gui
