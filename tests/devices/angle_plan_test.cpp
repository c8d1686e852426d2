// Plans: stations, limits, JSON.
#include "devices/capture/angle_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace straightedge::devices {
namespace {

using testing::HasSubstr;

TEST(AnglePlanTest, GoesUpAllTurnsAndComesBackOverTheSameAngles) {
  const auto points = plannedPoints({.pointsPerTurn = 8, .turns = 2, .bothDirections = true, .startDeg = 10.0});
  ASSERT_EQ(points.size(), 32U);
  for (int i = 0; i < 32; ++i) {
    EXPECT_EQ(points[static_cast<std::size_t>(i)].index, i);
  }
  EXPECT_EQ(points[0].encoderDeg, 10.0);
  EXPECT_EQ(points[15].encoderDeg, 10.0 + 360.0 + 315.0);
  EXPECT_EQ(points[15].turn, 1);
  EXPECT_EQ(points[15].direction, 1);
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_EQ(points[31 - i].encoderDeg, points[i].encoderDeg);
    EXPECT_EQ(points[31 - i].turn, points[i].turn);
    EXPECT_EQ(points[31 - i].direction, -1);
  }
}

TEST(AnglePlanTest, LimitsAreNamed) {
  EXPECT_TRUE(checkPlan({}));
  const std::vector<std::pair<AnglePlan, std::string>> cases = {
      {{.pointsPerTurn = 7}, "points per turn is 7; give 8 to 36000"},
      {{.pointsPerTurn = 36001}, "points per turn is 36001; give 8 to 36000"},
      {{.turns = 0}, "turns is 0; give 1 to 1000"},
      {{.averages = 0}, "averages is 0; give 1 to 10000"},
      {{.settleS = -0.1}, "settling time is -0.1 s; give 0 to 600 s"},
      {{.settleS = std::numeric_limits<double>::quiet_NaN()}, "settling time is nan s; give 0 to 600 s"},
      {{.startDeg = 1e6}, "start angle is 1000000°; give -360000 to 360000°"},
      {{.sampleRateHz = -5.0}, "sample rate is -5 Hz"},
      {{.pointsPerTurn = 36000, .turns = 100}, "points in all turns and directions is 3600000; give 8 to 1000000"},
  };
  for (const auto& [plan, message] : cases) {
    const auto checked = checkPlan(plan);
    ASSERT_FALSE(checked) << message;
    EXPECT_EQ(checked.error().kind, ErrorKind::Usage);
    EXPECT_THAT(checked.error().message(), HasSubstr(message));
  }
}

TEST(AnglePlanTest, SurvivesItsJson) {
  const AnglePlan plan{.pointsPerTurn = 48,
                       .turns = 3,
                       .bothDirections = true,
                       .startDeg = 0.1,
                       .settleS = 0.3,
                       .averages = 7,
                       .sampleRateHz = 10000.0};
  const auto read = planFromJson(planToJson(plan));
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, plan);
}

TEST(AnglePlanTest, RefusesJsonThatIsNoPlan) {
  for (const char* json : {"", "[]", "{}", "{\"points_per_turn\":\"many\"}", "{\"points_per_turn\":3}"}) {
    const auto read = planFromJson(json);
    ASSERT_FALSE(read) << json;
    EXPECT_EQ(read.error().kind, ErrorKind::Input);
  }
}

} // namespace
} // namespace straightedge::devices
