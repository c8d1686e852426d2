#include "app/gui/document/campaign_runs.h"

#include <cmath>

namespace straightedge::gui {

namespace {
constexpr double samePlateauT = 0.010; // interfaces.md: locked reference within 10 mT of the row before
} // namespace

std::vector<CampaignRun> campaignRuns(const field::Campaign& campaign) {
  std::vector<CampaignRun> runs;
  double lastT = field::emptyCell;
  double sumT = 0.0;
  std::size_t references = 0;
  const auto finish = [&] {
    if (!runs.empty() && references > 0) {
      runs.back().referenceT = sumT / static_cast<double>(references);
    }
    lastT = field::emptyCell;
    sumT = 0.0;
    references = 0;
  };
  for (std::size_t i = 0; i < campaign.rows.size(); ++i) {
    const auto& row = campaign.rows[i];
    const bool measured = row.locked && std::isfinite(row.referenceT);
    const bool goesOn = !runs.empty() && runs.back().step == row.step && runs.back().axis == row.axis &&
                        runs.back().orientation == row.orientation &&
                        !(measured && std::isfinite(lastT) && std::abs(row.referenceT - lastT) > samePlateauT);
    if (!goesOn) {
      finish();
      runs.push_back({.step = row.step, .axis = row.axis, .orientation = row.orientation, .first = i});
    }
    auto& run = runs.back();
    ++run.count;
    run.locked += row.locked ? 1U : 0U;
    if (measured) {
      lastT = row.referenceT;
      sumT += row.referenceT;
      ++references;
    }
  }
  finish();
  return runs;
}

} // namespace straightedge::gui
