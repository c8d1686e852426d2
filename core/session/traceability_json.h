// Traceability as the JSON document that a session keeps.
#pragma once

#include "core/base/error.h"
#include "core/base/traceability.h"

#include <string>
#include <string_view>

namespace straightedge::session {

std::string traceabilityToJson(const Traceability& traceability);
/// Errors: Storage, with `where`.
Result<Traceability> traceabilityFromJson(std::string_view json, const std::string& where);

} // namespace straightedge::session
