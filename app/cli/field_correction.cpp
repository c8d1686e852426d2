#include "app/cli/field_correction.h"

#include "app/cli/reading_lines.h"
#include "core/base/csv_text.h"
#include "core/base/number_text.h"
#include "core/field/names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <span>
#include <utility>

namespace straightedge::cli {

namespace {

constexpr std::array<std::string_view, 3> addedTitles = {"x_T", "y_T", "z_T"};
/// In the order of a reading without a header.
constexpr std::array<std::string_view, 5> readTitles = {"pt100_ohm", "electronics_C", "raw_x_T", "raw_y_T", "raw_z_T"};
constexpr std::size_t firstRaw = 2;

/// What needs a column, for the message when it is missing.
struct Need {
  bool is = false;
  std::string by;
};

std::array<Need, 5> needsOf(const field::CorrectionChain& chain, const field::AppliedChain& applied) {
  std::array<Need, 5> needs;
  for (const field::Axis axis : field::allAxes) {
    const field::AxisChain& blocks = chain.axes[field::indexOf(axis)];
    const std::string ofAxis = " of axis " + std::string(field::axisName(axis));
    needs[firstRaw + field::indexOf(axis)] = {true, "every correction"};
    if (applied.needsProbeTemperature() && needs[0].by.empty() && (blocks.offsetT || blocks.sensitivitySlope)) {
      needs[0] = {true, (blocks.offsetT ? "the offset over temperature" : "the sensitivity over temperature") + ofAxis};
    }
    if (applied.needsElectronicsTemperature() && needs[1].by.empty() &&
        (blocks.electronicsT || blocks.electronicsSensitivity)) {
      needs[1] = {true, (blocks.electronicsT ? "the offset over electronics temperature"
                                             : "the sensitivity over electronics temperature") +
                            ofAxis};
    }
  }
  return needs;
}

bool sameTitle(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

Result<std::size_t> findColumn(const CsvTable& table, std::size_t reading, const Need& need) {
  if (!table.layout().hasHeader) {
    if (table.columns() == readTitles.size()) {
      return reading;
    }
    return fail(ErrorKind::Input,
                "there is no header, and " + std::to_string(table.columns()) + " columns instead of 5",
                "name the columns: pt100_ohm,electronics_C,raw_x_T,raw_y_T,raw_z_T", table.name());
  }
  for (std::size_t column = 0; column < table.columns(); ++column) {
    if (sameTitle(table.title(column), readTitles[reading])) {
      return column;
    }
  }
  const std::string title(readTitles[reading]);
  return fail(ErrorKind::Input, "there is no column " + title + ", which " + need.by + " needs",
              reading < firstRaw ? "add it, or apply a calibration fitted without that step"
                                 : "name the columns of the raw readings raw_x_T, raw_y_T and raw_z_T",
              table.name());
}

Result<ReadingLayout> findFieldReadings(std::string_view start, const std::string& name,
                                        const std::array<Need, 5>& needs) {
  const auto table = firstReadings(start, name);
  if (!table) {
    return std::unexpected(table.error());
  }
  for (const std::string_view title : addedTitles) {
    if (auto free = refuseColumn(*table, title); !free) {
      return std::unexpected(std::move(free.error()));
    }
  }
  ReadingLayout layout = layoutOf(*table);
  for (std::size_t reading = 0; reading < readTitles.size(); ++reading) {
    if (needs[reading].is) {
      const auto column = findColumn(*table, reading, needs[reading]);
      if (!column) {
        return std::unexpected(column.error());
      }
      layout.wanted.push_back({*column, reading, std::string(readTitles[reading])});
    }
  }
  std::sort(layout.wanted.begin(), layout.wanted.end(),
            [](const WantedColumn& a, const WantedColumn& b) { return a.column < b.column; });
  return layout;
}

/// Some lines of a block, and their readings as the chain wants them: one column of numbers each. Few enough to stay in
/// the first caches from reading to writing.
struct LineGroup {
  static constexpr std::size_t most = 512;
  std::array<ReadingLine, most> lines;
  std::size_t count = 0;
  std::array<std::array<double, most>, readTitles.size()> columns{};
  std::size_t rows = 0;

  field::ReadingColumns readings() const {
    const auto filled = [this](std::size_t k) { return std::span<const double>(columns[k]).first(rows); };
    return {filled(0), filled(1), {filled(2), filled(3), filled(4)}};
  }
  /// The raw readings' memory takes the field.
  field::FieldColumns fields() {
    const auto filled = [this](std::size_t k) { return std::span<double>(columns[k]).first(rows); };
    return {{filled(2), filled(3), filled(4)}};
  }
};

class FieldCorrection : public BlockCorrection {
public:
  FieldCorrection(ReadingLayout layout, field::AppliedChain chain) : m_layout(std::move(layout)), m_chain(chain) {}

  void correct(std::string_view block, bool first, CorrectedBlock& result) const override;

private:
  /// The next lines; false where a row is refused.
  bool read(LineWalk& walk, LineGroup& group, CorrectedBlock& result) const;
  bool readRow(std::string_view row, LineGroup& group, CorrectedBlock& result) const;
  void write(const LineGroup& group, CorrectedBlock& result) const;
  void addCells(LineKind kind, const LineGroup& group, std::size_t row, CorrectedBlock& result) const;

  ReadingLayout m_layout;
  field::AppliedChain m_chain;
};

bool FieldCorrection::readRow(std::string_view row, LineGroup& group, CorrectedBlock& result) const {
  std::array<double, readTitles.size()> values{};
  result.problem = readCells(row, m_layout, values);
  if (result.problem) {
    return false;
  }
  for (const WantedColumn& wanted : m_layout.wanted) {
    const double value = values[wanted.value];
    if (!std::isfinite(value)) {
      result.blame("the " + wanted.meaning + " is " + formatDouble(value), "correct it or remove the row");
      return false;
    }
    group.columns[wanted.value][group.rows] = value;
  }
  ++group.rows;
  return true;
}

bool FieldCorrection::read(LineWalk& walk, LineGroup& group, CorrectedBlock& result) const {
  group.count = 0;
  group.rows = 0;
  while (group.count < LineGroup::most && walk.next(group.lines[group.count])) {
    const ReadingLine& line = group.lines[group.count++];
    if (line.kind == LineKind::Row && !readRow(line.content, group, result)) {
      return false;
    }
  }
  return true;
}

void FieldCorrection::addCells(LineKind kind, const LineGroup& group, std::size_t row, CorrectedBlock& result) const {
  for (std::size_t axis = 0; axis < addedTitles.size(); ++axis) {
    result.add({&m_layout.csv.separator, 1});
    if (kind == LineKind::Header) {
      result.add(addedTitles[axis]);
    } else if (kind == LineKind::Row) {
      result.addNumber(group.columns[firstRaw + axis][row], m_layout.csv.decimalPoint);
    }
  }
}

void FieldCorrection::write(const LineGroup& group, CorrectedBlock& result) const {
  std::size_t row = 0;
  for (const ReadingLine& line : std::span(group.lines).first(group.count)) {
    result.add(line.content);
    if (line.kind != LineKind::Passed) {
      addCells(line.kind, group, row, result);
      row += line.kind == LineKind::Row ? 1 : 0;
    }
    result.add(line.end);
  }
  result.rows += row;
}

void FieldCorrection::correct(std::string_view block, bool first, CorrectedBlock& result) const {
  const auto newlines = static_cast<std::size_t>(std::count(block.begin(), block.end(), '\n'));
  // Every line may grow by three separators and numbers, or titles.
  result.begin(block.size() + (newlines + 1) * addedTitles.size() * (longestDoubleText + 1));
  const std::size_t mark = first ? byteOrderMarkLength(block) : 0;
  result.add(block.substr(0, mark));
  LineWalk walk(block.substr(mark), first && m_layout.csv.hasHeader);
  LineGroup group;
  do {
    if (!read(walk, group, result)) {
      break;
    }
    m_chain.correct(group.readings(), group.fields());
    write(group, result);
  } while (group.count == LineGroup::most);
  result.lines = walk.lines();
}

} // namespace

MakeCorrection fieldCorrection(const field::CorrectionChain& chain, const field::AppliedChain& applied) {
  return [needs = needsOf(chain, applied),
          applied](std::string_view start, const std::string& name) -> Result<std::unique_ptr<const BlockCorrection>> {
    auto layout = findFieldReadings(start, name, needs);
    if (!layout) {
      return std::unexpected(std::move(layout.error()));
    }
    return std::make_unique<const FieldCorrection>(std::move(*layout), applied);
  };
}

} // namespace straightedge::cli
