#include "app/gui/document/captured_sweep.h"

#include "core/angle/session_sweep.h"

namespace straightedge::gui {

angle::Sweep capturedSweep(const std::vector<session::AngleSample>& samples) {
  return angle::sweepFromSamples(samples);
}

} // namespace straightedge::gui
