// Profiles. Up to the first zero byte the input is a file; the rest is a reply that the profile's readings are to read.
#include "devices/instruments/profile.h"
#include "tests/fuzz/promise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

using namespace straightedge::devices;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view all(reinterpret_cast<const char*>(data), size);
  const std::string_view text = all.substr(0, all.find('\0'));
  const std::string_view reply = text.size() < all.size() ? all.substr(text.size() + 1) : "+1.07793500E+02";
  const auto profile = parseProfile(text, "p.json");
  if (!profile) {
    promise(!profile.error().what.empty() && !profile.error().remedy.empty(), "what is wrong has words");
    promise(profile.error().where.starts_with("p.json"), "and a place");
    const auto lines = std::ranges::count(text, '\n') + 1;
    const std::string line = profile.error().where.substr(profile.error().where.find(':') + 1);
    promise(line == "p.json" || std::stol(line) <= lines, "within the file");
    return 0;
  }
  promise(!profile->readings.empty() && !profile->name.empty(), "a good profile has readings and a name");
  for (const ProfileReading& reading : profile->readings) {
    const auto values = parseReading(reading, reply);
    if (values) {
      promise(values->size() == reading.format.columns.size(), "a value for each column");
      promise(std::ranges::all_of(*values, [](double value) { return std::isfinite(value); }), "finite values");
    }
  }
  return 0;
}
