// Files that are no sessions, or not whole ones: refused with a reason and what to do, and left as they were.
#include "core/session/database.h"
#include "core/session/schema.h"
#include "tests/core/session/session_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace straightedge::session {
namespace {

using testing::HasSubstr;

class DamagedSessionTest : public testing::Test {
protected:
  void SetUp() override { tests::makeClosedSession(m_file, 5000); }

  void expectRefused(ErrorKind kind, const std::string& what, const std::string& remedy) {
    const std::string before = tests::bytesOf(m_file);
    for (const auto& outcome : {Session::open(m_file), Session::openReadOnly(m_file)}) {
      ASSERT_FALSE(outcome);
      EXPECT_EQ(outcome.error().kind, kind) << outcome.error().message();
      EXPECT_EQ(outcome.error().where, m_file.string());
      EXPECT_THAT(outcome.error().what, HasSubstr(what));
      EXPECT_THAT(outcome.error().remedy, HasSubstr(remedy));
    }
    EXPECT_TRUE(before == tests::bytesOf(m_file)) << "a refused file stays as it was";
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(m_folder.path()), {}), 1) << "and nothing is left";
  }
  void damage(const char* sql) {
    auto database = Database::open(m_file, Database::Access::ReadWrite);
    ASSERT_TRUE(database);
    const auto run = (*database)->run(sql);
    ASSERT_TRUE(run) << run.error().message();
  }

  tests::TemporaryFolder m_folder;
  std::filesystem::path m_file = m_folder / "a.sedge";
};

TEST_F(DamagedSessionTest, Missing) {
  std::filesystem::remove(m_file);
  const auto outcome = Session::open(m_file);
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, ErrorKind::Input);
  EXPECT_EQ(outcome.error().message(), m_file.string() + ": there is no such file; see to the name and the folder");
  EXPECT_FALSE(std::filesystem::exists(m_file));
}

TEST_F(DamagedSessionTest, Folder) {
  const auto outcome = Session::open(m_folder.path());
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, ErrorKind::Input);
  EXPECT_THAT(outcome.error().message(), HasSubstr("this is not a file; choose a .sedge file"));
}

TEST_F(DamagedSessionTest, Empty) {
  tests::writeBytes(m_file, "");
  expectRefused(ErrorKind::Input, "the file is empty", "backup");
}

TEST_F(DamagedSessionTest, Text) {
  tests::writeBytes(m_file, "encoder_deg,sensor_deg\n0,266.31\n");
  expectRefused(ErrorKind::Input, "not a Straightedge session", "choose a .sedge file");
}

TEST_F(DamagedSessionTest, RandomBytes) {
  std::mt19937 random(1);
  std::string bytes(50000, '\0');
  for (char& byte : bytes) {
    byte = static_cast<char>(random() & 255U);
  }
  tests::writeBytes(m_file, bytes);
  expectRefused(ErrorKind::Input, "not a Straightedge session", "choose a .sedge file");
}

TEST_F(DamagedSessionTest, DatabaseOfAnotherProgram) {
  damage("PRAGMA application_id = 7");
  expectRefused(ErrorKind::Input, "database of another program", "choose a .sedge file");
}

TEST_F(DamagedSessionTest, LaterVersionNamesBoth) {
  damage("PRAGMA user_version = 4711");
  expectRefused(ErrorKind::Input,
                "(file version 4711, this program knows up to " + std::to_string(Session::schemaVersion) + ")",
                "install the newer program");
}

TEST_F(DamagedSessionTest, NegativeVersion) {
  damage("PRAGMA user_version = -3");
  expectRefused(ErrorKind::Storage, "its version is -3", "backup");
}

TEST_F(DamagedSessionTest, MissingTables) {
  for (const char* table : {"sample_gap", "angle_sample", "document", "meta"}) {
    damage((std::string("DROP TABLE ") + table).c_str());
    expectRefused(ErrorKind::Storage, std::string("table ") + table + " is missing", "sqlite3 FILE .recover");
  }
}

TEST_F(DamagedSessionTest, UnknownKind) {
  damage("UPDATE meta SET value = 'wind' WHERE key = 'kind'");
  const auto outcome = Session::open(m_file);
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, ErrorKind::Storage);
  EXPECT_THAT(outcome.error().what, HasSubstr("its kind is 'wind'"));
}

TEST_F(DamagedSessionTest, Truncated) {
  const auto size = std::filesystem::file_size(m_file);
  ASSERT_GT(size, 100000U);
  for (const auto length : {size - 1, size - 5000, size / 2, std::uintmax_t{4096}}) {
    std::filesystem::resize_file(m_file, length);
    expectRefused(ErrorKind::Storage, "the session file is damaged", "sqlite3 FILE .recover");
  }
  std::filesystem::resize_file(m_file, 50);
  expectRefused(ErrorKind::Input, "not a Straightedge session", "backup");
}

TEST_F(DamagedSessionTest, OverwrittenPages) {
  std::string bytes = tests::bytesOf(m_file);
  std::mt19937 random(2);
  for (std::size_t i = 12288; i < 20480; ++i) {
    bytes[i] = static_cast<char>(random() & 255U);
  }
  tests::writeBytes(m_file, bytes);
  expectRefused(ErrorKind::Storage, "the session file is damaged", "backup");
}

TEST_F(DamagedSessionTest, AnyDamageIsSurvivedAndARefusedFileIsUntouched) {
  const std::string whole = tests::bytesOf(m_file);
  std::mt19937 random(3);
  int refused = 0;
  for (int round = 0; round < 150; ++round) {
    std::string bytes = whole;
    const std::size_t at = random() % bytes.size();
    const std::size_t length = std::min<std::size_t>(1 + random() % 300, bytes.size() - at);
    for (std::size_t i = at; i < at + length; ++i) {
      bytes[i] = static_cast<char>(random() & 255U);
    }
    tests::writeBytes(m_file, bytes);
    auto opened = Session::open(m_file);
    if (!opened) {
      ++refused;
      EXPECT_FALSE(opened.error().what.empty());
      ASSERT_TRUE(tests::bytesOf(m_file) == bytes) << "round " << round << " byte " << at;
    } else {
      std::ignore = (*opened)->angleSamples(SweepRole::Calibration); // an answer or an error, but an end
      std::ignore = (*opened)->close();
    }
  }
  EXPECT_GT(refused, 30);
}

} // namespace
} // namespace straightedge::session
