// VTK's warnings and errors go to Qt's log (category "straightedge.vtk") instead of stderr or a window of their own.
#pragma once

namespace straightedge::gui {

/// Any thread, any number of times.
void sendVtkMessagesToLog();

} // namespace straightedge::gui
