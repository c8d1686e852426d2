// The teslameter campaign of tests/data/field, read once.
#pragma once

#include "core/field/campaign_csv.h"
#include "core/field/step_rows.h"

#include <gtest/gtest.h>

namespace straightedge::field {

inline const Campaign& exampleCampaign() {
  static const Campaign campaign = [] {
    auto read = readCampaignCsv(STRAIGHTEDGE_TEST_DATA "/field/campaign.csv");
    EXPECT_TRUE(read) << (read ? "" : read.error().message());
    return read ? *std::move(read) : Campaign{};
  }();
  return campaign;
}

inline const CampaignParts& exampleParts() {
  static const CampaignParts parts(exampleCampaign());
  return parts;
}

} // namespace straightedge::field
