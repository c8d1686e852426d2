// Benches before they are opened: what is wrong with one, and which there are.
#include "devices/bench/bench_check.h"
#include "devices/bench/bench_folder.h"
#include "tests/core/base/temporary_folder.h"

#include <gmock/gmock.h>

#include <cstdlib>

namespace straightedge::devices {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

BenchInstrument board(InstrumentRole role) {
  BenchInstrument one;
  one.instrument = "ascii-board";
  one.roles = {role};
  one.serial = "ACM-1";
  return one;
}

TEST(BenchCheck, SettingsAreCheckedWithoutAnInstrument) {
  const ProfileSet profiles = readProfiles({});
  BenchInstrument one = board(InstrumentRole::AngleSensor);
  EXPECT_TRUE(checkBenchInstrument(one, profiles));
  one.settings["column"] = "0";
  const auto outside = checkBenchInstrument(one, profiles);
  ASSERT_FALSE(outside);
  EXPECT_EQ(outside.error().kind, ErrorKind::Usage);
  one.settings = {{"colum", "1"}};
  const auto misspelt = checkBenchInstrument(one, profiles);
  ASSERT_FALSE(misspelt);
  EXPECT_THAT(misspelt.error().message(), HasSubstr("colum"));
  one.settings.clear();
  one.roles = {InstrumentRole::FieldProbe};
  EXPECT_FALSE(checkBenchInstrument(one, profiles));
  one.instrument = "no-such-instrument";
  EXPECT_FALSE(checkBenchInstrument(one, profiles));
}

TEST(BenchCheck, ProfilesHaveNoSettings) {
  const ProfileSet profiles = readProfiles({});
  BenchInstrument one;
  one.instrument = "scpi_multimeter_pt100";
  one.roles = {InstrumentRole::Resistance};
  one.serial = "1";
  const auto plain = checkBenchInstrument(one, profiles);
  EXPECT_TRUE(plain) << plain.error().message();
  one.settings["range"] = "1";
  EXPECT_FALSE(checkBenchInstrument(one, profiles));
}

TEST(BenchCheck, ARoleIsFilledOnce) {
  SavedBench bench;
  bench.name = "desk";
  bench.instruments = {board(InstrumentRole::AngleSensor), board(InstrumentRole::AngleSensor)};
  const auto twice = checkBench(bench, readProfiles({}));
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().what, "two instruments fill the role angle-sensor");
}

TEST(BenchFolder, ListsSavedBenchesAndDeletesThem) {
  const straightedge::testing::TemporaryFolder folder;
  ASSERT_EQ(::setenv("XDG_CONFIG_HOME", folder.path().c_str(), 1), 0);
  EXPECT_THAT(savedBenchNames(), IsEmpty()); // there is no folder yet
  SavedBench bench;
  bench.instruments = {board(InstrumentRole::AngleSensor)};
  for (const char* name : {"lab", "desk"}) {
    bench.name = name;
    ASSERT_TRUE(saveBench(bench));
  }
  EXPECT_THAT(savedBenchNames(), ElementsAre("desk", "lab"));
  EXPECT_TRUE(deleteBench("lab"));
  EXPECT_THAT(savedBenchNames(), ElementsAre("desk"));
  const auto again = deleteBench("lab");
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().what, "there is no bench named 'lab'");
  ASSERT_EQ(::unsetenv("XDG_CONFIG_HOME"), 0);
}

} // namespace
} // namespace straightedge::devices
