#include "core/angle/sweep_csv.h"

#include <gtest/gtest.h>

#include <cmath>

namespace straightedge::angle {
namespace {

Result<Sweep> parse(std::string text, const std::optional<SweepMapping>& mapping = std::nullopt) {
  return parseSweepCsv(std::move(text), "dir/t.csv", "t.csv", mapping);
}

TEST(SweepCsv, ReadsTheSideShaftSweep) {
  const auto sweep = readSweepCsv(STRAIGHTEDGE_TEST_DATA "/angle/side_shaft_32.csv");
  ASSERT_TRUE(sweep) << sweep.error().message();
  ASSERT_EQ(sweep->size(), 32U);
  EXPECT_EQ(sweep->encoderDeg[31], 348.75);
  EXPECT_EQ(sweep->sensorDeg[31], 254.36);
  EXPECT_EQ(sweep->line[0], 4U);
  EXPECT_EQ(sweep->source.file, "side_shaft_32.csv");
  EXPECT_EQ(sweep->source.points, 32);
  EXPECT_EQ(sweep->source.sha256.size(), 64U);
  EXPECT_TRUE(sweep->turn.empty());
}

TEST(SweepCsv, OtherPeoplesHeaders) {
  for (const std::string header :
       {"encoder_deg,sensor_deg", "Reference Angle [degree],Measured Angle [degree]", "ENCODER,SENSOR",
        "Encoder (\xC2\xB0),Sensor (\xC2\xB0)", "Encoder [\xB0],Sensor [\xB0]", "EncoderAngle,SensorAngle",
        "\"ref angle, deg\",measured_deg", "encoder angle in degrees,sensor angle in degrees"}) {
    const auto sweep = parse(header + "\n10,20\n");
    ASSERT_TRUE(sweep) << header << ": " << sweep.error().message();
    EXPECT_EQ(sweep->encoderDeg[0], 10.0) << header;
    EXPECT_EQ(sweep->sensorDeg[0], 20.0) << header;
  }
}

TEST(SweepCsv, ColumnsInAnyOrderWithOptionalOnes) {
  const auto sweep = parse("time_s;temperature_C;direction;turn;note;sensor_deg;encoder_deg\n"
                           "0,5;23,25;-1;2;a;20,5;370\n1;;up;3.0;;360;nan\n");
  ASSERT_FALSE(sweep);
  EXPECT_EQ(sweep.error().message(),
            "dir/t.csv:3: column \"turn\" holds \"3.0\"; number the turns 0, 1, … or remove the column");

  const auto good = parse("time_s;temperature_C;direction;turn;note;sensor_deg;encoder_deg\n"
                          "0,5;23,25;-1;2;a;20,5;370\n1;;up;3;;360;nan\n");
  ASSERT_TRUE(good) << good.error().message();
  EXPECT_EQ(good->timeS, (std::vector<double>{0.5, 1.0}));
  EXPECT_EQ(good->temperatureC[0], 23.25);
  EXPECT_TRUE(std::isnan(good->temperatureC[1]));
  EXPECT_EQ(good->direction, (std::vector<int>{-1, 1}));
  EXPECT_EQ(good->turn, (std::vector<int>{2, 3}));
  EXPECT_EQ(good->sensorDeg[1], 360.0);
  EXPECT_TRUE(std::isnan(good->encoderDeg[1])) << "left for alignSweep() to refuse";
}

TEST(SweepCsv, WithoutHeaderEncoderThenSensor) {
  const auto sweep = parse("0\t266,31\n11,25\t278,61\n");
  ASSERT_TRUE(sweep);
  EXPECT_EQ(sweep->encoderDeg[1], 11.25);
  EXPECT_EQ(sweep->sensorDeg[1], 278.61);
}

TEST(SweepCsv, TheSurestColumnIsTheAngle) {
  const auto sweep = parse("reference serial,reference angle [deg],sensor temperature [C],sensor error,sensor_deg\n"
                           "7,10,23,1,20\n");
  ASSERT_TRUE(sweep) << sweep.error().message();
  EXPECT_EQ(sweep->encoderDeg[0], 10.0);
  EXPECT_EQ(sweep->sensorDeg[0], 20.0);
  EXPECT_EQ(sweep->temperatureC[0], 23.0);
}

TEST(SweepCsv, MappingOverridesTitles) {
  const SweepMapping mapping{SweepColumn::Ignored, SweepColumn::Sensor, SweepColumn::Encoder};
  const auto sweep = parse("encoder_deg,a,b\n1,2,3\n", mapping);
  ASSERT_TRUE(sweep);
  EXPECT_EQ(sweep->encoderDeg[0], 3.0);
  EXPECT_EQ(sweep->sensorDeg[0], 2.0);
  EXPECT_EQ(parse("a,b\n1,2\n", mapping).error().kind, ErrorKind::Usage);
}

TEST(SweepCsv, RefusesWithPlaceAndRemedy) {
  EXPECT_EQ(parse("encoder_deg,foo\n1,2\n").error().message(),
            "dir/t.csv: no column is the sensor angle; name its column sensor_deg");
  EXPECT_EQ(parse("foo,sensor_deg\n1,2\n").error().message(),
            "dir/t.csv: no column is the encoder angle; name its column encoder_deg");
  EXPECT_EQ(parse("1,2,3\n4,5,6\n").error().message(),
            "dir/t.csv: there is no header and there are 3 columns; add a header with encoder_deg and sensor_deg, or "
            "keep two columns");
  EXPECT_EQ(parse("1\n4\n").error().message(), "dir/t.csv: there is no header and only 1 column; separate encoder and "
                                               "sensor angle by a comma, a semicolon or a tab");
  EXPECT_EQ(parse("encoder A,encoder B,sensor\n1,2,3\n").error().message(),
            "dir/t.csv: column \"encoder A\" and column \"encoder B\" may both be encoder_deg; name the right one "
            "encoder_deg and the other differently");
  EXPECT_EQ(parse("encoder [rad],sensor [deg]\n1,2\n").error().message(),
            "dir/t.csv: column \"encoder [rad]\" is in rad, not in degrees; convert it to degrees");
  EXPECT_EQ(parse("encoder_deg,sensor_deg\n1,2\n3,four\n").error().message(),
            "dir/t.csv:3: column \"sensor_deg\" holds \"four\", which is no number; correct it or remove the row");
  EXPECT_EQ(parse("encoder_deg,sensor_deg,direction\n1,2,0\n").error().message(),
            "dir/t.csv:2: column \"direction\" holds \"0\"; write 1 for a rising encoder and -1 for a falling one, or "
            "remove the column");
}

TEST(SweepCsv, PreviewTellsHowColumnsAreUnderstood) {
  const auto preview = inspectCsv(STRAIGHTEDGE_TEST_DATA "/angle/side_shaft_32.csv");
  ASSERT_TRUE(preview);
  EXPECT_EQ(preview->layout.separator, ',');
  EXPECT_TRUE(preview->layout.hasHeader);
  EXPECT_EQ(preview->rowCount, 32U);
  EXPECT_EQ(preview->firstRows.size(), 32U);
  EXPECT_EQ(preview->mapping(), (SweepMapping{SweepColumn::Encoder, SweepColumn::Sensor}));
  EXPECT_EQ(preview->columns[1].minimum, 3.16);
  EXPECT_EQ(preview->columns[1].maximum, 352.79);
  EXPECT_FALSE(preview->problem);
}

TEST(SweepCsv, CanonicalTextReadsBackEqual) {
  Sweep sweep;
  sweep.encoderDeg = {1.0 / 3.0, 370.1, 5.0};
  sweep.sensorDeg = {0.1, 359.99999999999994, 7.0};
  sweep.turn = {0, 1, 1};
  sweep.direction = {1, -1, 1};
  sweep.temperatureC = {23.1, std::nan(""), 23.0};
  sweep.timeS = {0.0, 1e-9, 2.0};
  sweep.enabled = {true, true, false};
  const auto back = parse(sweepToCsv(sweep));
  ASSERT_TRUE(back) << back.error().message();
  ASSERT_EQ(back->size(), 2U) << "the row that is switched off is left out";
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back->encoderDeg[i], sweep.encoderDeg[i]);
    EXPECT_EQ(back->sensorDeg[i], sweep.sensorDeg[i]);
    EXPECT_EQ(back->turn[i], sweep.turn[i]);
    EXPECT_EQ(back->direction[i], sweep.direction[i]);
    EXPECT_EQ(back->timeS[i], sweep.timeS[i]);
  }
  EXPECT_TRUE(std::isnan(back->temperatureC[1]));
}

} // namespace
} // namespace straightedge::angle
