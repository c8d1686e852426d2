// The report as one HTML page that needs no other file: plots are embedded as vector pictures.
#pragma once

#include "app/gui/figures/report_content.h"

#include <QByteArray>

namespace straightedge::gui {

/// UTF-8. Any thread.
QByteArray reportAsHtml(const ReportContent& content);

} // namespace straightedge::gui
