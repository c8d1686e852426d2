#include "core/field/campaign_rows.h"

#include "core/base/number_text.h"
#include "core/field/names.h"
#include "core/field/step_rows.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace straightedge::field {

namespace {

constexpr double largestFieldT = 100.0;

/// Takes the cells of one row after another; the first thing wrong is kept.
class RowReader {
public:
  RowReader(const CsvTable& table, const CampaignLayout& layout) : m_table(table), m_layout(layout) {}

  /// False: problem() says what is wrong.
  bool read(std::size_t index, CampaignRow& row);
  const Error& problem() const { return *m_problem; }

private:
  std::string_view cell(CampaignColumn column) const {
    const auto at = m_layout[column];
    return at ? m_table.cell(m_row, *at) : std::string_view();
  }
  void blame(std::string what, std::string remedy) {
    if (!m_problem) {
      m_problem = Error{ErrorKind::Input, std::move(what), std::move(remedy), m_table.where(m_row)};
    }
  }
  void blameCell(CampaignColumn column, const std::string& remedy) {
    constexpr std::size_t shown = 40;
    const std::string title(titleOf(column));
    blame(title + " holds \"" + std::string(cell(column).substr(0, shown)) + "\"", remedy);
  }
  double number(CampaignColumn column);
  double fieldT(CampaignColumn column);
  bool lockedOr(bool otherwise);
  void require(CampaignColumn column, bool needed, bool present, const CampaignRow& row);
  void readWhere(CampaignRow& row);

  const CsvTable& m_table;
  const CampaignLayout& m_layout;
  std::size_t m_row = 0;
  std::optional<Error> m_problem;
};

double RowReader::number(CampaignColumn column) {
  const auto text = cell(column);
  if (text.empty()) {
    return emptyCell;
  }
  const auto value = parseDouble(text, m_table.layout().decimalPoint);
  if (!value || !std::isfinite(*value)) {
    blameCell(column, "write a finite number, or remove the row");
    return emptyCell;
  }
  return *value;
}

double RowReader::fieldT(CampaignColumn column) {
  const double value = number(column);
  if (std::abs(value) > largestFieldT) {
    blame(std::string(titleOf(column)) + " is " + formatForPeople(value) + " T", "give fields in tesla");
  }
  return value;
}

bool RowReader::lockedOr(bool otherwise) {
  const auto text = cell(CampaignColumn::Locked);
  if (text.empty()) {
    return otherwise;
  }
  if (text == "1" || text == "0") {
    return text == "1";
  }
  std::string word(text);
  std::ranges::transform(word, word.begin(),
                         [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  if (word == "true" || word == "yes" || word == "locked" || word == "1.0") {
    return true;
  }
  if (word != "false" && word != "no" && word != "unlocked" && word != "0.0") {
    blameCell(CampaignColumn::Locked, "write 1 for a locked reference and 0 for one that is not");
  }
  return false;
}

void RowReader::require(CampaignColumn column, bool needed, bool present, const CampaignRow& row) {
  if (!needed || present || m_problem) {
    return;
  }
  const std::string title(titleOf(column));
  const std::string step(stepName(row.step));
  if (!m_layout[column]) {
    blame("the column \"" + title + "\" is missing, which rows of the step " + step + " need",
          "add it, or remove the rows of that step");
  } else if (cell(column).empty()) {
    blame(title + " is empty, which a row of the step " + step + " needs", "fill it in or remove the row");
  }
}

void RowReader::readWhere(CampaignRow& row) {
  if (const auto text = cell(CampaignColumn::Axis); !text.empty()) {
    row.axis = parseAxis(text);
    if (!row.axis) {
      blameCell(CampaignColumn::Axis, "write x, y or z");
    }
  }
  if (const auto text = cell(CampaignColumn::Orientation); !text.empty()) {
    row.orientation = parseOrientation(text);
    if (!row.orientation) {
      blameCell(CampaignColumn::Orientation, "write +x, -x, +y, -y, +z or -z");
    }
  }
}

bool RowReader::read(std::size_t index, CampaignRow& row) {
  m_row = index;
  row.line = static_cast<std::int64_t>(m_table.line(index));
  const auto step = parseStep(cell(CampaignColumn::Step));
  if (!step) {
    blameCell(CampaignColumn::Step, "write one of nonlinearity, probe-temperature, offset, sensitivity, electronics, "
                                    "electronics-sensitivity, orientation, verification");
    return false;
  }
  row.step = *step;
  readWhere(row);
  row.referenceT = fieldT(CampaignColumn::Reference);
  row.locked = lockedOr(!std::isnan(row.referenceT));
  row.chamberC = number(CampaignColumn::Chamber);
  row.pt100Ohm = number(CampaignColumn::Pt100);
  row.electronicsC = number(CampaignColumn::Electronics);
  row.rawT = {fieldT(CampaignColumn::RawX), fieldT(CampaignColumn::RawY), fieldT(CampaignColumn::RawZ)};
  row.timeS = number(CampaignColumn::Time);
  if (row.pt100Ohm <= 0.0) {
    blameCell(CampaignColumn::Pt100, "give the resistance in ohms, or leave the cell empty");
  }

  const StepNeeds needs = needsOf(row.step);
  const bool counts = row.locked || !needs.reference;
  const auto known = [](double value) { return !std::isnan(value); };
  require(CampaignColumn::RawX, true, known(row.rawT[0]), row);
  require(CampaignColumn::RawY, true, known(row.rawT[1]), row);
  require(CampaignColumn::RawZ, true, known(row.rawT[2]), row);
  require(CampaignColumn::Axis, needs.axis, row.axis.has_value(), row);
  require(CampaignColumn::Orientation, needs.orientation, row.orientation.has_value(), row);
  require(CampaignColumn::Reference, needs.reference && (counts || !m_layout[CampaignColumn::Reference]),
          known(row.referenceT), row);
  require(CampaignColumn::Chamber, needs.chamber && counts, known(row.chamberC), row);
  require(CampaignColumn::Pt100, needs.pt100 && counts, known(row.pt100Ohm), row);
  require(CampaignColumn::Electronics, needs.electronics && counts, known(row.electronicsC), row);
  return !m_problem;
}

} // namespace

Result<void> addRows(const CsvTable& table, const CampaignLayout& layout, std::vector<CampaignRow>& rows) {
  RowReader reader(table, layout);
  for (std::size_t index = 0; index < table.rows(); ++index) {
    if (!reader.read(index, rows.emplace_back())) {
      return std::unexpected(reader.problem());
    }
  }
  return {};
}

} // namespace straightedge::field
