// capture field from its command line to session, CSV and what the field commands read.
#include "app/cli/campaign_input.h"
#include "app/cli/capture_command.h"
#include "app/cli/session_export.h"
#include "core/field/campaign_csv.h"
#include "core/field/session_campaign.h"
#include "tests/core/session/session_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace straightedge::cli {
namespace {

using testing::HasSubstr;

class FieldCaptureCommandTest : public testing::Test {
protected:
  tests::TemporaryFolder m_folder;
  std::string m_session = (m_folder / "hall.sedge").string();
  std::string m_output;

  Result<void> run(const std::string& options) {
    CLI::App program;
    std::function<Result<void>()> chosen;
    addCaptureCommand(program, [&chosen](std::function<Result<void>()> capture) { chosen = std::move(capture); });
    std::istringstream words("capture field --bench simulated --session " + m_session + " " + options);
    std::vector<std::string> arguments{std::istream_iterator<std::string>(words), {}};
    std::reverse(arguments.begin(), arguments.end());
    program.parse(arguments);
    testing::internal::CaptureStdout();
    auto outcome = chosen();
    m_output = testing::internal::GetCapturedStdout();
    return outcome;
  }
};

TEST_F(FieldCaptureCommandTest, CapturesAWholeCampaignThatReadsBackAlikeFromSessionAndCsv) {
  const std::string csv = (m_folder / "campaign.csv").string();
  const auto outcome = run("--fields -2,-1,-0.5,0.5,1,2 --rows 3 --sweep-rows 20 --serial H7 --csv " + csv);
  ASSERT_TRUE(outcome) << outcome.error().message();
  EXPECT_THAT(m_output, HasSubstr("21 stages"));
  EXPECT_THAT(m_output, HasSubstr("next: straightedge-cli field fit " + m_session));
  const auto fromSession = loadCampaign(m_session);
  const auto fromCsv = loadCampaign(csv);
  ASSERT_TRUE(fromSession && fromCsv);
  EXPECT_EQ(fromSession->traceability.deviceSerial, "H7");
  EXPECT_EQ(fromSession->campaign.sha256, fromCsv->campaign.sha256);
  const std::string exported = (m_folder / "exported.csv").string();
  ASSERT_TRUE(exportSession(m_session, "csv", exported));
  EXPECT_EQ(tests::bytesOf(exported), tests::bytesOf(csv));
  EXPECT_FALSE(exportSession(m_session, "json", exported));
  EXPECT_TRUE(run("--resume")) << "nothing left to do";
  EXPECT_EQ(loadCampaign(m_session)->campaign.sha256, fromCsv->campaign.sha256);
}

TEST_F(FieldCaptureCommandTest, TheSameSeedGivesTheSameCampaign) {
  const auto campaignOf = [this](const std::string& options) {
    std::filesystem::remove(m_session);
    EXPECT_TRUE(run("--stages offset --sweep-rows 20 " + options));
    return loadCampaign(m_session)->campaign.sha256;
  };
  const std::string first = campaignOf("--seed 5");
  EXPECT_EQ(campaignOf("--seed 5"), first);
  EXPECT_NE(campaignOf("--seed 6"), first);
}

TEST_F(FieldCaptureCommandTest, RefusesWhatItCannotDo) {
  const auto kindOf = [this](const std::string& options) {
    const auto outcome = run(options);
    EXPECT_FALSE(outcome) << options;
    EXPECT_FALSE(std::filesystem::exists(m_session)) << "nothing half-made is left";
    return outcome ? ErrorKind::Cancelled : outcome.error().kind;
  };
  EXPECT_EQ(kindOf("--stages guess"), ErrorKind::Usage);
  EXPECT_EQ(kindOf("--axes w"), ErrorKind::Usage);
  EXPECT_EQ(kindOf("--rows 0"), ErrorKind::Usage);
  EXPECT_EQ(kindOf("--fields 99"), ErrorKind::Usage);
  EXPECT_EQ(kindOf("--temperatures 40,10"), ErrorKind::Usage);
  EXPECT_EQ(kindOf("--noise -1"), ErrorKind::Usage);
  EXPECT_EQ(kindOf("--resume"), ErrorKind::Input);
  ASSERT_TRUE(run("--stages offset --sweep-rows 20"));
  EXPECT_EQ(run("--stages offset").error().kind, ErrorKind::Storage);
  EXPECT_EQ(run("--resume --rows 7").error().kind, ErrorKind::Usage);
}

} // namespace
} // namespace straightedge::cli
