#include "app/cli/sweep_input.h"

#include "core/angle/sweep_csv.h"

#include <utility>

namespace straightedge::cli {

Result<angle::SessionSweep> loadSweep(const std::string& path, session::SweepRole role) {
  if (angle::isSessionFile(path)) {
    return angle::readSessionSweep(path, role);
  }
  auto sweep = angle::readSweepCsv(path);
  if (!sweep) {
    return std::unexpected(std::move(sweep.error()));
  }
  return angle::SessionSweep{*std::move(sweep), {}};
}

Traceability completed(Traceability given, const Traceability& fromSession) {
  const auto complete = [](std::string& field, const std::string& stored) {
    if (field.empty()) {
      field = stored;
    }
  };
  complete(given.deviceSerial, fromSession.deviceSerial);
  complete(given.deviceModel, fromSession.deviceModel);
  complete(given.operatorName, fromSession.operatorName);
  complete(given.reference.model, fromSession.reference.model);
  complete(given.reference.serial, fromSession.reference.serial);
  complete(given.reference.certificate, fromSession.reference.certificate);
  complete(given.reference.due, fromSession.reference.due);
  if (given.reference.uncertainty == 0.0) {
    given.reference.uncertainty = fromSession.reference.uncertainty;
  }
  if (!given.ambientC) {
    given.ambientC = fromSession.ambientC;
  }
  return given;
}

} // namespace straightedge::cli
