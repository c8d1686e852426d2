// Noise, repeatability and hysteresis, each apart from the others, from several passes over the same encoder angles.
#pragma once

#include "core/angle/alignment.h"
#include "core/angle/encoder_groups.h"

namespace straightedge::angle {

/// `aligned` with its points, turns and passes filled in; `groups` of its encoder angles.
Repeatability measureRepeatability(const AlignedSweep& aligned, const EncoderGroups& groups);

} // namespace straightedge::angle
