// Which kind of calibration a file of data is for, from its header.
#pragma once

#include "core/session/session.h"

#include <QByteArray>
#include <QString>

namespace straightedge::gui {

/// Field where the first line that is no comment names the columns `step` and `raw_x_T`, in any case and with any of
/// the separators that campaigns may have; else Angle, whose preview explains what cannot be understood.
session::SessionKind dataKindOf(const QByteArray& beginning);
/// The same from the beginning of a file; Angle where it cannot be read.
session::SessionKind dataKindOfFile(const QString& file);

} // namespace straightedge::gui
