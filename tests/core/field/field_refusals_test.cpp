// Bad input: the campaign is refused, or a block is off; each with a message of its own.
#include "core/field/field_fit.h"
#include "tests/core/field/small_campaign.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace straightedge::field {
namespace {

using ::testing::HasSubstr;
using testing::SmallCampaign;

TEST(FieldRefusals, TheSmallCampaignIsGood) {
  const auto run = calibrateField(SmallCampaign().campaign, {}, {});
  ASSERT_TRUE(run) << run.error().message();
  EXPECT_TRUE(run->result.warnings.empty()) << run->result.warnings.front().text;
  EXPECT_EQ(run->result.blocks.size(), 17U);
  for (const VerificationRow& row : run->result.verification) {
    if (row.state == VerifiedState::Calibrated) {
      EXPECT_LT(row.ofFullScale.peak, 0.02);
    }
  }
}

struct BadCampaign {
  std::string name;
  std::function<void(SmallCampaign&)> spoil;
  std::string message; ///< part of the error, or of a warning
};
void PrintTo(const BadCampaign& bad, std::ostream* out) { *out << bad.name; }

bool isPlateauOf(const CampaignRow& row, Axis axis) {
  return row.step == CampaignStep::Nonlinearity && row.axis == axis;
}

const std::vector<BadCampaign> refused = {
    {"NoRows", [](SmallCampaign& c) { c.campaign.rows.clear(); },
     "campaign.csv: no step of the campaign can be used: the campaign has no rows of the step nonlinearity; record at "
     "least the step nonlinearity"},
    {"NeverLocked",
     [](SmallCampaign& c) { c.change(CampaignStep::Nonlinearity, [](auto& row) { row.locked = false; }); },
     "campaign.csv: axis x: the reference was never locked in the 68 rows of the step nonlinearity; check the "
     "reference's probe and range and record the step again"},
    {"SixPlateaus",
     [](SmallCampaign& c) {
       c.remove([](const CampaignRow& row) {
         return isPlateauOf(row, Axis::Y) && (std::abs(row.referenceT) > 0.8 || row.referenceT == 0.0);
       });
     },
     "campaign.csv: axis y: only 6 plateaus of the step nonlinearity can be used, order 5 needs 7; record plateaus at "
     "more fields, or choose a lower --order"},
    {"OneSign",
     [](SmallCampaign& c) {
       c.remove([](const CampaignRow& row) { return isPlateauOf(row, Axis::Z) && row.referenceT <= 0.0; });
     },
     "campaign.csv: axis z: fields of one sign only, from 0.250 T to 2.00 T; record plateaus of both signs; a negative "
     "field has a negative reference_T"},
    {"MagnitudesOnly",
     [](SmallCampaign& c) {
       c.change(CampaignStep::Nonlinearity,
                [](auto& row) { row.referenceT = row.referenceT < -1.0 ? -row.referenceT : row.referenceT; });
     },
     "campaign.csv:2: raw_x_T reads -2.02 T in a field of 2.00 T: the signs contradict each other; give reference_T "
     "the "
     "sign of the field, along the axis"},
    {"WrongAxis",
     [](SmallCampaign& c) {
       c.change(CampaignStep::Nonlinearity, [](auto& row) { row.axis = row.axis == Axis::X ? Axis::Y : row.axis; });
     },
     "raw_y_T reads"},
    {"ContradictoryPlateau",
     [](SmallCampaign& c) {
       for (CampaignRow row : std::vector(c.campaign.rows.begin(), c.campaign.rows.begin() + 4)) {
         row.rawT[0] = -1.5;
         row.line += 10000;
         c.campaign.rows.push_back(row);
       }
     },
     "campaign.csv:10002: the reading is -1.50 T in a field of -2.00 T, but it was -2.02 T before in the same field "
     "(line 2); remove the plateau that is wrong"},
};

class FieldCampaigns : public ::testing::TestWithParam<BadCampaign> {};

TEST_P(FieldCampaigns, AreRefused) {
  SmallCampaign campaign;
  GetParam().spoil(campaign);
  const auto run = calibrateField(campaign.campaign, {}, {});
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().kind, ErrorKind::Input);
  EXPECT_THAT(run.error().message(), HasSubstr(GetParam().message));
}
INSTANTIATE_TEST_SUITE_P(Bad, FieldCampaigns, ::testing::ValuesIn(refused),
                         [](const auto& bad) { return bad.param.name; });

const std::vector<BadCampaign> switchedOff = {
    {"OffsetMissing", [](SmallCampaign& c) { c.removeStep(CampaignStep::Offset); },
     "The block offset is off: the campaign has no rows of the step offset. The offset and its drift with the probe's "
     "temperature stay in the reading, most visible in small fields."},
    {"ProbeTemperatureMissing", [](SmallCampaign& c) { c.removeStep(CampaignStep::ProbeTemperature); },
     "The block sensitivity is off: it needs the probe's temperature, whose block is off."},
    {"ChamberNeverMoves",
     [](SmallCampaign& c) { c.change(CampaignStep::ProbeTemperature, [](auto& row) { row.chamberC = 24.0; }); },
     "The block probe-temperature is off: the temperature of the chamber does not move in the step probe-temperature: "
     "it "
     "stays within"},
    {"Pt100NotConnected",
     [](SmallCampaign& c) { c.change(CampaignStep::ProbeTemperature, [](auto& row) { row.pt100Ohm = 109.24; }); },
     "the PT100 does not follow the chamber"},
    {"Pt100TurnedRound",
     [](SmallCampaign& c) {
       c.change(CampaignStep::ProbeTemperature, [](auto& row) { row.pt100Ohm = 220.0 - row.pt100Ohm; });
     },
     "the resistance of the PT100 falls as the chamber warms up"},
    {"FewOffsetRows",
     [](SmallCampaign& c) {
       int kept = 0;
       c.remove([&](const CampaignRow& row) { return row.step == CampaignStep::Offset && ++kept > 3; });
     },
     "of axis x is off: only 3 rows of the step offset can be used, 4 are needed."},
    {"ProbeNeverMovesInOffset",
     [](SmallCampaign& c) { c.change(CampaignStep::Offset, [](auto& row) { row.pt100Ohm = 109.24; }); },
     "the temperature of the probe does not move in the step offset"},
    {"OffsetInAField", [](SmallCampaign& c) { c.change(CampaignStep::Offset, [](auto& row) { row.rawT[1] = 0.1; }); },
     "of axis y is off: axis y reads 0.103 T in the step offset, which belongs into a zero-field chamber (line "},
    {"SensitivityNeverLocked",
     [](SmallCampaign& c) { c.change(CampaignStep::Sensitivity, [](auto& row) { row.locked = false; }); },
     "The block sensitivity of axis x is off: the reference was never locked in the 60 rows of the step sensitivity of "
     "axis x."},
    {"SensitivityOneSign",
     [](SmallCampaign& c) {
       c.remove([](const auto& row) { return row.step == CampaignStep::Sensitivity && row.referenceT < 0.0; });
     },
     "has fields of one sign only, from 0.300 T to 1.60 T"},
    {"SensitivityOneField",
     [](SmallCampaign& c) {
       c.remove([](const auto& row) { return row.step == CampaignStep::Sensitivity && row.referenceT != 1.0; });
     },
     "sweeps the temperature of the probe at 1 locked field, 2 or more are needed"},
    {"SensitivityNeverMoves",
     [](SmallCampaign& c) { c.change(CampaignStep::Sensitivity, [](auto& row) { row.pt100Ohm = 109.24; }); },
     "the temperature of the probe does not move in the step sensitivity of axis x"},
    {"SensitivityTwoFields",
     [](SmallCampaign& c) {
       c.remove(
           [](const auto& row) { return row.step == CampaignStep::Sensitivity && std::abs(row.referenceT) != 1.0; });
     },
     "Axis x: only 2 fields in the step sensitivity: its slope over the field is a line instead of a cubic."},
    {"ElectronicsNeverMove",
     [](SmallCampaign& c) { c.change(CampaignStep::Electronics, [](auto& row) { row.electronicsC = 24.0; }); },
     "the temperature of the electronics does not move in the step electronics"},
    {"OrientationMissing",
     [](SmallCampaign& c) {
       c.remove([](const auto& row) {
         return row.orientation == Orientation::PlusZ || row.orientation == Orientation::MinusZ;
       });
     },
     "The block axis-matrix is off: the step orientation has no row with the package's z along the field: neither +z "
     "nor "
     "-z."},
    {"OneSideMissing",
     [](SmallCampaign& c) { c.remove([](const auto& row) { return row.orientation == Orientation::MinusY; }); },
     "The orientation -y is missing"},
    {"SingularMatrix",
     [](SmallCampaign& c) {
       c.change(CampaignStep::Orientation, [](auto& row) {
         const double both = 0.7 * (row.rawT[0] + row.rawT[1]);
         row.rawT[0] = both;
         row.rawT[1] = both;
       });
     },
     "the axis matrix is singular (condition number "},
    {"ContradictoryOrientation",
     [](SmallCampaign& c) {
       for (CampaignRow& row : c.campaign.rows) {
         if (row.orientation == Orientation::PlusX) {
           row.referenceT = -row.referenceT;
           break;
         }
       }
     },
     "in the orientation +x and a field of -0.500 T: the signs contradict the other rows (line "},
    {"ShortPlateau",
     [](SmallCampaign& c) {
       int seen = 0;
       c.remove([&](const auto& row) { return isPlateauOf(row, Axis::X) && row.referenceT == 1.0 && ++seen > 2; });
     },
     "Axis x: the plateau at 1.00 T (line 50) is left out: only 2 rows where the others have 4."},
    {"UnsettledPlateau",
     [](SmallCampaign& c) {
       int seen = 0;
       for (CampaignRow& row : c.campaign.rows) {
         if (isPlateauOf(row, Axis::X) && row.referenceT > 0.99 && row.referenceT < 1.01) {
           row.referenceT += 0.002 * seen++;
         }
       }
     },
     "is left out: the reference is unsettled: it scatters by"},
    {"FullScaleTooSmall",
     [](SmallCampaign& c) {
       for (CampaignRow& row : c.campaign.rows) {
         row.referenceT *= 3.0;
         for (double& raw : row.rawT) {
           raw *= 3.0;
         }
       }
     },
     "The plateaus reach 6.00 T while percentages are of a full scale of 2.00 T: give --full-scale."},
};

class FieldBlocksOff : public ::testing::TestWithParam<BadCampaign> {};

TEST_P(FieldBlocksOff, SayWhyAndWhatItCosts) {
  SmallCampaign campaign;
  GetParam().spoil(campaign);
  const auto run = calibrateField(campaign.campaign, {}, {});
  ASSERT_TRUE(run) << run.error().message();
  std::string all;
  for (const FieldWarning& warning : run->result.warnings) {
    all += warning.text + "\n";
  }
  EXPECT_THAT(all, HasSubstr(GetParam().message));
}
INSTANTIATE_TEST_SUITE_P(Bad, FieldBlocksOff, ::testing::ValuesIn(switchedOff),
                         [](const auto& bad) { return bad.param.name; });

TEST(FieldBlocksOff, NotANumberCountsNowhere) {
  SmallCampaign campaign;
  campaign.change(CampaignStep::Nonlinearity, [n = 0](CampaignRow& row) mutable {
    if (n++ == 5) {
      row.rawT[0] = std::numeric_limits<double>::quiet_NaN();
    }
  });
  const auto run = calibrateField(campaign.campaign, {}, {});
  ASSERT_TRUE(run) << run.error().message();
  EXPECT_EQ(run->reports.nonlinearity[0]->block.rows.incomplete, 1U);
  EXPECT_EQ(run->reports.nonlinearity[0]->plateaus.rowsEach, 3);
}

TEST(FieldBlocksOff, ABlockThatIsOffLeavesTheChainWithoutIt) {
  SmallCampaign campaign;
  campaign.removeStep(CampaignStep::ProbeTemperature);
  campaign.removeStep(CampaignStep::Orientation);
  const auto run = calibrateField(campaign.campaign, {}, {});
  ASSERT_TRUE(run) << run.error().message();
  const CorrectionChain& chain = run->result.chain;
  EXPECT_FALSE(chain.pt100);
  EXPECT_FALSE(chain.axisMatrix);
  EXPECT_FALSE(chain.axes[0].offsetT);
  EXPECT_FALSE(chain.axes[0].sensitivitySlope);
  EXPECT_TRUE(chain.axes[0].electronicsT);
}

TEST(AxisMatrix, AReferenceSignedAlongTheFieldGivesTheSameMatrix) {
  SmallCampaign signedAlongField;
  signedAlongField.change(CampaignStep::Orientation,
                          [](CampaignRow& row) { row.referenceT = std::abs(row.referenceT); });
  const auto one = calibrateField(SmallCampaign().campaign, {}, {});
  const auto other = calibrateField(signedAlongField.campaign, {}, {});
  ASSERT_TRUE(one && other);
  EXPECT_EQ(*one->result.chain.axisMatrix, *other->result.chain.axisMatrix);
}

TEST(ProbeTemperature, ALagIsFoundFromTimes) {
  constexpr double lagS = 300.0;
  constexpr double stepS = 10.0;
  Campaign campaign;
  constexpr int fine = 100; // steps of the truth between two readings
  const auto chamberAt = [](double timeS) {
    const double phase = std::fmod(timeS / 4000.0, 2.0);
    return 14.0 + 20.0 * (phase < 1.0 ? phase : 2.0 - phase);
  };
  double probe = 14.0;
  for (int i = 0; i < 1600 * fine; ++i) {
    const double timeS = stepS * i / fine;
    if (i % fine == 0) {
      CampaignRow row;
      row.step = CampaignStep::ProbeTemperature;
      row.chamberC = chamberAt(timeS);
      row.pt100Ohm = 100.0 + 0.385 * probe + 1e-3 * std::sin(7.0 * timeS);
      row.timeS = timeS;
      campaign.rows.push_back(row);
    }
    probe += (chamberAt(timeS + 0.5 * stepS / fine) - probe) * stepS / fine / lagS;
  }
  const auto report = fitProbeTemperature(CampaignParts(campaign).of(CampaignStep::ProbeTemperature), 24.0, "c");
  ASSERT_TRUE(report) << report.error().message();
  ASSERT_TRUE(report->lagS) << report->lagText;
  EXPECT_NEAR(*report->lagS, lagS, 0.002 * lagS);
  EXPECT_NEAR(report->line.slopeCPerOhm, 1.0 / 0.385, 1e-4);
  EXPECT_GT(*report->hysteresisC, 1.0);
  EXPECT_LT(report->standardUncertaintyC, 0.05);
}

} // namespace
} // namespace straightedge::field
