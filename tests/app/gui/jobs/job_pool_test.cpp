#include "app/gui/jobs/job_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <optional>
#include <semaphore>
#include <set>
#include <string>
#include <vector>

namespace straightedge::gui {
namespace {

/// Takes events like the window's thread: woken, never polling.
class Collector {
public:
  explicit Collector(std::size_t threads) : pool(threads, [this] { m_woken.release(); }) {}

  /// Until so many jobs have ended. Returns the numbers of those that did.
  std::vector<JobPool::Id> waitForEnds(std::size_t count) {
    std::vector<JobPool::Id> ended;
    while (ended.size() < count) {
      m_woken.acquire();
      for (const JobPool::Event& event : pool.takeEvents()) {
        if (event.ended) {
          ended.push_back(event.job);
        } else {
          fractions.push_back(event.fraction);
        }
      }
    }
    return ended;
  }

private:
  std::counting_semaphore<> m_woken{0};

public:
  std::vector<double> fractions;
  JobPool pool; ///< last: joined before what its threads use goes
};

TEST(JobPool, AResultMayBeReadOnceItsJobHasEnded) {
  Collector collector(3);
  std::vector<std::shared_ptr<std::optional<std::string>>> results;
  for (int i = 0; i < 200; ++i) {
    results.push_back(std::make_shared<std::optional<std::string>>());
    collector.pool.start([result = results.back(), i](const JobControl&) { result->emplace(std::to_string(i)); });
  }
  const auto ended = collector.waitForEnds(200);
  EXPECT_EQ(std::set(ended.begin(), ended.end()).size(), 200U);
  for (int i = 0; i < 200; ++i) {
    EXPECT_EQ(*results[static_cast<std::size_t>(i)], std::to_string(i));
  }
}

TEST(JobPool, ACancelledJobStillEnds) {
  Collector collector(2);
  std::binary_semaphore started{0};
  const auto id = collector.pool.start([&started](const JobControl& control) {
    started.release();
    while (!control.stopRequested()) {
      std::this_thread::yield();
    }
  });
  started.acquire();
  collector.pool.cancel(id);
  EXPECT_EQ(collector.waitForEnds(1), std::vector{id});
  collector.pool.cancel(id); // ended long ago: nothing happens
}

TEST(JobPool, WhatWasCancelledBeforeItsTurnIsNotBegun) {
  Collector collector(1);
  std::binary_semaphore started{0};
  std::binary_semaphore mayEnd{0};
  std::atomic<bool> begun = false;
  collector.pool.start([&](const JobControl&) {
    started.release();
    mayEnd.acquire();
  });
  started.acquire();
  const auto waiting = collector.pool.start([&begun](const JobControl&) { begun = true; });
  collector.pool.cancel(waiting);
  mayEnd.release();
  collector.waitForEnds(2);
  EXPECT_FALSE(begun);
}

TEST(JobPool, JobsRunBesideEachOther) {
  Collector collector(2);
  std::binary_semaphore first{0};
  std::binary_semaphore second{0};
  collector.pool.start([&](const JobControl&) {
    first.release();
    second.acquire(); // ends only if the other runs meanwhile
  });
  collector.pool.start([&](const JobControl&) {
    first.acquire();
    second.release();
  });
  EXPECT_EQ(collector.waitForEnds(2).size(), 2U);
}

TEST(JobPool, ProgressIsThinnedButItsEndIsNot) {
  Collector collector(1);
  collector.pool.start([](const JobControl& control) {
    for (int i = 0; i <= 10000; ++i) {
      control.report(i / 10000.0);
    }
  });
  collector.waitForEnds(1);
  ASSERT_FALSE(collector.fractions.empty());
  EXPECT_LT(collector.fractions.size(), 5000U);
  EXPECT_EQ(collector.fractions.back(), 1.0);
}

TEST(JobPool, TheDestructorStopsWhatRunsAndForgetsWhatWaits) {
  std::atomic<bool> stopped = false;
  std::atomic<bool> begun = false;
  {
    Collector collector(1);
    std::binary_semaphore started{0};
    collector.pool.start([&](const JobControl& control) {
      started.release();
      while (!control.stopRequested()) {
        std::this_thread::yield();
      }
      stopped = true;
    });
    started.acquire();
    collector.pool.start([&begun](const JobControl&) { begun = true; });
  }
  EXPECT_TRUE(stopped);
  EXPECT_FALSE(begun);
}

} // namespace
} // namespace straightedge::gui
