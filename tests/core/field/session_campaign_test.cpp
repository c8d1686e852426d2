// From samples of a session to the campaign, and on to campaign.csv and back.
#include "core/field/campaign_csv.h"
#include "core/field/session_campaign.h"
#include "devices/simulated/hall_campaign.h"
#include "tests/core/session/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace straightedge::field {
namespace {

session::FieldSample sampleOf(int stage, int attempt, double rawT) {
  session::FieldSample sample;
  sample.stage = stage;
  sample.attempt = attempt;
  sample.step = 2;
  sample.rawT = {rawT, 0.0, 0.0};
  return sample;
}

TEST(SessionCampaignTest, OfAStageMeasuredAgainOnlyTheLatestAttemptCountsAtItsPlace) {
  const auto campaign = campaignFromSamples(
      {sampleOf(0, 0, 1.0), sampleOf(0, 0, 2.0), sampleOf(1, 0, 3.0), sampleOf(0, 1, 4.0), sampleOf(0, 1, 5.0)}, "x");
  ASSERT_TRUE(campaign);
  ASSERT_EQ(campaign->rows.size(), 3U);
  EXPECT_EQ(campaign->rows[0].rawT[0], 4.0);
  EXPECT_EQ(campaign->rows[1].rawT[0], 5.0);
  EXPECT_EQ(campaign->rows[2].rawT[0], 3.0);
  EXPECT_EQ(campaign->rows[2].line, 4);
}

TEST(SessionCampaignTest, RefusesNumbersThatMeanNothing) {
  for (const int bad : {-1, 8}) {
    session::FieldSample sample = sampleOf(0, 0, 0.0);
    sample.step = bad;
    EXPECT_FALSE(campaignFromSamples({sample}, "x"));
  }
  session::FieldSample sample = sampleOf(0, 0, 0.0);
  sample.axis = 3;
  EXPECT_FALSE(campaignFromSamples({sample}, "x"));
}

void expectSameRow(const CampaignRow& a, const CampaignRow& b) {
  const auto same = [](double one, double other) { return one == other || (std::isnan(one) && std::isnan(other)); };
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.axis, b.axis);
  EXPECT_EQ(a.orientation, b.orientation);
  EXPECT_EQ(a.locked, b.locked);
  EXPECT_TRUE(same(a.referenceT, b.referenceT));
  EXPECT_TRUE(same(a.chamberC, b.chamberC));
  EXPECT_TRUE(same(a.pt100Ohm, b.pt100Ohm));
  EXPECT_TRUE(same(a.electronicsC, b.electronicsC));
  EXPECT_EQ(a.rawT, b.rawT);
  EXPECT_TRUE(same(a.timeS, b.timeS));
}

TEST(SessionCampaignTest, ACampaignComesThroughSessionAndCsvToTheLastBit) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder / "hall.sedge";
  const Campaign original = devices::makeHallCampaign(devices::quickHallCampaign(4));
  {
    auto session = *session::Session::create(file, session::SessionKind::Field);
    std::vector<session::FieldSample> samples;
    for (const CampaignRow& row : original.rows) {
      samples.push_back(sampleFromRow(row));
      samples.back().sequence = static_cast<std::int64_t>(samples.size()) - 1;
      samples.back().stage = static_cast<int>(row.step);
    }
    auto sink = *session->fieldSink(session::SweepRole::Calibration);
    ASSERT_TRUE(sink->append(samples));
    ASSERT_TRUE(sink->commit());
    sink.reset();
    ASSERT_TRUE(session->close());
  }
  const auto read = readSessionCampaign(file.string(), session::SweepRole::Calibration);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->campaign.name, "hall.sedge");
  const auto fromCsv = parseCampaignCsv(campaignCsv(read->campaign), "hall.csv", "hall.csv");
  ASSERT_TRUE(fromCsv) << fromCsv.error().message();
  EXPECT_EQ(fromCsv->sha256, read->campaign.sha256);
  ASSERT_EQ(read->campaign.rows.size(), original.rows.size());
  ASSERT_EQ(fromCsv->rows.size(), original.rows.size());
  for (std::size_t i = 0; i < original.rows.size(); ++i) {
    expectSameRow(read->campaign.rows[i], original.rows[i]);
    expectSameRow(fromCsv->rows[i], original.rows[i]);
    EXPECT_EQ(fromCsv->rows[i].line, read->campaign.rows[i].line);
  }
  EXPECT_FALSE(readSessionCampaign(file.string(), session::SweepRole::Verification));
}

TEST(SessionCampaignTest, AnAngleSessionIsRefused) {
  const tests::TemporaryFolder folder;
  ASSERT_TRUE(session::Session::create(folder / "angle.sedge", session::SessionKind::Angle));
  const auto read = readSessionCampaign((folder / "angle.sedge").string(), session::SweepRole::Calibration);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().kind, ErrorKind::Input);
  EXPECT_EQ(read.error().what, "this session is not a field calibration");
}

} // namespace
} // namespace straightedge::field
