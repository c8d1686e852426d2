// Who, what, with what and when: travels with every result so that it can be traced back.
#pragma once

#include <optional>
#include <string>

namespace straightedge {

struct ReferenceInstrument {
  std::string model;
  std::string serial;
  std::string certificate;
  std::string due;          ///< ISO 8601 date on which its own calibration falls due
  double uncertainty = 0.0; ///< stated expanded uncertainty (k = 2): degrees for angle, tesla for field; 0 = not stated
};

struct Traceability {
  std::string deviceSerial;
  std::string deviceModel;
  std::string operatorName;
  ReferenceInstrument reference;
  std::optional<double> ambientC; ///< ambient temperature in degrees Celsius
};

/// The data a result was computed from.
struct SourceRecord {
  std::string file;   ///< file name without folder
  std::string sha256; ///< lower-case hex of the file's bytes; for a captured sweep, of its canonical CSV
  long long points = 0;
};

} // namespace straightedge
