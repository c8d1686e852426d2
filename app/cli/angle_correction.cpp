#include "app/cli/angle_correction.h"

#include "app/cli/reading_lines.h"
#include "core/base/csv_text.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <utility>

namespace straightedge::cli {

namespace {

constexpr std::string_view addedTitle = "corrected_deg";

class AngleCorrection : public BlockCorrection {
public:
  AngleCorrection(ReadingLayout layout, angle::Model model, angle::SensorDirection direction)
      : m_layout(std::move(layout)), m_model(std::move(model)), m_direction(direction) {}

  void correct(std::string_view block, bool first, CorrectedBlock& result) const override;

private:
  void row(std::string_view content, CorrectedBlock& result) const;

  ReadingLayout m_layout;
  angle::Model m_model;
  angle::SensorDirection m_direction;
};

void AngleCorrection::row(std::string_view content, CorrectedBlock& result) const {
  double sensorDeg = 0.0;
  result.problem = readCells(content, m_layout, {&sensorDeg, 1});
  if (result.problem) {
    return;
  }
  if (!(sensorDeg >= 0.0 && sensorDeg <= 360.0)) {
    result.blame("the sensor angle " + formatDouble(sensorDeg) + " lies outside 0 to 360°",
                 "correct it or remove the row");
    return;
  }
  result.addNumber(angle::correctedDeg(m_model, m_direction, sensorDeg), m_layout.csv.decimalPoint);
  ++result.rows;
}

void AngleCorrection::correct(std::string_view block, bool first, CorrectedBlock& result) const {
  const auto newlines = static_cast<std::size_t>(std::count(block.begin(), block.end(), '\n'));
  // Every line may grow by a separator and a number, or by the title.
  result.begin(block.size() + (newlines + 1) * (longestDoubleText + 1));
  const std::size_t mark = first ? byteOrderMarkLength(block) : 0;
  result.add(block.substr(0, mark));
  LineWalk walk(block.substr(mark), first && m_layout.csv.hasHeader);
  for (ReadingLine line; !result.problem && walk.next(line);) {
    result.add(line.content);
    if (line.kind != LineKind::Passed) {
      result.add({&m_layout.csv.separator, 1});
    }
    if (line.kind == LineKind::Header) {
      result.add(addedTitle);
    } else if (line.kind == LineKind::Row) {
      row(line.content, result);
    }
    result.add(line.end);
  }
  result.lines = walk.lines();
}

} // namespace

MakeCorrection angleCorrection(const angle::Model& model, angle::SensorDirection direction) {
  return [model, direction](std::string_view start,
                            const std::string& name) -> Result<std::unique_ptr<const BlockCorrection>> {
    auto layout = findAngleReadings(start, name);
    if (!layout) {
      return std::unexpected(std::move(layout.error()));
    }
    return std::make_unique<const AngleCorrection>(std::move(*layout), model, direction);
  };
}

} // namespace straightedge::cli
