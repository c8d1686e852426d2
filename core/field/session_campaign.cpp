#include "core/field/session_campaign.h"

#include "core/base/sha256.h"
#include "core/field/campaign_csv.h"
#include "core/field/names.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace straightedge::field {

namespace {

bool isWithin(int value, std::size_t count) { return value >= 0 && static_cast<std::size_t>(value) < count; }

bool isKnown(const session::FieldSample& sample) {
  return isWithin(sample.step, allSteps.size()) && (!sample.axis || isWithin(*sample.axis, allAxes.size())) &&
         (!sample.orientation || isWithin(*sample.orientation, allOrientations.size()));
}

CampaignRow rowOf(const session::FieldSample& sample) {
  CampaignRow row;
  row.step = static_cast<CampaignStep>(sample.step);
  row.axis = sample.axis ? std::optional(static_cast<Axis>(*sample.axis)) : std::nullopt;
  row.orientation = sample.orientation ? std::optional(static_cast<Orientation>(*sample.orientation)) : std::nullopt;
  row.locked = sample.locked;
  row.referenceT = sample.referenceT.value_or(emptyCell);
  row.chamberC = sample.chamberC.value_or(emptyCell);
  row.pt100Ohm = sample.pt100Ohm.value_or(emptyCell);
  row.electronicsC = sample.electronicsC.value_or(emptyCell);
  row.rawT = sample.rawT;
  row.timeS = sample.timeS;
  return row;
}

} // namespace

Result<Campaign> campaignFromSamples(const std::vector<session::FieldSample>& samples, const std::string& name) {
  std::map<int, int> latest; // of each stage
  for (const session::FieldSample& sample : samples) {
    if (!isKnown(sample)) {
      return fail(ErrorKind::Storage, "sample " + std::to_string(sample.sequence) + " belongs to no known step or axis",
                  "use a copy from your backup", name);
    }
    int& attempt = latest.try_emplace(sample.stage, sample.attempt).first->second;
    attempt = std::max(attempt, sample.attempt);
  }
  Campaign campaign{.name = name, .sha256 = {}, .rows = {}};
  campaign.rows.reserve(samples.size());
  for (const auto& [stage, attempt] : latest) {
    for (const session::FieldSample& sample : samples) {
      if (sample.stage == stage && sample.attempt == attempt) {
        campaign.rows.push_back(rowOf(sample));
        campaign.rows.back().line = static_cast<std::int64_t>(campaign.rows.size()) + 1;
      }
    }
  }
  return campaign;
}

session::FieldSample sampleFromRow(const CampaignRow& row) {
  const auto recorded = [](double value) { return std::isnan(value) ? std::nullopt : std::optional(value); };
  session::FieldSample sample;
  sample.timeS = std::isnan(row.timeS) ? 0.0 : row.timeS;
  sample.step = static_cast<int>(row.step);
  sample.axis = row.axis ? std::optional(static_cast<int>(*row.axis)) : std::nullopt;
  sample.orientation = row.orientation ? std::optional(static_cast<int>(*row.orientation)) : std::nullopt;
  sample.locked = row.locked;
  sample.referenceT = recorded(row.referenceT);
  sample.chamberC = recorded(row.chamberC);
  sample.pt100Ohm = recorded(row.pt100Ohm);
  sample.electronicsC = recorded(row.electronicsC);
  sample.rawT = row.rawT;
  return sample;
}

Result<SessionCampaign> readSessionCampaign(const std::string& path, session::SweepRole role) {
  const auto opened = session::Session::openReadOnly(path);
  if (!opened) {
    return std::unexpected(opened.error());
  }
  const session::Session& session = **opened;
  if (session.kind() != session::SessionKind::Field) {
    return fail(ErrorKind::Input, "this session is not a field calibration", "choose another session", path);
  }
  const auto samples = session.fieldSamples(role);
  if (!samples) {
    return std::unexpected(samples.error());
  }
  if (samples->empty()) {
    return fail(ErrorKind::Input,
                role == session::SweepRole::Calibration ? "the session holds no captured campaign"
                                                        : "the session holds no captured verification campaign",
                "capture one, or give the campaign as CSV", path);
  }
  auto campaign = campaignFromSamples(*samples, path);
  auto traceability = session.traceability();
  if (!campaign || !traceability) {
    return std::unexpected(!campaign ? std::move(campaign.error()) : std::move(traceability.error()));
  }
  campaign->name = session.file().filename().string();
  campaign->sha256 = sha256Hex(campaignCsv(*campaign));
  return SessionCampaign{*std::move(campaign), *std::move(traceability)};
}

} // namespace straightedge::field
