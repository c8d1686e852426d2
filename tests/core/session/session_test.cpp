// Life of a session file: created, filled, closed, opened again, copied.
#include "core/session/session.h"
#include "tests/core/session/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <vector>

namespace straightedge::session {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::vector<AngleSample> someSamples(int count, std::int64_t first = 0) {
  std::vector<AngleSample> samples;
  for (int i = 0; i < count; ++i) {
    AngleSample sample;
    sample.sequence = first + i;
    sample.point = i / 2;
    sample.attempt = i % 3;
    sample.turn = i / 4;
    sample.direction = i % 2 == 0 ? 1 : -1;
    sample.timeS = 0.1 * i;
    sample.encoderDeg = 11.25 * i;
    sample.sensorDeg = 359.99999999999994 - i;
    if (i % 2 == 0) {
      sample.temperatureC = 23.0 + 0.01 * i;
    }
    samples.push_back(sample);
  }
  return samples;
}

bool operator==(const AngleSample& a, const AngleSample& b) {
  return a.sequence == b.sequence && a.point == b.point && a.attempt == b.attempt && a.turn == b.turn &&
         a.direction == b.direction && a.timeS == b.timeS && a.encoderDeg == b.encoderDeg &&
         a.sensorDeg == b.sensorDeg && a.temperatureC == b.temperatureC;
}

void expectSame(const std::vector<AngleSample>& actual, const std::vector<AngleSample>& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    EXPECT_TRUE(actual[i] == expected[i]) << "sample " << i;
  }
}

class SessionTest : public testing::Test {
protected:
  tests::TemporaryFolder m_folder;
  std::filesystem::path m_file = m_folder / "motor 7 µ%?#.sedge";

  std::unique_ptr<Session> create() {
    auto session = Session::create(m_file, SessionKind::Angle);
    EXPECT_TRUE(session) << session.error().message();
    return *std::move(session);
  }
  std::unique_ptr<Session> open() {
    auto session = Session::open(m_file);
    EXPECT_TRUE(session) << session.error().message();
    return *std::move(session);
  }
  static void store(Session& session, const std::vector<AngleSample>& samples,
                    SweepRole role = SweepRole::Calibration) {
    auto sink = session.angleSink(role);
    ASSERT_TRUE(sink);
    ASSERT_TRUE((*sink)->append(samples));
    ASSERT_TRUE((*sink)->commit());
  }
};

TEST_F(SessionTest, KeepsSamplesOfBothSweepsToTheLastBit) {
  {
    auto session = create();
    store(*session, someSamples(9));
    store(*session, someSamples(3), SweepRole::Verification);
    ASSERT_TRUE(session->close());
  }
  auto session = open();
  EXPECT_EQ(session->kind(), SessionKind::Angle);
  EXPECT_FALSE(session->readOnly());
  expectSame(*session->angleSamples(SweepRole::Calibration), someSamples(9));
  expectSame(*session->angleSamples(SweepRole::Verification), someSamples(3));
  EXPECT_EQ(*session->angleSampleCount(SweepRole::Calibration), 9);
}

TEST_F(SessionTest, KeepsDocumentsAndTraceability) {
  Traceability traceability;
  traceability.deviceSerial = "S-0007";
  traceability.deviceModel = "A1339";
  traceability.operatorName = "Zoë";
  traceability.reference = {"ROD 280", "123", "K-99", "2027-01-31", 0.0014};
  traceability.ambientC = 22.75;
  {
    auto session = create();
    EXPECT_EQ(*session->document("plan"), "");
    EXPECT_EQ(session->traceability()->deviceSerial, "");
    ASSERT_TRUE(session->setDocument("plan", R"({"turns":1})"));
    ASSERT_TRUE(session->setDocument("plan", R"({"turns":2})"));
    ASSERT_TRUE(session->setTraceability(traceability));
  }
  auto session = open();
  EXPECT_EQ(*session->document("plan"), R"({"turns":2})");
  const auto read = session->traceability();
  ASSERT_TRUE(read);
  EXPECT_EQ(read->deviceSerial, "S-0007");
  EXPECT_EQ(read->deviceModel, "A1339");
  EXPECT_EQ(read->operatorName, "Zoë");
  EXPECT_EQ(read->reference.model, "ROD 280");
  EXPECT_EQ(read->reference.serial, "123");
  EXPECT_EQ(read->reference.certificate, "K-99");
  EXPECT_EQ(read->reference.due, "2027-01-31");
  EXPECT_EQ(read->reference.uncertainty, 0.0014);
  EXPECT_EQ(read->ambientC, 22.75);
}

TEST_F(SessionTest, RecordsGaps) {
  {
    auto session = create();
    auto sink = session->angleSink(SweepRole::Calibration);
    ASSERT_TRUE((*sink)->recordGap({17, 3, "memory ran over"}));
    ASSERT_TRUE((*sink)->commit());
  }
  const auto gaps = open()->gaps(SweepRole::Calibration);
  ASSERT_TRUE(gaps);
  ASSERT_EQ(gaps->size(), 1U);
  EXPECT_EQ(gaps->front().firstMissing, 17);
  EXPECT_EQ(gaps->front().count, 3);
  EXPECT_EQ(gaps->front().reason, "memory ran over");
}

TEST_F(SessionTest, LeavesOneFileBehindWhenClosed) {
  {
    auto session = create();
    store(*session, someSamples(100));
  }
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(m_folder.path())) {
    names.push_back(entry.path().filename().string());
  }
  EXPECT_THAT(names, testing::ElementsAre(m_file.filename().string()));
  std::ifstream stream(m_file, std::ios::binary);
  std::string header(20, '\0');
  stream.read(header.data(), 20);
  EXPECT_EQ(header[18], 1) << "1: rollback journal, 2: write-ahead log";
}

TEST_F(SessionTest, RefusesToOverwrite) {
  std::ofstream(m_file) << "precious";
  const auto session = Session::create(m_file, SessionKind::Angle);
  ASSERT_FALSE(session);
  EXPECT_EQ(session.error().kind, ErrorKind::Storage);
  EXPECT_THAT(session.error().message(), HasSubstr("the file exists already; open it, or choose another name"));
  std::string content;
  std::ifstream(m_file) >> content;
  EXPECT_EQ(content, "precious");
}

TEST_F(SessionTest, SaysWhereAFolderIsMissing) {
  const auto file = m_folder / "nowhere" / "a.sedge";
  const auto session = Session::create(file, SessionKind::Angle);
  ASSERT_FALSE(session);
  EXPECT_EQ(session.error().kind, ErrorKind::Storage);
  EXPECT_EQ(session.error().where, file.string());
  EXPECT_THAT(session.error().what, HasSubstr("No such file or directory"));
}

TEST_F(SessionTest, RemembersFieldSessions) {
  ASSERT_TRUE(Session::create(m_file, SessionKind::Field));
  EXPECT_EQ(open()->kind(), SessionKind::Field);
}

TEST_F(SessionTest, ClearedSamplesAreGoneFromViewAndLeaveWithTheNextWrite) {
  auto session = create();
  store(*session, someSamples(5));
  ASSERT_TRUE(session->clearSamples(SweepRole::Calibration));
  EXPECT_THAT(*session->angleSamples(SweepRole::Calibration), IsEmpty());
  EXPECT_EQ(*session->angleSampleCount(SweepRole::Calibration), 0);
  store(*session, someSamples(2));
  expectSame(*session->angleSamples(SweepRole::Calibration), someSamples(2));
  ASSERT_TRUE(session->clearSamples(SweepRole::Calibration));
  ASSERT_TRUE(session->close());
  EXPECT_EQ(*open()->angleSampleCount(SweepRole::Calibration), 0);
}

TEST_F(SessionTest, SavesACopyWhileASinkIsOpen) {
  auto session = create();
  ASSERT_TRUE(session->setDocument("plan", "{}"));
  auto sink = session->angleSink(SweepRole::Calibration);
  ASSERT_TRUE((*sink)->append(someSamples(7)));
  ASSERT_TRUE((*sink)->commit());
  const auto copy = m_folder / "copy.sedge";
  std::ofstream(copy) << "the user agreed to replace this";
  const auto copied = session->copyTo(copy);
  ASSERT_TRUE(copied) << copied.error().message();
  const auto other = Session::open(copy);
  ASSERT_TRUE(other) << other.error().message();
  expectSame(*(*other)->angleSamples(SweepRole::Calibration), someSamples(7));
  EXPECT_EQ(*(*other)->document("plan"), "{}");
}

TEST_F(SessionTest, ACopyHoldsWhatTheSessionShows) {
  auto session = create();
  store(*session, someSamples(7));
  ASSERT_TRUE(session->clearSamples(SweepRole::Calibration));
  ASSERT_TRUE(session->copyTo(m_folder / "copy.sedge"));
  EXPECT_EQ(*(*Session::open(m_folder / "copy.sedge"))->angleSampleCount(SweepRole::Calibration), 0);
}

TEST_F(SessionTest, DoesNotCopyOntoItself) {
  auto session = create();
  const auto copied = session->copyTo(m_file);
  ASSERT_FALSE(copied);
  EXPECT_THAT(copied.error().message(), HasSubstr("this is the session's own file; choose another name"));
}

TEST_F(SessionTest, DoesNotCloseUnderASink) {
  auto session = create();
  auto sink = session->angleSink(SweepRole::Calibration);
  ASSERT_FALSE(session->close());
  ASSERT_TRUE((*sink)->append(someSamples(1)));
  sink->reset();
  EXPECT_TRUE(session->close());
  EXPECT_TRUE(session->close()) << "closing twice is no error";
  EXPECT_EQ(*open()->angleSampleCount(SweepRole::Calibration), 1);
}

} // namespace
} // namespace straightedge::session
