// Blocks of a report as measured boxes. Used by report_layout only.
#pragma once

#include "app/gui/figures/report_layout.h"

#include <QColor>
#include <QFont>

namespace straightedge::gui {

/// Colours of the page's text; a page is paper, so there is no dark theme.
inline const QColor reportInk(0x1d, 0x24, 0x30);
inline const QColor reportQuietInk(0x5a, 0x64, 0x73);

void addTitle(QList<ReportBox>& boxes, const ReportContent& content, double width);
void addBoxes(QList<ReportBox>& boxes, const ReportHeading& heading, double width);
void addBoxes(QList<ReportBox>& boxes, const ReportParagraph& paragraph, double width);
void addBoxes(QList<ReportBox>& boxes, const ReportTable& table, double width);
void addBoxes(QList<ReportBox>& boxes, const ReportFigure& figure, double width);

/// Text wrapped to a width: one box.
ReportBox textBox(const QString& text, const QFont& font, const QColor& color, double width);
QFont reportFont(int pixels, bool bold = false);

} // namespace straightedge::gui
