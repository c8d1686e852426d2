#include "app/cli/options.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace straightedge::cli {

namespace {

/// YYYY-MM-DD, a day that exists.
bool isDate(const std::string& text) {
  if (text.size() != 10 || text[4] != '-' || text[7] != '-') {
    return false;
  }
  const auto year = parseInt(text.substr(0, 4));
  const auto month = parseInt(text.substr(5, 2));
  const auto day = parseInt(text.substr(8, 2));
  return year && month && day && *month > 0 && *day > 0 &&
         std::chrono::year_month_day(std::chrono::year(*year), std::chrono::month(static_cast<unsigned>(*month)),
                                     std::chrono::day(static_cast<unsigned>(*day)))
             .ok();
}

std::string range(const std::string& least, const std::string& most) { return "from " + least + " to " + most; }

} // namespace

void addTraceabilityOptions(CLI::App& command, TraceabilityOptions& options, bool withSerial,
                            const char* referenceUnit) {
  const char* group = "Traceability";
  if (withSerial) {
    command.add_option("--serial", options.serial, "Serial number of the sensor")->type_name("TEXT")->group(group);
  }
  const auto add = [&](const char* name, std::string& value, const char* type, const char* help) {
    command.add_option(name, value, help)->type_name(type)->group(group);
  };
  add("--device-model", options.deviceModel, "TEXT", "Model of the sensor");
  add("--operator", options.operatorName, "TEXT", "Who measured");
  add("--reference-model", options.referenceModel, "TEXT", "Model of the reference");
  add("--reference-serial", options.referenceSerial, "TEXT", "Its serial number");
  add("--reference-certificate", options.referenceCertificate, "TEXT", "Its calibration certificate");
  add("--reference-due", options.referenceDue, "YYYY-MM-DD", "When its own calibration falls due");
  add("--reference-uncertainty", options.referenceUncertainty, referenceUnit,
      "Its stated expanded uncertainty (k = 2)");
  add("--ambient", options.ambient, "CELSIUS", "Ambient temperature");
}

Result<Traceability> traceabilityFrom(const TraceabilityOptions& options) {
  Traceability traceability;
  traceability.deviceSerial = options.serial;
  traceability.deviceModel = options.deviceModel;
  traceability.operatorName = options.operatorName;
  traceability.reference = {options.referenceModel, options.referenceSerial, options.referenceCertificate,
                            options.referenceDue, 0.0};
  if (!options.referenceDue.empty() && !isDate(options.referenceDue)) {
    return fail(ErrorKind::Usage, "--reference-due " + options.referenceDue + " is no date",
                "write it as in --reference-due 2027-01-31");
  }
  if (!options.referenceUncertainty.empty()) {
    const auto value = optionNumber("--reference-uncertainty", options.referenceUncertainty, 0.0, 180.0, "0.002");
    if (!value) {
      return std::unexpected(value.error());
    }
    traceability.reference.uncertainty = *value;
  }
  if (!options.ambient.empty()) {
    const auto value = optionNumber("--ambient", options.ambient, -273.15, 1000.0, "23.5");
    if (!value) {
      return std::unexpected(value.error());
    }
    traceability.ambientC = *value;
  }
  return traceability;
}

void addModelOptions(CLI::App& command, ModelOptions& options) {
  command
      .add_option(
          "--model", options.models,
          "Model KIND:SIZE[@METHOD][/BITS], may be given several times; without it harmonic:4, linear:32, lut:64")
      ->type_name("MODEL")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--curve", options.curve, "How the correction curve is drawn through the points")
      ->check(CLI::IsMember({"auto", "interpolate", "regress"}))
      ->type_name("auto|interpolate|regress");
}

Result<angle::CalibrationOptions> calibrationOptionsFrom(const ModelOptions& options) {
  angle::CalibrationOptions result;
  result.curve.method = options.curve == "interpolate" ? angle::CurveMethod::Interpolate
                        : options.curve == "regress"   ? angle::CurveMethod::Regress
                                                       : angle::CurveMethod::Auto;
  if (options.models.empty()) {
    return result;
  }
  result.models.clear();
  for (const std::string& text : options.models) {
    const auto name = angle::parseModelName(text);
    if (!name) {
      return std::unexpected(name.error());
    }
    if (std::find(result.models.begin(), result.models.end(), *name) != result.models.end()) {
      return fail(ErrorKind::Usage, "--model " + name->text() + " is given twice", "name each model once");
    }
    result.models.push_back(*name);
  }
  return result;
}

Result<double> optionNumber(const std::string& option, const std::string& text, double least, double most,
                            const std::string& example) {
  const auto value = parseDouble(text);
  if (!value || std::isnan(*value)) {
    return fail(ErrorKind::Usage, option + " " + text + " is no number", "write it as in " + option + " " + example);
  }
  if (*value < least || *value > most) {
    return fail(ErrorKind::Usage, option + " " + text + " is out of range",
                "give a value " + range(formatForPeople(least), formatForPeople(most)));
  }
  return *value;
}

Result<int> optionInteger(const std::string& option, const std::string& text, int least, int most,
                          const std::string& example) {
  const auto value = parseInt(text);
  if (!value && !parseDouble(text)) {
    return fail(ErrorKind::Usage, option + " " + text + " is no number", "write it as in " + option + " " + example);
  }
  if (!value || *value < least || *value > most) {
    return fail(ErrorKind::Usage, option + " " + text + " is out of range",
                "give a whole number " + range(std::to_string(least), std::to_string(most)));
  }
  return *value;
}

void addOutputFolderOption(CLI::App& command, std::string& out) {
  command.add_option("--out", out, "Folder for the results")
      ->type_name("DIR")
      ->required()
      ->check([](const std::string& text) {
        return text == "-" ? std::string("several files are written; name a folder instead of -") : std::string();
      });
}

} // namespace straightedge::cli
