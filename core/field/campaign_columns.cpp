#include "core/field/campaign_columns.h"

#include <cctype>
#include <string>

namespace straightedge::field {

namespace {

/// Lower case, with _ for blanks, brackets and the like: "Reference [T]" is reference_T.
std::string normalised(std::string_view title) {
  std::string text;
  for (const char c : title) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!text.empty() && text.back() != '_') {
      text += '_';
    }
  }
  while (!text.empty() && text.back() == '_') {
    text.pop_back();
  }
  return text;
}

} // namespace

Result<CampaignLayout> findColumns(const CsvTable& table) {
  if (!table.layout().hasHeader) {
    return fail(ErrorKind::Input, "the campaign has no header", "name the columns in the first line: step,axis,…",
                table.where(0));
  }
  CampaignLayout layout;
  for (std::size_t role = 0; role < campaignTitles.size(); ++role) {
    const std::string wanted = normalised(campaignTitles[role]);
    for (std::size_t column = 0; column < table.columns(); ++column) {
      if (normalised(table.title(column)) != wanted) {
        continue;
      }
      if (layout.at[role]) {
        return fail(ErrorKind::Input, "there are two columns \"" + std::string(campaignTitles[role]) + "\"",
                    "remove one of them", table.name());
      }
      layout.at[role] = column;
    }
  }
  for (const auto column : {CampaignColumn::Step, CampaignColumn::RawX, CampaignColumn::RawY, CampaignColumn::RawZ}) {
    if (!layout[column]) {
      return fail(ErrorKind::Input, "the column \"" + std::string(titleOf(column)) + "\" is missing",
                  "add it, or name a campaign file", table.name());
    }
  }
  return layout;
}

} // namespace straightedge::field
