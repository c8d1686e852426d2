#include "core/angle/angles.h"
#include "core/angle/quantisation.h"
#include "tests/core/angle/model_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>

namespace straightedge::angle {
namespace {

struct Case {
  const char* name;
  int bits;
};

void PrintTo(const Case& each, std::ostream* out) { *out << each.name << '/' << each.bits; }

class StoredModel : public testing::TestWithParam<Case> {
protected:
  Model fit(std::optional<int> bits) const {
    ModelName name = *parseModelName(GetParam().name);
    name.bits = bits;
    auto model = fitModel(sideShaftCurve(), name);
    EXPECT_TRUE(model) << model.error().message();
    return model.value_or(Model{});
  }
  int largest() const { return (1 << (GetParam().bits - 1)) - 1; }
};

TEST_P(StoredModel, isWhatItsIntegersSay) {
  const Model model = fit(GetParam().bits);
  ASSERT_TRUE(model.stored);
  EXPECT_EQ(model.stored->bits, GetParam().bits);
  // Rebuilt here from the file's own definition, not with the code that made it.
  Model rebuilt = model;
  if (auto* harmonics = std::get_if<HarmonicModel>(&rebuilt.body)) {
    const std::size_t n = harmonics->terms.size();
    ASSERT_EQ(model.stored->integers.size(), 2 * n);
    harmonics->offsetDeg = model.stored->biasDeg;
    for (std::size_t k = 0; k < n; ++k) {
      harmonics->terms[k].amplitudeDeg = model.stored->lsbDeg * model.stored->integers[k];
      harmonics->terms[k].phaseRad = *model.stored->phaseLsbRad * model.stored->integers[n + k];
    }
  } else {
    Eigen::VectorXd values(model.name.size);
    ASSERT_EQ(model.stored->integers.size(), static_cast<std::size_t>(model.name.size));
    EXPECT_FALSE(model.stored->phaseLsbRad);
    for (int k = 0; k < model.name.size; ++k) {
      values[k] = model.stored->biasDeg + model.stored->lsbDeg * model.stored->integers[static_cast<std::size_t>(k)];
    }
    if (model.name.kind == ModelKind::Linear) {
      rebuilt.body = LinearModel{values};
    } else {
      rebuilt.body = LookupTableModel{values};
    }
  }
  EXPECT_EQ((rebuilt.correctionOnGrid() - model.correctionOnGrid()).cwiseAbs().maxCoeff(), 0.0);
  const Eigen::VectorXd residual = rebuilt.correctionOnGrid() - sideShaftCurve().gridDeg;
  EXPECT_NEAR(model.errors.maxCurveDeg, residual.cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_NEAR(model.errors.rmsCurveDeg, std::sqrt(residual.squaredNorm() / gridSize), 1e-13);
}

TEST_P(StoredModel, usesItsIntegersFully) {
  const Model model = fit(GetParam().bits);
  const auto [least, most] = std::minmax_element(model.stored->integers.begin(), model.stored->integers.end());
  EXPECT_LE(*most, largest());
  EXPECT_GE(*least, -largest() - 1);
  if (model.name.kind == ModelKind::Harmonic) {
    EXPECT_EQ(*std::max_element(model.stored->integers.begin(),
                                model.stored->integers.begin() + static_cast<std::ptrdiff_t>(model.name.size)),
              largest());
    EXPECT_NEAR(*model.stored->phaseLsbRad * (1 << GetParam().bits), 2.0 * std::numbers::pi, 1e-15);
  } else {
    EXPECT_EQ(*most, largest());
    EXPECT_EQ(*least, -largest());
  }
}

TEST_P(StoredModel, staysWithinHalfAStepOfTheUnrounded) {
  const Model stored = fit(GetParam().bits);
  const Model unrounded = fit({});
  double bound = 0.5 * stored.stored->lsbDeg;
  if (const auto* harmonics = std::get_if<HarmonicModel>(&unrounded.body)) {
    bound = 0.0;
    for (const HarmonicTerm& term : harmonics->terms) {
      bound += 0.5 * stored.stored->lsbDeg + term.amplitudeDeg * 0.5 * *stored.stored->phaseLsbRad;
    }
  }
  EXPECT_LE((stored.correctionOnGrid() - unrounded.correctionOnGrid()).cwiseAbs().maxCoeff(), bound * (1.0 + 1e-9));
  EXPECT_LE(stored.errors.maxCurveDeg, unrounded.errors.maxCurveDeg + bound * (1.0 + 1e-9));
}

INSTANTIATE_TEST_SUITE_P(Quantisation, StoredModel,
                         testing::Values(Case{"harmonic:4", 8}, Case{"harmonic:4", 16}, Case{"harmonic:16@ordered", 12},
                                         Case{"linear:32", 8}, Case{"linear:64@minimax", 12},
                                         Case{"linear:7@on-curve", 16}, Case{"lut:64", 8}, Case{"lut:256", 16},
                                         Case{"lut:100@midrange", 9}));

TEST(Quantisation, bitsBuyAccuracy) {
  // Table of 512 segments: 0.0009° by itself, so that the steps show. Each bit halves the step.
  double before = 1e9;
  for (int bits = 8; bits <= 16; bits += 2) {
    const auto model = fitModel(sideShaftCurve(), {ModelKind::Linear, 512, FitMethod::LeastSquares, bits});
    ASSERT_TRUE(model);
    EXPECT_LT(model->errors.maxCurveDeg, before);
    before = model->errors.maxCurveDeg;
    EXPECT_NEAR(model->stored->lsbDeg * ((1 << bits) - 2), 98.28350005307728 - 76.19456494532905, 0.01);
  }
}

TEST(Quantisation, equalValuesNeedNoStep) {
  const auto [stored, body] = quantised(LookupTableModel{Eigen::VectorXd::Constant(5, -3.25)}, 8);
  EXPECT_EQ(stored.lsbDeg, 0.0);
  EXPECT_EQ(stored.integers, std::vector<int>(5, 0));
  EXPECT_EQ(std::get<LookupTableModel>(body).valuesDeg, Eigen::VectorXd::Constant(5, -3.25));
  const auto [none, flat] = quantised(HarmonicModel{12.5, {}}, 8);
  EXPECT_TRUE(none.integers.empty());
  EXPECT_EQ(std::get<HarmonicModel>(flat).offsetDeg, 12.5);
}

TEST(Quantisation, aPhaseOfHalfATurnOverflowsToItsOtherName) {
  const auto [stored, body] = quantised(HarmonicModel{0.0, {{3, 1.0, std::numbers::pi}}}, 8);
  EXPECT_EQ(stored.integers[1], -128);
  EXPECT_DOUBLE_EQ(std::get<HarmonicModel>(body).terms[0].phaseRad, -std::numbers::pi);
}

} // namespace
} // namespace straightedge::angle
