// Replies that instruments with SCPI have in common.
#pragma once

#include "devices/instruments/conversation.h"

#include <optional>
#include <string>
#include <string_view>

namespace straightedge::devices {

/// The four fields of *IDN?: "HEWLETT-PACKARD,34401A,0,11-5-2". Nothing where there are fewer than two.
std::optional<InstrumentIdentity> parseIdentity(std::string_view reply);

struct ScpiError {
  int code = 0; ///< 0: none
  std::string text;
};

/// One entry of the error queue: `+0,"No error"`, `-113,"Undefined header"`.
std::optional<ScpiError> parseScpiError(std::string_view reply);

/// A number as SCPI writes it; nothing for text, nan and inf. |value| of 9.9e37 and more means overload: see
/// isScpiOverload.
std::optional<double> parseScpiNumber(std::string_view reply);
bool isScpiOverload(double value);

/// Empties the error queue. The first error in it, if any, is the result's error.
Result<void> checkErrorQueue(Conversation& talk, std::string_view command, std::string_view after);

} // namespace straightedge::devices
