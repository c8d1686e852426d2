// Words that messages about fields share.
#pragma once

#include "core/base/error.h"
#include "core/base/number_text.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

namespace straightedge::field {

inline std::string teslaText(double valueT) {
  constexpr double oneMilliTesla = 1e-3;
  const double size = std::abs(valueT);
  if (size >= 0.1 || size == 0.0) {
    return formatForPeople(valueT, 3) + " T";
  }
  return size >= oneMilliTesla ? formatForPeople(valueT * 1e3, 3) + " mT" : formatForPeople(valueT * 1e6, 3) + " µT";
}

inline std::string percentText(double value, int digits = 3) {
  // Not beyond what the reference's 0.0003 % distinguish: digits of a rounding error say nothing.
  return std::abs(value) < 1e-5 ? "less than 0.00001 %" : formatForPeople(value, digits) + " %";
}

inline std::string celsiusText(double valueC) { return formatForPeople(valueC, 3) + " °C"; }

/// "3 rows", "1 row".
inline std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// `line` is 0 where the whole campaign is to blame, or where there is no file.
inline std::unexpected<Error> campaignFault(const std::string& name, std::int64_t line, std::string what,
                                            std::string remedy) {
  return fail(ErrorKind::Input, std::move(what), std::move(remedy),
              line > 0 ? name + ":" + std::to_string(line) : name);
}

} // namespace straightedge::field
