// Lines of boards. The first bytes choose the format, the rest is what the board prints: however it is cut into pieces,
// the same readings come of it, and every one is finite and within the limits.
#include "devices/instruments/line_reader.h"
#include "tests/fuzz/promise.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

using namespace straightedge::devices;

namespace {

LineFormat formatOf(std::uint8_t choice) {
  LineFormat format;
  format.separators = (choice & 1U) != 0 ? " ,\t" : ",;\t";
  format.prefix = (choice & 2U) != 0 ? "$" : "";
  LineColumn column;
  column.index = (choice & 4U) != 0 ? 2 : 1;
  column.label = (choice & 8U) != 0 ? "angle" : "";
  column.unit = (choice & 16U) != 0 ? "deg" : "";
  column.unitNeeded = (choice & 48U) == 48U;
  column.scale = (choice & 64U) != 0 ? 1e300 : 1.0;
  column.least = (choice & 128U) != 0 ? -360.0 : column.least;
  column.most = (choice & 128U) != 0 ? 360.0 : column.most;
  format.columns.push_back(column);
  return format;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) {
    return 0;
  }
  const LineFormat format = formatOf(data[0]);
  promise(problemOf(format).empty(), "the format is good");
  const std::size_t piece = 1 + data[1] % 64;
  const std::string_view text(reinterpret_cast<const char*>(data) + 2, size - 2);
  LineReader atOnce(format);
  LineReader inPieces(format);
  const auto whole = atOnce.take(text);
  std::vector<std::vector<double>> joined;
  for (std::size_t at = 0; at < text.size(); at += piece) {
    for (auto& values : inPieces.take(text.substr(at, piece))) {
      joined.push_back(std::move(values));
    }
  }
  promise(whole == joined, "pieces make no difference");
  promise(atOnce.counts().rejected == inPieces.counts().rejected, "nor to what is counted");
  for (const auto& values : whole) {
    promise(values.size() == 1 && std::isfinite(values[0]), "one finite value");
    promise(values[0] >= format.columns[0].least && values[0] <= format.columns[0].most, "within the limits");
  }
  if (atOnce.lastFault()) {
    promise(!describe(*atOnce.lastFault(), format).empty(), "a fault has words");
  }
  return 0;
}
