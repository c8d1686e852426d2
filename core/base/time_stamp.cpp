#include "core/base/time_stamp.h"

#include "core/base/number_text.h"

#include <cstdlib>

namespace straightedge {

namespace {

std::string padded(unsigned value, std::size_t digits) {
  const std::string text = std::to_string(value);
  return text.size() < digits ? std::string(digits - text.size(), '0') + text : text;
}

} // namespace

std::string isoUtc(std::chrono::sys_seconds time) {
  const auto day = std::chrono::floor<std::chrono::days>(time);
  const std::chrono::year_month_day date(day);
  const std::chrono::hh_mm_ss clock(time - day);
  const auto number = [](auto count) { return padded(static_cast<unsigned>(count), 2); };
  return padded(static_cast<unsigned>(static_cast<int>(date.year())), 4) + "-" +
         padded(static_cast<unsigned>(date.month()), 2) + "-" + padded(static_cast<unsigned>(date.day()), 2) + "T" +
         number(clock.hours().count()) + ":" + number(clock.minutes().count()) + ":" + number(clock.seconds().count()) +
         "Z";
}

std::string timeStampNow() {
  if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH")) {
    if (const auto seconds = parseDouble(epoch); seconds && *seconds >= 0.0 && *seconds < 1e11) {
      return isoUtc(std::chrono::sys_seconds(std::chrono::seconds(static_cast<long long>(*seconds))));
    }
  }
  return isoUtc(std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()));
}

} // namespace straightedge
