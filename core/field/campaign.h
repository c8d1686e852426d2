// A field campaign: everything recorded for one teslameter, row by row, as in campaign.csv or a session.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace straightedge::field {

enum class Axis : std::uint8_t { X, Y, Z };
inline constexpr std::array<Axis, 3> allAxes = {Axis::X, Axis::Y, Axis::Z};

/// The package direction that points along the field.
enum class Orientation : std::uint8_t { PlusX, MinusX, PlusY, MinusY, PlusZ, MinusZ };

/// A stage of the campaign; decides which columns of its rows are filled beside the raw readings.
enum class CampaignStep : std::uint8_t {
  Nonlinearity,           ///< axis, reference: plateaus of constant field
  ProbeTemperature,       ///< chamber, PT100
  Offset,                 ///< PT100, in a zero-field chamber
  Sensitivity,            ///< axis, reference, PT100: temperature swept at each of several locked fields
  Electronics,            ///< electronics temperature, in a zero-field chamber
  ElectronicsSensitivity, ///< axis, reference, electronics temperature
  Orientation,            ///< orientation, reference
  Verification,           ///< axis, reference, PT100, electronics temperature
};

/// An empty cell is not a number.
inline constexpr double emptyCell = std::numeric_limits<double>::quiet_NaN();

struct CampaignRow {
  CampaignStep step = CampaignStep::Nonlinearity;
  std::optional<Axis> axis;
  std::optional<Orientation> orientation;
  bool locked = false;           ///< of the reference; rows that are not locked count nowhere
  double referenceT = emptyCell; ///< signed; empty where not locked or not used
  double chamberC = emptyCell;
  double pt100Ohm = emptyCell;
  double electronicsC = emptyCell;
  std::array<double, 3> rawT = {0.0, 0.0, 0.0}; ///< x, y, z: what the instrument shows before any correction
  double timeS = emptyCell;
  std::int64_t line = 0; ///< of the file it came from, for messages; 0 where there is none
};

struct Campaign {
  std::string name;   ///< file name or session title, for messages and traceability
  std::string sha256; ///< of the file's bytes; empty where there is no file
  std::vector<CampaignRow> rows;
};

} // namespace straightedge::field
