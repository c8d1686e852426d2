// Copy: whatever has the focus, into the clipboard.
#pragma once

class QWidget;

namespace straightedge::gui {

/// Text fields copy their selection, tables the selected cells (or all of them) as tab-separated text with titles,
/// plots their picture at twice the size, and anything with a slot copy() does it itself. False where there is nothing
/// to copy.
bool copyFrom(QWidget* widget);

} // namespace straightedge::gui
