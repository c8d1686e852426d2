// Options that several commands share, and text of options turned into values.
#pragma once

#include "core/angle/calibration.h"
#include "core/base/error.h"
#include "core/base/traceability.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace straightedge::cli {

/// As typed; made into a Traceability when the command runs.
struct TraceabilityOptions {
  std::string serial, deviceModel, operatorName;
  std::string referenceModel, referenceSerial, referenceCertificate, referenceDue, referenceUncertainty;
  std::string ambient;
};
/// `withSerial`: one device (fit); otherwise many (batch). `referenceUnit`: of the reference's uncertainty.
void addTraceabilityOptions(CLI::App& command, TraceabilityOptions& options, bool withSerial,
                            const char* referenceUnit = "DEG");
/// Errors (Usage): a number or a date that is none.
Result<Traceability> traceabilityFrom(const TraceabilityOptions& options);

/// --model (several times) and --curve.
struct ModelOptions {
  std::vector<std::string> models;
  std::string curve = "auto";
};
void addModelOptions(CLI::App& command, ModelOptions& options);
/// Errors (Usage): an unknown model; the same model twice.
Result<angle::CalibrationOptions> calibrationOptionsFrom(const ModelOptions& options);

/// The value of an option as a number.
/// Errors (Usage): no number; outside [least, most]. `example` shows how to write it.
Result<double> optionNumber(const std::string& option, const std::string& text, double least, double most,
                            const std::string& example);
Result<int> optionInteger(const std::string& option, const std::string& text, int least, int most,
                          const std::string& example);

/// --out where it names a folder; "-" is refused while parsing.
void addOutputFolderOption(CLI::App& command, std::string& out);

} // namespace straightedge::cli
