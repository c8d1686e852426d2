#include "core/field/chain.h"
#include "tests/core/field/sample_chain.h"

#include <Eigen/LU>
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace straightedge::field {
namespace {

using testing::sampleChain;
using testing::SampleReadings;
using testing::sampleReadings;

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

long double power(const std::vector<double>& ascending, long double x) {
  long double sum = 0.0L;
  for (std::size_t k = 0; k < ascending.size(); ++k) {
    sum += static_cast<long double>(ascending[k]) * std::pow(x, static_cast<long double>(k));
  }
  return sum;
}

/// The formula of the coefficient files, written down a second time in another arithmetic.
std::array<long double, 3> byTheFormula(const CorrectionChain& chain, const Reading& reading) {
  const long double t =
      static_cast<long double>(chain.pt100->slopeCPerOhm) * reading.pt100Ohm + chain.pt100->interceptC;
  const long double e = static_cast<long double>(reading.electronicsC) - chain.referenceTemperatureC;
  std::array<long double, 3> v{};
  for (std::size_t i = 0; i < 3; ++i) {
    const AxisChain& axis = chain.axes[i];
    const long double v1 = power(axis.nonlinearity, reading.rawT[i]);
    const long double v2 = v1 - ((*axis.offsetT)[0] + (*axis.offsetT)[1] * t);
    const long double v3 = v2 - (power(*axis.sensitivitySlope, v2) * t + power(*axis.sensitivityIntercept, v2));
    const long double v4 = v3 - ((*axis.electronicsT)[0] + (*axis.electronicsT)[1] * e);
    v[i] = v4 - ((*axis.electronicsSensitivity)[0] + (*axis.electronicsSensitivity)[1] * v4) * e;
  }
  // Cramer's rule
  const Eigen::Matrix<long double, 3, 3> s = chain.axisMatrix->cast<long double>();
  std::array<long double, 3> field{};
  for (int column = 0; column < 3; ++column) {
    Eigen::Matrix<long double, 3, 3> replaced = s;
    replaced.col(column) << v[0], v[1], v[2];
    field[static_cast<std::size_t>(column)] = replaced.determinant() / s.determinant();
  }
  return field;
}

Reading readingAt(const SampleReadings& r, std::size_t i) {
  return {r.pt100Ohm[i], r.electronicsC[i], {r.x[i], r.y[i], r.z[i]}};
}

struct Fields {
  explicit Fields(std::size_t count) : x(count), y(count), z(count) {}
  FieldColumns columns() { return {{x, y, z}}; }
  std::vector<double> x, y, z;
};

double largestDifference(const Fields& a, const Fields& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    largest = std::max({largest, std::abs(a.x[i] - b.x[i]), std::abs(a.y[i] - b.y[i]), std::abs(a.z[i] - b.z[i])});
  }
  return largest;
}

TEST(AppliedChain, agreesWithTheFormulaInLongDouble) {
  const CorrectionChain chain = sampleChain();
  const auto applied = AppliedChain::prepare(chain);
  ASSERT_TRUE(applied);
  const SampleReadings readings = sampleReadings(500);
  for (std::size_t i = 0; i < readings.x.size(); ++i) {
    const auto expected = byTheFormula(chain, readingAt(readings, i));
    const Eigen::Vector3d field = applied->correct(readingAt(readings, i));
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(field[axis], static_cast<double>(expected[static_cast<std::size_t>(axis)]), 2e-15);
    }
  }
}

TEST(AppliedChain, stagesEndWhereTheChainEnds) {
  CorrectionChain chain = sampleChain();
  chain.axisMatrix.reset();
  const auto applied = AppliedChain::prepare(chain);
  const Reading reading{109.3, 27.5, {1.25, -0.5, 0.125}};
  const Eigen::Vector3d field = applied->correct(reading);
  const double probe = probeAboveReference(chain, reading.pt100Ohm);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const AxisStages stages = axisStages(chain.axes[axis], reading.rawT[axis], probe, 3.5);
    EXPECT_EQ(field[static_cast<Eigen::Index>(axis)], stages.electronicsSensitivityT);
    EXPECT_NE(stages.electronicsT, stages.electronicsSensitivityT);
    EXPECT_NE(stages.offsetT, stages.nonlinearityT);
  }
}

// Every length, so that whole steps, a rest and more than one chunk occur.
TEST(AppliedChain, manyAtOnceAgreeWithThePlainLoopTo1e15OfFullScale) {
  const auto applied = AppliedChain::prepare(sampleChain());
  for (const std::size_t count : {0UL, 1UL, 15UL, 16UL, 17UL, 1023UL, 1024UL, 1025UL, 5000UL}) {
    const SampleReadings readings = sampleReadings(count);
    Fields plain(count);
    Fields fast(count);
    applied->correctPlainly(readings.columns(), plain.columns());
    applied->correct(readings.columns(), fast.columns());
    EXPECT_LE(largestDifference(plain, fast), 1e-15 * sampleChain().fullScaleT) << count;
  }
}

TEST(AppliedChain, aReadingsFieldDoesNotDependOnItsNeighbours) {
  const auto applied = AppliedChain::prepare(sampleChain());
  const SampleReadings readings = sampleReadings(100);
  Fields together(100);
  applied->correct(readings.columns(), together.columns());
  for (std::size_t i = 0; i < 100; ++i) {
    Fields alone(1);
    const ReadingColumns all = readings.columns();
    applied->correct({all.pt100Ohm.subspan(i, 1),
                      all.electronicsC.subspan(i, 1),
                      {all.rawT[0].subspan(i, 1), all.rawT[1].subspan(i, 1), all.rawT[2].subspan(i, 1)}},
                     alone.columns());
    EXPECT_EQ(alone.x[0], together.x[i]);
    EXPECT_EQ(alone.y[0], together.y[i]);
    EXPECT_EQ(alone.z[0], together.z[i]);
  }
}

TEST(AppliedChain, correctsInPlace) {
  const auto applied = AppliedChain::prepare(sampleChain());
  SampleReadings readings = sampleReadings(1000);
  Fields expected(1000);
  applied->correct(readings.columns(), expected.columns());
  applied->correct(readings.columns(), {{readings.x, readings.y, readings.z}});
  EXPECT_EQ(readings.x, expected.x);
  EXPECT_EQ(readings.z, expected.z);
}

TEST(AppliedChain, blocksThatAreOffChangeNothingAndNeedNoTemperature) {
  CorrectionChain chain;
  const auto applied = AppliedChain::prepare(chain);
  ASSERT_TRUE(applied);
  EXPECT_FALSE(applied->needsProbeTemperature());
  EXPECT_FALSE(applied->needsElectronicsTemperature());
  const SampleReadings readings = sampleReadings(40);
  Fields fields(40);
  applied->correct({{}, {}, {readings.x, readings.y, readings.z}}, fields.columns());
  EXPECT_EQ(fields.x, readings.x);
  EXPECT_EQ(fields.y, readings.y);
  EXPECT_EQ(fields.z, readings.z);
  EXPECT_EQ(applied->correct({notANumber, notANumber, {1.0, -0.5, 0.25}}), Eigen::Vector3d(1.0, -0.5, 0.25));
}

TEST(AppliedChain, aTemperatureThatNoBlockNeedsMayBeMissing) {
  CorrectionChain chain = sampleChain();
  for (AxisChain& axis : chain.axes) {
    axis.electronicsT.reset();
    axis.electronicsSensitivity.reset();
  }
  const auto applied = AppliedChain::prepare(chain);
  EXPECT_TRUE(applied->needsProbeTemperature());
  EXPECT_FALSE(applied->needsElectronicsTemperature());
  SampleReadings readings = sampleReadings(33);
  Fields without(33);
  Fields with(33);
  applied->correct({readings.pt100Ohm, {}, {readings.x, readings.y, readings.z}}, without.columns());
  readings.electronicsC.assign(33, notANumber);
  applied->correct(readings.columns(), with.columns());
  EXPECT_EQ(without.x, with.x);
  EXPECT_TRUE(std::isfinite(with.x[32]));
}

TEST(AppliedChain, aMissingTemperatureThatIsNeededMakesThatReadingNotANumber) {
  const auto applied = AppliedChain::prepare(sampleChain());
  SampleReadings readings = sampleReadings(20);
  readings.pt100Ohm[7] = notANumber;
  Fields fields(20);
  applied->correct(readings.columns(), fields.columns());
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(std::isnan(fields.y[i]), i == 7);
  }
}

TEST(AppliedChain, refusals) {
  CorrectionChain singular = sampleChain();
  singular.axisMatrix->row(2) = singular.axisMatrix->row(0) + singular.axisMatrix->row(1);
  EXPECT_THAT(AppliedChain::prepare(singular).error().message(), ::testing::HasSubstr("cannot be inverted"));

  CorrectionChain noLine = sampleChain();
  noLine.pt100.reset();
  EXPECT_THAT(AppliedChain::prepare(noLine).error().message(),
              ::testing::HasSubstr("offset of axis x needs the probe's temperature"));
  noLine.axes[0].offsetT.reset();
  EXPECT_THAT(AppliedChain::prepare(noLine).error().message(),
              ::testing::HasSubstr("sensitivity of axis x needs the probe's temperature"));

  CorrectionChain tooMany = sampleChain();
  tooMany.axes[1].nonlinearity.resize(mostChainCoefficients + 1, 0.0);
  EXPECT_THAT(AppliedChain::prepare(tooMany).error().message(), ::testing::HasSubstr("axis y"));

  CorrectionChain noNumber = sampleChain();
  noNumber.axes[2].electronicsT = {{0.0, notANumber}};
  EXPECT_THAT(AppliedChain::prepare(noNumber).error().message(), ::testing::HasSubstr("axis z"));
}

} // namespace
} // namespace straightedge::field
