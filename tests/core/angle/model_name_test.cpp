#include "core/angle/model_name.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>

namespace straightedge::angle {
namespace {

using testing::HasSubstr;

struct Spelling {
  const char* text;
  const char* canonical;
  ModelName name;
  int entries;
  int bytes;
  const char* stem;
};

void PrintTo(const Spelling& spelling, std::ostream* out) { *out << spelling.text; }

class EverySpelling : public testing::TestWithParam<Spelling> {};

TEST_P(EverySpelling, isReadWrittenAndCounted) {
  const Spelling& expected = GetParam();
  const auto name = parseModelName(expected.text);
  ASSERT_TRUE(name) << name.error().message();
  EXPECT_EQ(*name, expected.name);
  EXPECT_EQ(name->text(), expected.canonical);
  EXPECT_EQ(name->storageEntries(), expected.entries);
  EXPECT_EQ(name->storageBytes(), expected.bytes);
  EXPECT_EQ(name->fileStem(), expected.stem);
}

INSTANTIATE_TEST_SUITE_P(
    ModelName, EverySpelling,
    testing::Values(
        Spelling{"harmonic:4", "harmonic:4", {ModelKind::Harmonic, 4, FitMethod::ByAmplitude, {}}, 9, 36, "harmonic-4"},
        Spelling{"harmonic:0", "harmonic:0", {ModelKind::Harmonic, 0, FitMethod::ByAmplitude, {}}, 1, 4, "harmonic-0"},
        Spelling{"harmonic:64@ordered",
                 "harmonic:64@ordered",
                 {ModelKind::Harmonic, 64, FitMethod::Ordered, {}},
                 129,
                 516,
                 "harmonic-64-ordered"},
        Spelling{"harmonic:3@amplitude/12",
                 "harmonic:3/12",
                 {ModelKind::Harmonic, 3, FitMethod::ByAmplitude, 12},
                 7,
                 11, // 84 bits
                 "harmonic-3-12bit"},
        Spelling{"linear:32", "linear:32", {ModelKind::Linear, 32, FitMethod::LeastSquares, {}}, 32, 128, "linear-32"},
        Spelling{"linear:32@least-squares",
                 "linear:32",
                 {ModelKind::Linear, 32, FitMethod::LeastSquares, {}},
                 32,
                 128,
                 "linear-32"},
        Spelling{"linear:1024@on-curve/16",
                 "linear:1024@on-curve/16",
                 {ModelKind::Linear, 1024, FitMethod::OnCurve, 16},
                 1024,
                 2048,
                 "linear-1024-on-curve-16bit"},
        Spelling{"linear:32@minimax/12",
                 "linear:32@minimax/12",
                 {ModelKind::Linear, 32, FitMethod::Minimax, 12},
                 32,
                 48,
                 "linear-32-minimax-12bit"},
        Spelling{"lut:64", "lut:64", {ModelKind::LookupTable, 64, FitMethod::Mean, {}}, 64, 256, "lut-64"},
        Spelling{"lut:2@midrange/8",
                 "lut:2@midrange/8",
                 {ModelKind::LookupTable, 2, FitMethod::MidRange, 8},
                 2,
                 2,
                 "lut-2-midrange-8bit"}));

struct Refusal {
  const char* text;
  const char* what;
  const char* remedy;
};

void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.text; }

class EveryRefusal : public testing::TestWithParam<Refusal> {};

TEST_P(EveryRefusal, namesTheWrongPartAndWhatIsAllowed) {
  const Refusal& expected = GetParam();
  const auto name = parseModelName(expected.text);
  ASSERT_FALSE(name) << name->text();
  EXPECT_EQ(name.error().kind, ErrorKind::Usage);
  EXPECT_THAT(name.error().what, HasSubstr(expected.what));
  EXPECT_THAT(name.error().remedy, HasSubstr(expected.remedy));
}

INSTANTIATE_TEST_SUITE_P(
    ModelName, EveryRefusal,
    testing::Values(Refusal{"", "unknown kind ''", "harmonic:N"}, Refusal{"spline:4", "unknown kind 'spline'", "lut:N"},
                    Refusal{"Linear:4", "unknown kind 'Linear'", "linear:N"},
                    Refusal{"linear", "size is missing", "linear:N"},
                    Refusal{"linear:", "'' is not a size", "2 to 1024"},
                    Refusal{"linear:4.5", "'4.5' is not a size", "2 to 1024"},
                    Refusal{"linear:1", "size 1 is out of range", "2 to 1024"},
                    Refusal{"linear:1025", "size 1025 is out of range", "2 to 1024"},
                    Refusal{"lut:1", "size 1 is out of range", "2 to 1024"},
                    Refusal{"harmonic:65", "size 65 is out of range", "0 to 64"},
                    Refusal{"harmonic:-1", "size -1 is out of range", "0 to 64"},
                    Refusal{"linear:99999999999", "is not a size", "2 to 1024"},
                    Refusal{"linear:32@mean", "unknown method 'mean'", "@least-squares or @on-curve or @minimax"},
                    Refusal{"lut:32@minimax", "unknown method 'minimax'", "@mean or @midrange"},
                    Refusal{"harmonic:4@", "unknown method ''", "@amplitude or @ordered"},
                    Refusal{"linear:32/7", "7 bits", "/8 to /16"}, Refusal{"linear:32/17", "17 bits", "/8 to /16"},
                    Refusal{"linear:32/", "'' is not a number of bits", "/8 to /16"},
                    Refusal{"linear:32/12@minimax", "'12@minimax' is not a number of bits", "/8 to /16"}));

TEST(ModelName, defaultsAreTheThreeOfTheAppNote) {
  std::vector<std::string> texts;
  for (const ModelName& name : defaultModels()) {
    texts.push_back(name.text());
  }
  EXPECT_THAT(texts, testing::ElementsAre("harmonic:4", "linear:32", "lut:64"));
}

} // namespace
} // namespace straightedge::angle
