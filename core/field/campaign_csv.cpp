#include "core/field/campaign_csv.h"

#include "core/base/csv_table.h"
#include "core/base/file_bytes.h"
#include "core/base/input_file.h"
#include "core/base/line_blocks.h"
#include "core/base/number_text.h"
#include "core/base/sha256.h"
#include "core/field/campaign_columns.h"
#include "core/field/campaign_rows.h"
#include "core/field/names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

namespace straightedge::field {

namespace {

constexpr std::size_t blockSize = std::size_t{128} * 1024;

void appendNumber(std::string& text, double value) {
  text += ',';
  if (!std::isnan(value)) {
    std::array<char, longestDoubleText> buffer{};
    text.append(buffer.data(), formatDouble(value, buffer.data()));
  }
}

/// The whole of a text at a time: the order in which the checks come is that of the file's faults as they are told.
Result<Campaign> parseWhole(std::string bytes, const std::string& name, const std::string& fileName) {
  Campaign campaign;
  campaign.name = fileName;
  campaign.sha256 = sha256Hex(bytes);
  const auto table = CsvTable::parse(std::move(bytes), name);
  if (!table) {
    return std::unexpected(table.error());
  }
  const auto layout = findColumns(*table);
  if (!layout) {
    return std::unexpected(layout.error());
  }
  campaign.rows.reserve(table->rows());
  if (auto done = addRows(*table, *layout, campaign.rows); !done) {
    return std::unexpected(std::move(done.error()));
  }
  return campaign;
}

/// Replaces a block by the next whole lines; false at the end.
using NextLines = std::function<Result<bool>(std::string& block)>;

/// The same a block of lines at a time: text and cells of a block stay in the caches, and of a long campaign only the
/// rows are in memory. Nothing where anything is wrong with the text of `size` bytes: parseWhole() tells what it is.
std::optional<Campaign> readInBlocks(const NextLines& next, std::size_t size, const std::string& name) {
  Campaign campaign;
  Sha256 sum;
  std::string block;
  if (!next(block).value_or(false)) {
    return std::nullopt;
  }
  std::size_t bytesRead = block.size();
  sum.add(block);
  auto table = CsvTable::parse(block, name);
  if (!table || (bytesRead < size && table->rows() < csvSampledLines)) {
    return std::nullopt;
  }
  const auto layout = findColumns(*table);
  if (!layout) {
    return std::nullopt;
  }
  const std::size_t expected = table->rows() * size / bytesRead;
  campaign.rows.reserve(expected + expected / 8);
  while (true) {
    if (!addRows(*table, *layout, campaign.rows)) {
      return std::nullopt;
    }
    const auto more = next(block);
    if (!more || !*more) {
      break;
    }
    bytesRead += block.size();
    sum.add(block);
    if (!table->readOn(block)) {
      return std::nullopt;
    }
  }
  if (bytesRead != size) {
    return std::nullopt;
  }
  campaign.sha256 = sum.hex();
  return campaign;
}

std::optional<Campaign> readFileInBlocks(const std::string& path) {
  auto file = InputFile::open(path);
  const std::size_t size = file ? file->sizeIfKnown() : 0;
  if (path == "-" || size == 0 || size > longestInput) { // what cannot be read twice is read whole
    return std::nullopt;
  }
  LineBlocks blocks(*std::move(file), blockSize);
  auto campaign = readInBlocks([&blocks](std::string& block) { return blocks.next(block); }, size, inputName(path));
  if (campaign) {
    campaign->name = inputFileName(path);
  }
  return campaign;
}

/// Moves the first lines of a text to `block`, about as many as readFileInBlocks() takes; false at the end.
bool takeLines(std::string_view& rest, std::string& block) {
  const std::size_t newline = rest.size() > blockSize ? rest.find('\n', blockSize) : std::string_view::npos;
  block = rest.substr(0, newline == std::string_view::npos ? newline : newline + 1);
  rest.remove_prefix(block.size());
  return !block.empty();
}

} // namespace

Result<Campaign> readCampaignCsv(const std::string& path) {
  if (auto campaign = readFileInBlocks(path)) {
    return *std::move(campaign);
  }
  auto bytes = readFileBytes(path);
  if (!bytes) {
    return std::unexpected(std::move(bytes.error()));
  }
  return parseWhole(std::move(*bytes), inputName(path), inputFileName(path));
}

Result<Campaign> parseCampaignCsv(std::string bytes, const std::string& name, const std::string& fileName) {
  std::string_view rest = bytes;
  const NextLines next = [&rest](std::string& block) -> Result<bool> { return takeLines(rest, block); };
  if (auto campaign = readInBlocks(next, bytes.size(), name)) {
    campaign->name = fileName;
    return *std::move(campaign);
  }
  return parseWhole(std::move(bytes), name, fileName);
}

std::string campaignCsv(const Campaign& campaign) {
  const bool timed = std::ranges::any_of(campaign.rows, [](const CampaignRow& row) { return !std::isnan(row.timeS); });
  std::string text;
  for (const std::string_view title : campaignTitles) {
    if (timed || title != titleOf(CampaignColumn::Time)) {
      text += (text.empty() ? "" : ",") + std::string(title);
    }
  }
  text += '\n';
  for (const CampaignRow& row : campaign.rows) {
    text += stepName(row.step);
    text += ',';
    text += row.axis ? axisName(*row.axis) : "";
    text += ',';
    text += row.orientation ? orientationName(*row.orientation) : "";
    appendNumber(text, row.referenceT);
    text += row.locked ? ",1" : ",0";
    for (const double value : {row.chamberC, row.pt100Ohm, row.electronicsC, row.rawT[0], row.rawT[1], row.rawT[2]}) {
      appendNumber(text, value);
    }
    if (timed) {
      appendNumber(text, row.timeS);
    }
    text += '\n';
  }
  return text;
}

} // namespace straightedge::field
