// What tests of session files share: samples, bytes of files, and a user for whom permissions hold.
#pragma once

#include "core/session/session.h"
#include "tests/core/session/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace straightedge::tests {

inline std::vector<session::AngleSample> countedSamples(int count, std::int64_t first = 0) {
  std::vector<session::AngleSample> samples;
  for (int i = 0; i < count; ++i) {
    session::AngleSample sample;
    sample.sequence = first + i;
    sample.point = static_cast<int>(first) + i;
    sample.encoderDeg = 0.25 * static_cast<double>(first + i);
    sample.sensorDeg = 0.125 * (i % 2880);
    samples.push_back(sample);
  }
  return samples;
}

inline void storeSamples(session::Session& session, const std::vector<session::AngleSample>& samples) {
  auto sink = session.angleSink(session::SweepRole::Calibration);
  ASSERT_TRUE(sink) << sink.error().message();
  ASSERT_TRUE((*sink)->append(samples));
  const auto committed = (*sink)->commit();
  ASSERT_TRUE(committed) << committed.error().message();
}

/// A session that was closed as it should be.
inline void makeClosedSession(const std::filesystem::path& file, int samples) {
  auto session = session::Session::create(file, session::SessionKind::Angle);
  ASSERT_TRUE(session) << session.error().message();
  storeSamples(**session, countedSamples(samples));
  ASSERT_TRUE((*session)->setDocument("plan", R"({"points_per_turn":64})"));
  ASSERT_TRUE((*session)->close());
}

inline std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline void writeBytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// Runs checks in a child process; its failed expectations fail the test.
inline void inChildProcess(const std::function<void()>& checks) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    checks();
    ::_exit(testing::Test::HasFailure() ? 1 : 0); // no destructors of the parent's objects
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "see the messages above; status " << status;
}

/// The same as somebody for whom permissions hold: for root they would not.
inline void asOrdinaryUser(const std::function<void()>& checks) {
  inChildProcess([&checks] {
    constexpr unsigned nobody = 65534;
    if (::geteuid() == 0) {
      ASSERT_EQ(::setgid(nobody), 0);
      ASSERT_EQ(::setuid(nobody), 0);
    }
    checks();
  });
}

} // namespace straightedge::tests
