// Samples of a field campaign: in and out of a session to the last bit, also in files made before there were any.
#include "core/angle/session_sweep.h"
#include "tests/core/session/session_fixture.h"

#include <gtest/gtest.h>

namespace straightedge::session {
namespace {

std::vector<FieldSample> someSamples(int count, std::int64_t first = 0) {
  std::vector<FieldSample> samples;
  for (int i = 0; i < count; ++i) {
    FieldSample sample;
    sample.sequence = first + i;
    sample.stage = i / 5;
    sample.point = i % 5;
    sample.attempt = i % 2;
    sample.timeS = 0.1 * i;
    sample.step = i % 8;
    sample.locked = i % 3 == 0;
    sample.rawT = {0.1 * i, -1e-7 * i, 1.0 / (i + 1)};
    if (i % 3 == 0) {
      sample.referenceT = -2.0 + 0.1 * i;
      sample.axis = i % 3;
    }
    if (i % 4 == 1) {
      sample.orientation = i % 6;
      sample.chamberC = 14.0 + 0.3 * i;
      sample.pt100Ohm = 109.2424 + 1e-13 * i;
    }
    if (i % 4 == 2) {
      sample.electronicsC = 23.9375;
    }
    samples.push_back(sample);
  }
  return samples;
}

class FieldSamplesTest : public testing::Test {
protected:
  tests::TemporaryFolder m_folder;
  std::filesystem::path m_file = m_folder / "hall.sedge";
};

TEST_F(FieldSamplesTest, ComeBackToTheLastBitAfterClosing) {
  const auto samples = someSamples(50);
  {
    auto session = *Session::create(m_file, SessionKind::Field);
    auto sink = *session->fieldSink(SweepRole::Calibration);
    ASSERT_TRUE(sink->append(samples));
    ASSERT_TRUE(sink->recordGap({50, 3, "the memory ran over"}));
    ASSERT_TRUE(sink->commit());
    EXPECT_EQ(*session->fieldSampleCount(SweepRole::Calibration), 50);
    sink.reset();
    ASSERT_TRUE(session->close());
  }
  const auto session = *Session::openReadOnly(m_file);
  EXPECT_EQ(session->kind(), SessionKind::Field);
  EXPECT_EQ(*session->fieldSamples(SweepRole::Calibration), samples);
  EXPECT_TRUE(session->fieldSamples(SweepRole::Verification)->empty());
  ASSERT_EQ(session->gaps(SweepRole::Calibration)->size(), 1U);
  EXPECT_EQ(session->gaps(SweepRole::Calibration)->front().count, 3);
}

TEST_F(FieldSamplesTest, ACampaignThatIsStartedOverIsGoneAtOnceAndForGood) {
  auto session = *Session::create(m_file, SessionKind::Field);
  {
    auto sink = *session->fieldSink(SweepRole::Calibration);
    ASSERT_TRUE(sink->append(someSamples(10)));
  }
  ASSERT_TRUE(session->clearSamples(SweepRole::Calibration));
  EXPECT_EQ(*session->fieldSampleCount(SweepRole::Calibration), 0);
  {
    auto sink = *session->fieldSink(SweepRole::Calibration);
    ASSERT_TRUE(sink->append(someSamples(3))) << "the same numbers again";
    ASSERT_TRUE(sink->commit());
  }
  ASSERT_TRUE(session->close());
  EXPECT_EQ(*(*Session::openReadOnly(m_file))->fieldSampleCount(SweepRole::Calibration), 3);
}

/// A file that the program of version 1 made (straightedge-cli capture angle, 8 points, two readings
/// each).
class Version1Test : public FieldSamplesTest {
protected:
  std::filesystem::path m_original = std::filesystem::path(STRAIGHTEDGE_TEST_DATA) / "session" / "version_1.sedge";
};

TEST_F(Version1Test, IsMigratedAndKeepsItsSweep) {
  std::filesystem::copy_file(m_original, m_file);
  const auto before = *(*Session::openReadOnly(m_file))->angleSamples(SweepRole::Calibration);
  {
    auto session = Session::open(m_file);
    ASSERT_TRUE(session) << session.error().message();
    const auto samples = *(*session)->angleSamples(SweepRole::Calibration);
    ASSERT_EQ(samples.size(), 16U);
    EXPECT_EQ(samples.front().encoderDeg, before.front().encoderDeg);
    EXPECT_EQ((*session)->traceability()->deviceSerial, "V1-7");
    ASSERT_TRUE((*session)->close());
  }
  const std::string after = tests::bytesOf(m_file);
  EXPECT_NE(after, tests::bytesOf(m_original)) << "it was migrated";
  EXPECT_NE(after.find("field_sample"), std::string::npos);
  EXPECT_EQ((*Session::open(m_file))->angleSamples(SweepRole::Calibration)->size(), 16U);
}

TEST_F(Version1Test, IsReadAsItIsWhereNothingMayBeWritten) {
  std::filesystem::copy_file(m_original, m_file);
  const auto sweep = angle::readSessionSweep(m_file.string(), SweepRole::Calibration);
  ASSERT_TRUE(sweep) << sweep.error().message();
  EXPECT_EQ(sweep->sweep.size(), 16U);
  EXPECT_EQ(*(*Session::openReadOnly(m_file))->fieldSampleCount(SweepRole::Calibration), 0);
  EXPECT_TRUE(tests::bytesOf(m_file) == tests::bytesOf(m_original));
}

} // namespace
} // namespace straightedge::session
