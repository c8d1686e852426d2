// Whether a result that names one also names the other.
#pragma once

#include "core/base/traceability.h"

#include <tuple>

namespace straightedge::gui {

inline bool sameTraceability(const Traceability& a, const Traceability& b) {
  const auto key = [](const Traceability& t) {
    return std::tie(t.deviceSerial, t.deviceModel, t.operatorName, t.reference.model, t.reference.serial,
                    t.reference.certificate, t.reference.due, t.reference.uncertainty, t.ambientC);
  };
  return key(a) == key(b);
}

} // namespace straightedge::gui
