#include "app/cli/session_export.h"

#include "core/angle/session_sweep.h"
#include "core/angle/sweep_csv.h"
#include "core/base/file_output.h"
#include "core/field/campaign_csv.h"
#include "core/field/session_campaign.h"

namespace straightedge::cli {

namespace {

Result<session::SessionKind> kindOf(const std::string& path) {
  const auto opened = session::Session::openReadOnly(path);
  if (!opened) {
    return std::unexpected(opened.error());
  }
  return (*opened)->kind();
}

Result<std::string> csvOf(const std::string& path) {
  const auto kind = kindOf(path);
  if (!kind) {
    return std::unexpected(kind.error());
  }
  if (*kind == session::SessionKind::Angle) {
    const auto sweep = angle::readSessionSweep(path, session::SweepRole::Calibration);
    return sweep ? Result<std::string>(angle::sweepToCsv(sweep->sweep)) : std::unexpected(sweep.error());
  }
  const auto campaign = field::readSessionCampaign(path, session::SweepRole::Calibration);
  return campaign ? Result<std::string>(field::campaignCsv(campaign->campaign)) : std::unexpected(campaign.error());
}

} // namespace

Result<void> exportSession(const std::string& session, const std::string& format, const std::string& out) {
  if (format != "csv") {
    return fail(ErrorKind::Usage, "a session's raw samples are exported as csv, not as " + format,
                "give --format csv, or fit the session first and export its calibration.json", session);
  }
  const auto csv = csvOf(session);
  if (!csv) {
    return std::unexpected(csv.error());
  }
  return writeFileWhole(out, *csv);
}

} // namespace straightedge::cli
