// What people read for blocks, states and steps of a field calibration.
#pragma once

#include "core/field/calibration.h"
#include "core/field/campaign.h"

#include <QString>

namespace straightedge::gui {

QString blockTitle(field::Block block);         ///< "Probe temperature"
QString stateTitle(field::VerifiedState state); ///< "uncalibrated", "nonlinearity", …, "axis matrix"
QString stepTitle(field::CampaignStep step);    ///< "Electronics sensitivity"

} // namespace straightedge::gui
