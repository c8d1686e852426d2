#include "core/base/error.h"

#include <gtest/gtest.h>

namespace straightedge {
namespace {

TEST(Error, MessageNamesPlaceProblemAndRemedy) {
  const Error error{ErrorKind::Input, "row has 3 columns instead of 2", "check the separator", "sweep.csv:7"};
  EXPECT_EQ(error.message(), "sweep.csv:7: row has 3 columns instead of 2; check the separator");
}

TEST(Error, ExitCodesAreThePublishedOnes) {
  EXPECT_EQ(exitCode(ErrorKind::Usage), 2);
  EXPECT_EQ(exitCode(ErrorKind::Input), 3);
  EXPECT_EQ(exitCode(ErrorKind::Instrument), 4);
  EXPECT_EQ(exitCode(ErrorKind::Storage), 5);
}

} // namespace
} // namespace straightedge
