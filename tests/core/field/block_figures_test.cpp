// Every block against an independent evaluation of the same campaign (numpy: polyfit and lstsq, run by hand), in the
// digits that it gave; and the published maxima of the campaign's README to 1 % or 0.0003 %.
#include "core/field/axis_matrix.h"
#include "core/field/names.h"
#include "core/field/nonlinearity.h"
#include "core/field/probe_temperature.h"
#include "core/field/sensitivity.h"
#include "core/field/zero_field_line.h"
#include "tests/core/field/example_campaign.h"

#include <algorithm>
#include <cmath>

namespace straightedge::field {
namespace {

/// 1 % of the figure, or 0.0003.
double tolerance(double figure) { return std::max(0.01 * std::abs(figure), 0.0003); }

struct AxisFigures {
  Axis axis;
  double before;
  std::vector<double> orders; // 1 to 6
  double offsetSlopeMicroT;
};

const std::vector<AxisFigures> figures = {
    {Axis::X, 2.05597, {3.16069, 3.16126, 0.18657, 0.18526, 0.01043, 0.01023}, 16.9},
    {Axis::Y, 2.06554, {3.1814, 3.18226, 0.15663, 0.15472, 0.01031, 0.01000}, -9.75},
    {Axis::Z, 1.95905, {3.00496, 3.0056, 0.22482, 0.22364, 0.01179, 0.01155}, 23.8}};

NonlinearityReport nonlinearityOf(Axis axis) {
  auto report =
      fitNonlinearity(findPlateaus(exampleParts().of(CampaignStep::Nonlinearity, axis), 2.0), {}, "campaign.csv");
  EXPECT_TRUE(report) << (report ? "" : report.error().message());
  return report ? *std::move(report) : NonlinearityReport{};
}

TEST(FieldBlocks, PlateausAreCutToTheShortestOfTheirAxis) {
  for (const Axis axis : allAxes) {
    const AxisPlateaus plateaus = findPlateaus(exampleParts().of(CampaignStep::Nonlinearity, axis), 2.0);
    EXPECT_EQ(plateaus.plateaus.size(), 80U);
    EXPECT_EQ(plateaus.rowsEach, 6);
    EXPECT_TRUE(plateaus.rejected.empty()) << plateaus.rejected.front().reason;
    EXPECT_EQ(plateaus.unlocked + plateaus.surplus + 480, exampleParts().of(CampaignStep::Nonlinearity, axis).recorded);
  }
}

TEST(FieldBlocks, OrdersLeaveThePublishedMaxima) {
  for (const AxisFigures& expected : figures) {
    const NonlinearityReport report = nonlinearityOf(expected.axis);
    EXPECT_NEAR(report.beforePercent, expected.before, tolerance(expected.before));
    ASSERT_EQ(report.orders.size(), 7U);
    for (std::size_t i = 0; i < expected.orders.size(); ++i) {
      EXPECT_NEAR(report.orders[i].maxErrorPercent, expected.orders[i], 0.00002) << axisName(expected.axis) << i + 1;
      EXPECT_GT(report.orders[i].crossMaxPercent, report.orders[i].maxErrorPercent);
    }
    EXPECT_EQ(report.bestCrossValidated, 7);
    EXPECT_EQ(report.coefficients, report.orders[4].coefficients);
  }
  EXPECT_NEAR(nonlinearityOf(Axis::X).orders[6].maxErrorPercent, 0.00417, 0.00002);
}

class FieldBlocksInOrder : public testing::Test {
protected:
  FieldBlocksInOrder() {
    const auto pt100 = fitProbeTemperature(exampleParts().of(CampaignStep::ProbeTemperature), 24.0, "campaign.csv");
    chain.pt100 = pt100->line;
    for (const Axis axis : allAxes) {
      chain.axes[indexOf(axis)].nonlinearity = nonlinearityOf(axis).coefficients;
    }
  }
  CorrectionChain chain;
};

TEST_F(FieldBlocksInOrder, Pt100LineAndItsHysteresis) {
  const auto report = fitProbeTemperature(exampleParts().of(CampaignStep::ProbeTemperature), 24.0, "campaign.csv");
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_NEAR(report->line.slopeCPerOhm, 2.55462822, 1e-8);
  EXPECT_NEAR(report->line.interceptC, -279.07342679, 1e-7);
  EXPECT_EQ(report->lagText, "no times: lag not estimated");
  EXPECT_FALSE(report->lagS);
  ASSERT_TRUE(report->hysteresisC);
  // Worked out from the file by a script of its own: heating less cooling in ten parts of the resistance ...
  EXPECT_NEAR(*report->hysteresisC, 2.735247815, 1e-8);
  // ... which is also the area that a cycle goes round, over its resistances: 2.8077 °C, 2.8095 °C.
  EXPECT_NEAR(*report->hysteresisC, 2.8086, 0.03 * 2.8086);
  EXPECT_FALSE(report->loopLeftC);
  EXPECT_EQ(report->feltC, report->chamberC);
  // The scatter about the line, the loop in it, 1.267456601 °C; the line's own uncertainty is small beside it.
  EXPECT_NEAR(report->block.residuals.sigma, 1.267456601, 1e-8);
  EXPECT_GT(report->standardUncertaintyC, 1.2675);
  EXPECT_LT(report->standardUncertaintyC, 1.28);
}

TEST_F(FieldBlocksInOrder, OffsetSlopes) {
  for (const AxisFigures& expected : figures) {
    const auto report = fitTemperatureOffset(exampleParts().of(CampaignStep::Offset), chain, expected.axis, "c");
    ASSERT_TRUE(report) << report.error().message();
    const double slope = report->offsetT[1] * 1e6;
    EXPECT_NEAR(slope, expected.offsetSlopeMicroT, 0.01 * std::abs(expected.offsetSlopeMicroT));
    if (expected.axis == Axis::X) {
      EXPECT_NEAR(report->offsetT[0] * 1e6, 1.6632361, 1e-6);
      EXPECT_NEAR(slope, 16.88759233, 1e-6);
    }
  }
}

} // namespace
} // namespace straightedge::field
