// The sink commits in time by itself, and several threads may use a session and its sink.
#include "core/session/committing_sink.h"
#include "tests/core/session/session_fixture.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace straightedge::session {
namespace {

using namespace std::chrono_literals;

static_assert(AngleSink::commitAfter <= 400ms, "0.5 s are promised, the disk wants some of it");

class AngleSinkTest : public testing::Test {
protected:
  tests::TemporaryFolder m_folder;
  std::unique_ptr<Session> m_session = *Session::create(m_folder / "a.sedge", SessionKind::Angle);

  std::int64_t committed() const { return *m_session->angleSampleCount(SweepRole::Calibration); }
  bool waitForCommitted(std::int64_t count) const {
    const auto deadline = std::chrono::steady_clock::now() + 60s; // never reached where it works
    while (committed() < count && std::chrono::steady_clock::now() < deadline) {
      std::this_thread::sleep_for(5ms);
    }
    return committed() >= count;
  }
};

TEST_F(AngleSinkTest, CommitsByItselfWhenNobodyCallsAnyMore) {
  auto sink = *m_session->angleSink(SweepRole::Calibration);
  ASSERT_TRUE(sink->append(tests::countedSamples(1)));
  EXPECT_TRUE(waitForCommitted(1));
  ASSERT_TRUE(sink->append(tests::countedSamples(2, 1)));
  EXPECT_TRUE(waitForCommitted(3)) << "and again";
}

TEST_F(AngleSinkTest, CommitsWhatIsLeftWhenItEnds) {
  {
    auto sink = *m_session->angleSink(SweepRole::Calibration);
    ASSERT_TRUE(sink->append(tests::countedSamples(5)));
  }
  EXPECT_EQ(committed(), 5);
}

TEST_F(AngleSinkTest, RefusesASequenceNumberThatIsTaken) {
  auto sink = *m_session->angleSink(SweepRole::Calibration);
  ASSERT_TRUE(sink->append(tests::countedSamples(5)));
  ASSERT_TRUE(sink->commit());
  ASSERT_TRUE(sink->append(tests::countedSamples(1, 4)));
  EXPECT_FALSE(sink->commit());
  EXPECT_EQ(committed(), 5);
}

TEST_F(AngleSinkTest, RowsOfAFieldCampaignAreCommittedInTimeToo) {
  auto session = *Session::create(m_folder / "field.sedge", SessionKind::Field);
  auto sink = *session->fieldSink(SweepRole::Calibration);
  ASSERT_TRUE(sink->append(std::vector<FieldSample>(1)));
  const auto deadline = std::chrono::steady_clock::now() + 60s; // never reached where it works
  while (*session->fieldSampleCount(SweepRole::Calibration) < 1 && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(5ms);
  }
  EXPECT_EQ(*session->fieldSampleCount(SweepRole::Calibration), 1);
}

TEST_F(AngleSinkTest, AWindowMayReadAndWriteWhileACaptureStores) {
  auto sink = *m_session->angleSink(SweepRole::Calibration);
  std::atomic<bool> done = false;
  std::thread capture([&] {
    for (int i = 0; i < 200; ++i) {
      EXPECT_TRUE(sink->append(tests::countedSamples(50, 50 * i)));
      if (i % 10 == 0) {
        EXPECT_TRUE(sink->commit());
      }
    }
    EXPECT_TRUE(sink->commit());
    done = true;
  });
  std::int64_t before = 0;
  while (!done) {
    EXPECT_TRUE(m_session->setDocument("models", std::to_string(before)));
    const std::int64_t now = committed();
    EXPECT_GE(now, before);
    EXPECT_EQ(now % 50, 0) << "a commit is whole";
    before = now;
  }
  capture.join();
  EXPECT_EQ(committed(), 10000);
}

} // namespace
} // namespace straightedge::session
