// What is said where access is denied, wherever the program lies.
#include "devices/usb/access_remedy.h"
#include "tests/core/base/temporary_folder.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <string>

namespace straightedge::devices {
namespace {

TEST(AccessRemedy, BelowASourceTreeItIsACommandWithItsFullPath) {
  const straightedge::testing::TemporaryFolder folder;
  const std::filesystem::path tree = std::filesystem::path(folder.path()) / "tree";
  std::filesystem::create_directories(tree / "installer/linux");
  folder.write("tree/installer/run", "");
  const auto program = tree / "build/release/bin/straightedge";
  EXPECT_THAT(accessRemedy(program), ::testing::StartsWith("copy ")) << "another project's installer";
  folder.write("tree/installer/linux/70-straightedge.rules", "");
  EXPECT_EQ(accessRemedy(program),
            "run: " + (tree / "installer/run").string() + " --udev, then plug the device in again");
}

TEST(AccessRemedy, ThePathIsOneWordForAShell) {
  const straightedge::testing::TemporaryFolder folder;
  std::filesystem::create_directories(std::filesystem::path(folder.path()) / "it's here/installer/linux");
  folder.write("it's here/installer/run", "");
  folder.write("it's here/installer/linux/70-straightedge.rules", "");
  EXPECT_EQ(accessRemedy(std::filesystem::path(folder.path()) / "it's here/bin/straightedge"),
            "run: '" + folder.path() + "/it'\\''s here/installer/run' --udev, then plug the device in again");
}

TEST(AccessRemedy, ElsewhereTheFileIsNamed) {
  const std::string named = "copy installer/linux/70-straightedge.rules of Straightedge's sources into "
                            "/etc/udev/rules.d as root, then restart udev and plug the device in again";
  EXPECT_EQ(accessRemedy("/usr/bin/straightedge"), named);
  EXPECT_EQ(accessRemedy(std::filesystem::path()), named) << "no /proc";
}

TEST(AccessRemedy, TheCommandOfThisProgramIsThere) {
  const std::string& remedy = accessRemedy(); // of the test, which lies where the programs lie
  ASSERT_THAT(remedy, ::testing::StartsWith("run: /"));
  const std::string command = remedy.substr(5, remedy.find(" --udev") - 5);
  EXPECT_TRUE(std::filesystem::is_regular_file(command)) << command;
}

} // namespace
} // namespace straightedge::devices
