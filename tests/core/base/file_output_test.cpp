#include "core/base/file_output.h"
#include "tests/core/base/temporary_folder.h"

#include <gtest/gtest.h>

#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace straightedge {
namespace {

using testing::TemporaryFolder;

TEST(FileOutput, WritesTheWholeFileAndNothingElse) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFileWhole(folder.file("a.txt"), "first"));
  EXPECT_EQ(folder.read("a.txt"), "first");
  ASSERT_TRUE(writeFileWhole(folder.file("a.txt"), "second", Durability::Cached));
  EXPECT_EQ(folder.read("a.txt"), "second");
  EXPECT_EQ(folder.listing(), "a.txt");
}

TEST(FileOutput, WithoutCommitTheOldFileStays) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  {
    auto file = PendingFile::create(folder.file("a.txt"));
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->write("half"));
  }
  EXPECT_EQ(folder.read("a.txt"), "old");
  EXPECT_EQ(folder.listing(), "a.txt");
}

TEST(FileOutput, KeepsPermissionsAndLinks) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  ASSERT_EQ(::chmod(folder.file("a.txt").c_str(), 0640), 0);
  std::filesystem::create_symlink("a.txt", folder.file("link"));
  ASSERT_TRUE(writeFileWhole(folder.file("link"), "new"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
  EXPECT_EQ(folder.read("a.txt"), "new");
  struct stat status{};
  ASSERT_EQ(::stat(folder.file("a.txt").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST(FileOutput, FullDisk) {
  const auto written = writeFileWhole("/dev/full", "text");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().kind, ErrorKind::Storage);
  EXPECT_EQ(written.error().message(), "/dev/full: the disk is full; free some space or write to another folder");
}

TEST(FileOutput, NothingIsLeftWhenTheDiskEndsMidway) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit small = before;
  small.rlim_cur = 1000;
  auto* const handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const auto written = writeFileWhole(folder.file("a.txt"), std::string(5000, 'x'));
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().kind, ErrorKind::Storage);
  EXPECT_EQ(folder.read("a.txt"), "old");
  EXPECT_EQ(folder.listing(), "a.txt");
}

TEST(FileOutput, PlacesThatCannotBeWritten) {
  const TemporaryFolder folder;
  folder.write("file", "");
  const auto message = [](const auto& result) { return result ? std::string() : result.error().message(); };
  EXPECT_EQ(message(writeFileWhole(folder.file("no/x"), "a")),
            folder.file("no/x") + ": the folder does not exist; create it or choose another one");
  EXPECT_EQ(message(writeFileWhole(folder.path(), "a")),
            folder.path() + ": there is a folder of this name; choose another name");
  EXPECT_EQ(message(writeFileWhole(folder.file("file/x"), "a")),
            folder.file("file/x") + ": a part of the path is a file, not a folder; choose another path");
  EXPECT_EQ(message(makeFolder(folder.file("file"))),
            folder.file("file") + ": there is a file of this name, a folder is needed; choose another name");
  EXPECT_TRUE(makeFolder(folder.file("deep/er/folder")));
  EXPECT_TRUE(makeFolder(folder.file("deep/er/folder")));
}

TEST(FileOutput, FolderWithoutWriteAccess) {
  if (::geteuid() == 0) {
    GTEST_SKIP() << "root may write everywhere";
  }
  const TemporaryFolder folder;
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  EXPECT_EQ(writeFileWhole(folder.file("x"), "a").error().message(),
            folder.file("x") + ": writing is not permitted; choose another folder or ask for write access");
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
}

} // namespace
} // namespace straightedge
