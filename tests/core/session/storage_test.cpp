// Disks that are full, places that are read-only, files that somebody else has open or that were not closed.
#include "tests/core/session/session_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <thread>

namespace straightedge::session {
namespace {

using std::filesystem::perms;
using testing::HasSubstr;

class StorageTest : public testing::Test {
protected:
  ~StorageTest() override { std::filesystem::permissions(m_folder.path(), perms::owner_all); }

  void makeReadOnly(perms file) {
    std::filesystem::permissions(m_file, file);
    std::filesystem::permissions(m_folder.path(), perms::owner_read | perms::owner_exec | perms::group_read |
                                                      perms::group_exec | perms::others_read | perms::others_exec);
  }
  /// The file as a program that is killed leaves it: not closed, samples in the log beside it.
  void makeUnclosedSession(int samples) {
    auto session = Session::create(m_folder / "running.sedge", SessionKind::Angle);
    ASSERT_TRUE(session);
    tests::storeSamples(**session, tests::countedSamples(samples));
    std::filesystem::copy_file(m_folder / "running.sedge", m_file);
    std::filesystem::copy_file(m_folder / "running.sedge-wal", m_folder / "a.sedge-wal");
  }

  tests::TemporaryFolder m_folder;
  std::filesystem::path m_file = m_folder / "a.sedge";
};

constexpr perms readable = perms::owner_read | perms::group_read | perms::others_read;
constexpr perms writableByAll = readable | perms::owner_write | perms::group_write | perms::others_write;

void expectReadableOnly(const std::filesystem::path& file, int samples) {
  auto opened = Session::open(file);
  ASSERT_TRUE(opened) << opened.error().message();
  Session& session = **opened;
  EXPECT_TRUE(session.readOnly());
  EXPECT_EQ(session.angleSamples(SweepRole::Calibration)->size(), static_cast<std::size_t>(samples));
  EXPECT_EQ(*session.document("plan"), R"({"points_per_turn":64})");
  const std::string refusal =
      file.string() + ": the session was opened from a read-only place; save it under another name first";
  const auto stored = session.setDocument("plan", "{}");
  ASSERT_FALSE(stored);
  EXPECT_EQ(stored.error().kind, ErrorKind::Storage);
  EXPECT_EQ(stored.error().message(), refusal);
  const auto sink = session.angleSink(SweepRole::Calibration);
  ASSERT_FALSE(sink);
  EXPECT_EQ(sink.error().message(), refusal);
  const auto cleared = session.clearSamples(SweepRole::Calibration);
  ASSERT_FALSE(cleared);
  EXPECT_EQ(cleared.error().message(), refusal);

  const tests::TemporaryFolder elsewhere;
  const auto copied = session.copyTo(elsewhere / "copy.sedge");
  ASSERT_TRUE(copied) << copied.error().message();
  auto copy = Session::open(elsewhere / "copy.sedge");
  ASSERT_TRUE(copy) << copy.error().message();
  EXPECT_FALSE((*copy)->readOnly());
  EXPECT_EQ(*(*copy)->angleSampleCount(SweepRole::Calibration), samples);
  EXPECT_TRUE(session.close());
}

TEST_F(StorageTest, AFinishedFileOpensOnReadOnlyMedia) {
  tests::makeClosedSession(m_file, 700);
  makeReadOnly(readable);
  tests::asOrdinaryUser([this] { expectReadableOnly(m_file, 700); });
}

TEST_F(StorageTest, AWritableFileInAReadOnlyFolderOpensForReading) {
  tests::makeClosedSession(m_file, 700);
  makeReadOnly(writableByAll);
  tests::asOrdinaryUser([this] { expectReadableOnly(m_file, 700); });
}

TEST_F(StorageTest, AnUnclosedFileOnReadOnlyMediaIsNotShownWithoutItsLastSamples) {
  makeUnclosedSession(300);
  makeReadOnly(readable);
  std::filesystem::permissions(m_folder / "a.sedge-wal", readable);
  tests::asOrdinaryUser([this] {
    const auto session = Session::open(m_file);
    ASSERT_FALSE(session);
    EXPECT_EQ(session.error().kind, ErrorKind::Storage);
    EXPECT_EQ(session.error().message(),
              m_file.string() + ": the session was not closed, and the log beside it cannot be read in a read-only "
                                "folder; copy the file together with the one ending in -wal to a writable folder and "
                                "open it there");
  });
}

TEST_F(StorageTest, AnUnclosedFileOpensWithEverySample) {
  makeUnclosedSession(300);
  auto session = Session::open(m_file);
  ASSERT_TRUE(session) << session.error().message();
  EXPECT_EQ(*(*session)->angleSampleCount(SweepRole::Calibration), 300);
  EXPECT_EQ((*session)->openingNote(), "");
}

TEST_F(StorageTest, LookingAtAnUnclosedFileShowsEverySampleAndLeavesItAsItIs) {
  makeUnclosedSession(300);
  const std::string file = tests::bytesOf(m_file);
  const std::string log = tests::bytesOf(m_folder / "a.sedge-wal");
  {
    auto session = Session::openReadOnly(m_file);
    ASSERT_TRUE(session) << session.error().message();
    EXPECT_EQ(*(*session)->angleSampleCount(SweepRole::Calibration), 300);
  }
  EXPECT_TRUE(file == tests::bytesOf(m_file));
  EXPECT_TRUE(log == tests::bytesOf(m_folder / "a.sedge-wal"));
}

TEST_F(StorageTest, SaysThatTheLogOfAnUnclosedFileIsMissing) {
  makeUnclosedSession(300);
  std::filesystem::remove(m_folder / "a.sedge-wal");
  auto session = Session::open(m_file);
  ASSERT_TRUE(session) << session.error().message();
  EXPECT_THAT((*session)->openingNote(), HasSubstr("ending in -wal that belongs to it is missing"));
}

TEST_F(StorageTest, AFileThatAnotherProgramHasOpenIsRefusedUntilItIsClosedThere) {
  tests::makeClosedSession(m_file, 10);
  int fromChild[2];
  int toChild[2];
  ASSERT_EQ(::pipe(fromChild), 0);
  ASSERT_EQ(::pipe(toChild), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(toChild[1]);
    auto session = Session::open(m_file);
    const char answer = session ? 'o' : 'e';
    std::ignore = ::write(fromChild[1], &answer, 1);
    char ignored = 0;
    std::ignore = ::read(toChild[0], &ignored, 1);
    ::_exit(0); // without closing the session, as a program that crashes
  }
  char answer = 0;
  ASSERT_EQ(::read(fromChild[0], &answer, 1), 1);
  ASSERT_EQ(answer, 'o');
  for (const auto& session : {Session::open(m_file), Session::openReadOnly(m_file)}) {
    ASSERT_FALSE(session);
    EXPECT_EQ(session.error().kind, ErrorKind::Storage);
    EXPECT_EQ(session.error().message(),
              m_file.string() + ": another program has this session open; close it there and try again");
  }
  ::close(toChild[1]);
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  const auto session = Session::open(m_file);
  ASSERT_TRUE(session) << session.error().message();
  EXPECT_EQ(*(*session)->angleSampleCount(SweepRole::Calibration), 10);
}

/// Appends and commits until the disk refuses; what was committed before must be readable afterwards.
void fillUntilRefused(const std::filesystem::path& file, const std::function<void()>& makeRoom) {
  auto session = Session::open(file);
  ASSERT_TRUE(session) << session.error().message();
  auto sink = session.value()->angleSink(SweepRole::Calibration);
  ASSERT_TRUE(sink);
  std::int64_t next = 10;
  std::int64_t committed = 10;
  std::optional<Error> refusal;
  while (!refusal && next < 1000000) {
    const auto batch = tests::countedSamples(500, next);
    auto outcome = (*sink)->append(batch);
    next += 500;
    outcome = outcome ? (*sink)->commit() : outcome;
    if (outcome) {
      committed = next;
    } else {
      refusal = outcome.error();
    }
  }
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->kind, ErrorKind::Storage);
  EXPECT_EQ(refusal->message(), file.string() + ": the disk is full; free some space and go on; everything committed "
                                                "so far is in the file");
  EXPECT_EQ((*sink)->append(tests::countedSamples(1, next)).error().message(), refusal->message())
      << "goes on saying so";
  EXPECT_EQ(*session.value()->angleSampleCount(SweepRole::Calibration), committed);
  makeRoom();
  const auto again = (*sink)->commit();
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(*session.value()->angleSampleCount(SweepRole::Calibration), next) << "what was refused is not lost";
  sink->reset();
  EXPECT_TRUE(session.value()->close());
  EXPECT_EQ(*Session::open(file).value()->angleSampleCount(SweepRole::Calibration), next);
}

void closeOnAFullDisk(const std::filesystem::path& folder) {
  auto session = Session::create(folder / "b.sedge", SessionKind::Angle);
  ASSERT_TRUE(session) << session.error().message();
  tests::storeSamples(**session, tests::countedSamples(5000));
  std::ofstream(folder / "ballast") << std::string(2000000, 'x'); // as much as fits
  const auto closed = (*session)->close();
  ASSERT_FALSE(closed);
  EXPECT_THAT(closed.error().message(), HasSubstr("the disk is full; free some space"));
  session->reset();
  std::filesystem::remove(folder / "ballast");
  const auto again = Session::open(folder / "b.sedge");
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(*(*again)->angleSampleCount(SweepRole::Calibration), 5000);
}

TEST_F(StorageTest, AFileThatMayNotGrowIsToldAsAFullDisk) {
  tests::makeClosedSession(m_file, 10);
  tests::inChildProcess([this] {
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
    const rlim_t before = limit.rlim_cur;
    limit.rlim_cur = 400000;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
    fillUntilRefused(m_file, [&limit, before] {
      limit.rlim_cur = before;
      ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
    });
  });
}

TEST_F(StorageTest, AFullDisk) {
  // A small file system of its own, seen by the child only.
  constexpr int cannotMount = 77;
  const pid_t child = ::fork();
  if (child == 0) {
    const std::filesystem::path folder = m_folder.path();
    if (::unshare(CLONE_NEWNS) != 0 || ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        ::mount("tmpfs", folder.c_str(), "tmpfs", 0, "size=2000k") != 0) {
      ::_exit(cannotMount);
    }
    std::ofstream(folder / "ballast") << std::string(1500000, 'x');
    tests::makeClosedSession(m_file, 10);
    fillUntilRefused(m_file, [&folder] { std::filesystem::remove(folder / "ballast"); });
    std::filesystem::remove(m_file);
    closeOnAFullDisk(folder);
    ::_exit(testing::Test::HasFailure() ? 1 : 0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  if (WIFEXITED(status) && WEXITSTATUS(status) == cannotMount) {
    GTEST_SKIP() << "no file system can be mounted here (needs root)";
  }
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "see the messages above";
}

TEST_F(StorageTest, ANewSessionOnAFullDiskLeavesNothingBehind) {
  tests::inChildProcess([this] {
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
    limit.rlim_cur = 8192;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
    const auto session = Session::create(m_file, SessionKind::Angle);
    ASSERT_FALSE(session);
    EXPECT_EQ(session.error().kind, ErrorKind::Storage);
    EXPECT_THAT(session.error().message(), HasSubstr(m_file.string() + ": the disk is full"));
    EXPECT_TRUE(std::filesystem::is_empty(m_folder.path()));
  });
}

} // namespace
} // namespace straightedge::session
