#include "core/field/step_rows.h"

#include "core/field/names.h"

#include <cmath>

namespace straightedge::field {

namespace {

bool isComplete(const CampaignRow& row, const StepNeeds& needs) {
  const auto known = [](double value) { return std::isfinite(value); };
  return known(row.rawT[0]) && known(row.rawT[1]) && known(row.rawT[2]) &&
         (!needs.reference || known(row.referenceT)) && (!needs.chamber || known(row.chamberC)) &&
         (!needs.pt100 || known(row.pt100Ohm)) && (!needs.electronics || known(row.electronicsC)) &&
         (!needs.orientation || row.orientation.has_value());
}

void gather(const std::vector<CampaignRow>& rows, const std::vector<std::size_t>& chosen, StepRows& part) {
  const auto count = static_cast<Eigen::Index>(chosen.size());
  for (Eigen::VectorXd* column : {&part.referenceT, &part.chamberC, &part.pt100Ohm, &part.electronicsC, &part.timeS}) {
    column->resize(count);
  }
  part.rawT.resize(count, 3);
  part.line.resize(chosen.size());
  const bool oriented = needsOf(part.step).orientation;
  part.orientation.reserve(oriented ? chosen.size() : 0);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const CampaignRow& row = rows[chosen[i]];
    const auto at = static_cast<Eigen::Index>(i);
    part.referenceT[at] = row.referenceT;
    part.chamberC[at] = row.chamberC;
    part.pt100Ohm[at] = row.pt100Ohm;
    part.electronicsC[at] = row.electronicsC;
    part.timeS[at] = row.timeS;
    part.rawT.row(at) << row.rawT[0], row.rawT[1], row.rawT[2];
    part.line[i] = row.line;
    if (oriented) {
      part.orientation.push_back(*row.orientation);
    }
  }
}

} // namespace

StepNeeds needsOf(CampaignStep step) {
  switch (step) {
  case CampaignStep::Nonlinearity:
    return {.axis = true, .reference = true};
  case CampaignStep::ProbeTemperature:
    return {.chamber = true, .pt100 = true};
  case CampaignStep::Offset:
    return {.pt100 = true};
  case CampaignStep::Sensitivity:
    return {.axis = true, .reference = true, .pt100 = true};
  case CampaignStep::Electronics:
    return {.electronics = true};
  case CampaignStep::ElectronicsSensitivity:
    return {.axis = true, .reference = true, .electronics = true};
  case CampaignStep::Orientation:
    return {.orientation = true, .reference = true};
  case CampaignStep::Verification:
    return {.axis = true, .reference = true}; // temperatures: what the chain asks for
  }
  return {};
}

CampaignParts::CampaignParts(const Campaign& campaign) {
  std::array<std::array<std::vector<std::size_t>, 3>, 8> chosen;
  std::array<StepNeeds, 8> needs;
  for (const CampaignStep step : allSteps) {
    needs[indexOf(step)] = needsOf(step);
    for (const Axis axis : allAxes) {
      StepRows& part = m_parts[indexOf(step)][indexOf(axis)];
      part.step = step;
      part.axis = needs[indexOf(step)].axis ? std::optional(axis) : std::nullopt;
    }
  }
  const StepRows* before = nullptr; // part of the row before
  double referenceBefore = 0.0;
  bool interrupted = true;
  for (std::size_t i = 0; i < campaign.rows.size(); ++i) {
    const CampaignRow& row = campaign.rows[i];
    const StepNeeds& need = needs[indexOf(row.step)];
    if (need.axis && !row.axis) {
      continue; // refused by the readers; a row without its axis belongs to no part
    }
    const std::size_t axis = need.axis ? indexOf(*row.axis) : 0;
    StepRows& part = m_parts[indexOf(row.step)][axis];
    ++part.recorded;
    interrupted = interrupted || before != &part;
    before = &part;
    if (need.reference && !row.locked) {
      ++part.unlocked;
      continue;
    }
    if (!isComplete(row, need)) {
      ++part.incomplete;
      continue;
    }
    auto& list = chosen[indexOf(row.step)][axis];
    const bool sameField = !need.reference || std::abs(row.referenceT - referenceBefore) <= plateauToleranceT;
    const bool sameRun = need.reference ? sameField && !interrupted : !list.empty();
    if (!sameRun) {
      part.runBegin.push_back(static_cast<Eigen::Index>(list.size()));
    }
    list.push_back(i);
    referenceBefore = row.referenceT;
    interrupted = false;
  }
  for (const CampaignStep step : allSteps) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      gather(campaign.rows, chosen[indexOf(step)][axis], m_parts[indexOf(step)][axis]);
    }
  }
}

const StepRows& CampaignParts::of(CampaignStep step, Axis axis) const { return m_parts[indexOf(step)][indexOf(axis)]; }

const StepRows& CampaignParts::of(CampaignStep step) const { return m_parts[indexOf(step)][0]; }

std::size_t CampaignParts::recorded(CampaignStep step) const {
  std::size_t count = 0;
  for (const StepRows& part : m_parts[indexOf(step)]) {
    count += part.recorded;
  }
  return count;
}

} // namespace straightedge::field
