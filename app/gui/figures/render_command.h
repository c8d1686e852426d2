// `straightedge --render CALIBRATION.json --out DIR`: plots and report without a display.
#pragma once

#include <QStringList>

namespace straightedge::gui {

/// Arguments after `--render`: CALIBRATION.json --out DIR [--plots] [--report] [--sweep SWEEP.csv] [--comparison FILE],
/// of a field calibration [--campaign CAMPAIGN.csv] (--sweep means the same).
/// Neither --plots nor --report: both. With the sweep the calibration came from, curve and points are recomputed;
/// without, what the file holds is drawn. Prints one line on stderr when it fails. Needs a QGuiApplication (offscreen
/// will do). Returns the exit code: 0, 2 usage, 3 input, 5 storage.
int renderCalibration(const QStringList& arguments);

} // namespace straightedge::gui
