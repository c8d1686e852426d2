// Sessions of an older file version become ones of today's without losing anything.
#include "core/session/database.h"
#include "core/session/schema.h"
#include "tests/core/session/session_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace straightedge::session {
namespace {

using testing::HasSubstr;

/// Version 0 as it was: one sweep, no attempts, no gaps.
void writeVersion0(const std::filesystem::path& file, const char* sampleColumns) {
  auto database = Database::open(file, Database::Access::Create);
  ASSERT_TRUE(database);
  const std::string sql = "PRAGMA application_id = " + std::to_string(sessionApplicationId) + R"sql(;
    CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
    INSERT INTO meta VALUES('kind', 'angle');
    CREATE TABLE document(name TEXT PRIMARY KEY, json TEXT NOT NULL) WITHOUT ROWID;
    INSERT INTO document VALUES('plan', '{"turns":3}');
    CREATE TABLE angle_sample()sql" +
                          sampleColumns + R"sql();
    INSERT INTO angle_sample(sequence, point, turn, direction, time_s, encoder_deg, sensor_deg)
      VALUES (0, 0, 0, 1, 0.5, 0.0, 280.25), (1, 1, 1, -1, 0.75, 365.5, 299.0000000000001);
  )sql";
  const auto made = (*database)->run(sql.c_str());
  ASSERT_TRUE(made) << made.error().message();
  ASSERT_TRUE((*database)->close());
}

constexpr const char* version0Columns =
    "sequence INTEGER PRIMARY KEY, point INTEGER NOT NULL, turn INTEGER NOT NULL, direction INTEGER NOT NULL, "
    "time_s REAL NOT NULL, encoder_deg REAL NOT NULL, sensor_deg REAL NOT NULL, temperature_c REAL";

std::string schemaOf(const std::filesystem::path& file) {
  auto database = Database::open(file, Database::Access::ReadOnly);
  return *(*database)->text("SELECT group_concat(sql, ';') FROM (SELECT sql FROM sqlite_schema ORDER BY name)");
}

class MigrationTest : public testing::Test {
protected:
  tests::TemporaryFolder m_folder;
  std::filesystem::path m_file = m_folder / "old.sedge";
};

TEST_F(MigrationTest, Version0GainsAttemptsSweepsAndGaps) {
  writeVersion0(m_file, version0Columns);
  {
    auto session = Session::open(m_file);
    ASSERT_TRUE(session) << session.error().message();
    const auto samples = (*session)->angleSamples(SweepRole::Calibration);
    ASSERT_TRUE(samples);
    ASSERT_EQ(samples->size(), 2U);
    const AngleSample& last = samples->back();
    EXPECT_EQ(last.sequence, 1);
    EXPECT_EQ(last.point, 1);
    EXPECT_EQ(last.attempt, 0);
    EXPECT_EQ(last.turn, 1);
    EXPECT_EQ(last.direction, -1);
    EXPECT_EQ(last.timeS, 0.75);
    EXPECT_EQ(last.encoderDeg, 365.5);
    EXPECT_EQ(last.sensorDeg, 299.0000000000001);
    EXPECT_FALSE(last.temperatureC);
    EXPECT_EQ(*(*session)->angleSampleCount(SweepRole::Verification), 0);
    EXPECT_EQ(*(*session)->document("plan"), R"({"turns":3})");
    EXPECT_TRUE((*session)->gaps(SweepRole::Calibration)->empty());
    tests::storeSamples(**session, tests::countedSamples(3, 2));
    ASSERT_TRUE((*session)->close());
  }
  EXPECT_EQ(*(*Session::open(m_file))->angleSampleCount(SweepRole::Calibration), 5);
  tests::makeClosedSession(m_folder / "new.sedge", 1);
  EXPECT_EQ(schemaOf(m_file), schemaOf(m_folder / "new.sedge")) << "old and new files are alike afterwards";
}

TEST_F(MigrationTest, AMigrationThatFailsChangesNothing) {
  writeVersion0(m_file, "sequence INTEGER PRIMARY KEY, point, turn, direction, time_s, encoder_deg, sensor_deg");
  const std::string before = tests::bytesOf(m_file);
  const auto session = Session::open(m_file);
  ASSERT_FALSE(session);
  EXPECT_EQ(session.error().kind, ErrorKind::Storage);
  EXPECT_THAT(session.error().message(), HasSubstr("no such column: temperature_c"));
  EXPECT_TRUE(before == tests::bytesOf(m_file));
}

TEST_F(MigrationTest, IsNotDoneWhereNothingMayBeWritten) {
  writeVersion0(m_file, version0Columns);
  const std::string before = tests::bytesOf(m_file);
  const auto session = Session::openReadOnly(m_file);
  ASSERT_FALSE(session);
  EXPECT_EQ(session.error().kind, ErrorKind::Storage);
  EXPECT_THAT(session.error().message(), HasSubstr("older file version 0"));
  EXPECT_TRUE(before == tests::bytesOf(m_file));
}

} // namespace
} // namespace straightedge::session
