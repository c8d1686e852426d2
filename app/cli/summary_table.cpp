#include "app/cli/summary_table.h"

#include "core/base/number_text.h"

#include <algorithm>

namespace straightedge::cli {

namespace {

/// Columns on a terminal, not bytes: UTF-8 continuation bytes take none.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string degrees(double value) { return formatForPeople(value, 3) + "°"; }

std::string headLine(const angle::AngleCalibration& calibration) {
  std::string text = calibration.source.file + ": " + std::to_string(calibration.source.points) + " points, sensor " +
                     (calibration.direction == angle::SensorDirection::Increasing ? "increasing" : "decreasing") + ", ";
  text += calibration.curveMethod == angle::CurveMethod::Regress
              ? "regression with " + std::to_string(calibration.curveHarmonics) + " harmonics"
              : std::string("interpolated by a periodic spline");
  return text + "\nLeave-one-out error: " + degrees(calibration.leaveOneOutRmsDeg) + " rms, " +
         degrees(calibration.leaveOneOutMaxDeg) + " maximum\n";
}

} // namespace

std::string alignedColumns(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], width(row[i]));
    }
  }
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string gap(widths[i] - width(row[i]), ' ');
      text += i == 0 ? row[i] + gap : "  " + gap + row[i];
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

std::string summaryOf(const angle::AngleCalibration& calibration) {
  std::vector<std::vector<std::string>> rows{
      {"model", "entries", "bytes", "max curve", "rms curve", "max points", "rms points", "uncertainty (95 %)"}};
  for (std::size_t i = 0; i < calibration.models.size(); ++i) {
    const angle::Model& model = calibration.models[i];
    const angle::ModelErrors& errors = model.errors;
    rows.push_back({model.name.text(), std::to_string(model.name.storageEntries()),
                    std::to_string(model.name.storageBytes()), degrees(errors.maxCurveDeg), degrees(errors.rmsCurveDeg),
                    degrees(errors.maxPointsDeg), degrees(errors.rmsPointsDeg),
                    i < calibration.uncertainty.size() ? degrees(calibration.uncertainty[i].expandedDeg) : ""});
  }
  return headLine(calibration) + alignedColumns(rows);
}

} // namespace straightedge::cli
