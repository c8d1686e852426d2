// The report as an A4 document with numbered pages; plots are vector drawings.
#pragma once

#include "app/gui/figures/report_content.h"

#include <QByteArray>

namespace straightedge::gui {

/// Any thread with a QGuiApplication.
QByteArray reportAsPdf(const ReportContent& content);

} // namespace straightedge::gui
