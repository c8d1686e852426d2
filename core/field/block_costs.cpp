#include "core/field/block_costs.h"

#include "core/field/block_names.h"
#include "core/field/names.h"

namespace straightedge::field {

const char* costOf(Block block) {
  switch (block) {
  case Block::Nonlinearity:
    return "Errors of gain and linearity, most of what an uncalibrated instrument shows, stay in the reading.";
  case Block::ProbeTemperature:
    return "The probe's temperature is not known, so nothing is corrected for it: readings are good only near the "
           "reference temperature.";
  case Block::Offset:
    return "The offset and its drift with the probe's temperature stay in the reading, most visible in small fields.";
  case Block::Sensitivity:
    return "The gain's drift with the probe's temperature stays in the reading and grows with the field.";
  case Block::Electronics:
    return "The offset's drift with the temperature of the electronics stays in the reading.";
  case Block::ElectronicsSensitivity:
    return "The gain's drift with the temperature of the electronics stays in the reading and grows with the field.";
  case Block::AxisMatrix:
    return "The axes count as square to each other and to the package: of a field across an axis a part shows on it, "
           "about 1.7 % for each degree of tilt.";
  }
  return "";
}

CampaignStep stepOf(Block block) {
  switch (block) {
  case Block::Nonlinearity:
    return CampaignStep::Nonlinearity;
  case Block::ProbeTemperature:
    return CampaignStep::ProbeTemperature;
  case Block::Offset:
    return CampaignStep::Offset;
  case Block::Sensitivity:
    return CampaignStep::Sensitivity;
  case Block::Electronics:
    return CampaignStep::Electronics;
  case Block::ElectronicsSensitivity:
    return CampaignStep::ElectronicsSensitivity;
  case Block::AxisMatrix:
    return CampaignStep::Orientation;
  }
  return CampaignStep::Nonlinearity;
}

FieldWarning switchedOff(Block block, const std::optional<Axis>& axis, const std::string& reason) {
  std::string text = "The block " + std::string(blockName(block));
  text += axis ? " of axis " + std::string(axisName(*axis)) : "";
  return {block, text + " is off: " + reason + ". " + costOf(block)};
}

} // namespace straightedge::field
