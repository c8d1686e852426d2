// Which column of a campaign file holds what. Private to campaign_csv and campaign_rows.
#pragma once

#include "core/base/csv_table.h"
#include "core/base/error.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace straightedge::field {

enum class CampaignColumn : std::uint8_t {
  Step,
  Axis,
  Orientation,
  Reference,
  Locked,
  Chamber,
  Pt100,
  Electronics,
  RawX,
  RawY,
  RawZ,
  Time
};
inline constexpr std::array<std::string_view, 12> campaignTitles = {
    "step",      "axis",          "orientation", "reference_T", "reference_locked", "chamber_C",
    "pt100_ohm", "electronics_C", "raw_x_T",     "raw_y_T",     "raw_z_T",          "time_s"};

constexpr std::string_view titleOf(CampaignColumn column) { return campaignTitles[static_cast<std::size_t>(column)]; }

/// Positions in the file; nothing for a column that it does not have.
struct CampaignLayout {
  std::array<std::optional<std::size_t>, campaignTitles.size()> at;
  std::optional<std::size_t> operator[](CampaignColumn column) const { return at[static_cast<std::size_t>(column)]; }
};

/// Errors (Input): no header; a column twice; no column for the step or a raw reading.
Result<CampaignLayout> findColumns(const CsvTable& table);

} // namespace straightedge::field
