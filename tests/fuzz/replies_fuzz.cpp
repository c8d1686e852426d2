// Replies of instruments with a driver: whatever comes, a value is finite or there is none.
#include "devices/instruments/dtm151_reply.h"
#include "devices/instruments/pt2025_reply.h"
#include "devices/instruments/qsb_reply.h"
#include "devices/instruments/scpi_replies.h"
#include "devices/instruments/thm1176_reply.h"
#include "tests/fuzz/promise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

using namespace straightedge::devices;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto reply = parseThm1176Reply(text)) {
    promise(std::ranges::all_of(reply->fieldT, [](double fieldT) { return std::isfinite(fieldT); }), "THM1176: finite");
    promise(reply->status >= 0 && reply->status <= 255, "THM1176: status is a byte");
  }
  if (const auto reading = parsePt2025Reading(text)) {
    promise(std::isfinite(reading->value) && reading->value >= 0.0, "PT2025: a finite magnitude");
    promise(!parsePt2025Status(text), "PT2025: a reading is no status");
  }
  parsePt2025Status(text);
  if (const auto reply = parseQsbReply(text)) {
    promise(text.find('!') != std::string_view::npos, "QSB: a reply has an end");
  }
  if (const auto number = parseDtm151Number(text)) {
    promise(std::isfinite(number->value), "DTM-151: finite");
  }
  if (const auto identity = parseIdentity(text)) {
    promise(!identity->model.empty(), "*IDN?: a model");
  }
  parseScpiError(text);
  if (const auto number = parseScpiNumber(text)) {
    promise(std::isfinite(*number), "SCPI: finite");
  }
  promise(shown(text).size() <= 4 * 60 + 8, "messages stay short");
  return 0;
}
