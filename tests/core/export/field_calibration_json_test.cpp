#include "core/export/field_calibration_json.h"
#include "core/export/field_tables.h"
#include "core/field/field_fit.h"
#include "tests/core/field/small_campaign.h"

#include <gtest/gtest.h>

namespace straightedge::exporting {
namespace {

using namespace field;

const FieldCalibration& sample() {
  static const FieldCalibration calibration = [] {
    FieldCalibration made = calibrateField(straightedge::testing::SmallCampaign().campaign, {},
                                           {"SN 1", "MFC", "J. Ünal", {"PT2025", "7", "C-1", "2027-01-31", 1e-5}, 23.1})
                                ->result;
    made.created = "2026-03-01T09:30:00Z";
    made.warnings = {{Block::Offset, "Something."}};
    return made;
  }();
  return calibration;
}

TEST(FieldCalibrationJson, ReadsBackToTheSameDoubles) {
  const std::string text = fieldCalibrationToJson(sample());
  const auto read = fieldCalibrationFromJson(text, "c.json");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(fieldCalibrationToJson(*read), text);
  EXPECT_EQ(read->chain.axes[1].nonlinearity, sample().chain.axes[1].nonlinearity);
  EXPECT_EQ(read->chain.axes[2].sensitivitySlope, sample().chain.axes[2].sensitivitySlope);
  EXPECT_EQ(*read->chain.axisMatrix, *sample().chain.axisMatrix);
  EXPECT_EQ(read->chain.pt100->interceptC, sample().chain.pt100->interceptC);
  EXPECT_EQ(read->traceability.reference.uncertainty, 1e-5);
  EXPECT_EQ(read->verification.size(), sample().verification.size());
  EXPECT_EQ(read->warnings[0].text, "Something.");
  EXPECT_TRUE(isFieldCalibration(text));
  EXPECT_FALSE(isFieldCalibration("{\"kind\": \"angle\"}"));
  EXPECT_FALSE(isFieldCalibration("no JSON"));
}

TEST(FieldCalibrationJson, BlocksThatAreOffAreNull) {
  FieldCalibration calibration = sample();
  calibration.chain.axisMatrix.reset();
  for (AxisChain& axis : calibration.chain.axes) {
    axis = {};
  }
  calibration.chain.pt100.reset();
  const std::string text = fieldCalibrationToJson(calibration);
  EXPECT_NE(text.find("\"pt100\": null"), std::string::npos);
  EXPECT_NE(text.find("\"axis_matrix\": null"), std::string::npos);
  EXPECT_NE(text.find("\"nonlinearity\": null"), std::string::npos);
  const auto read = fieldCalibrationFromJson(text, "c.json");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_TRUE(read->chain.axes[0].nonlinearity.empty());
  EXPECT_FALSE(read->chain.axisMatrix);
}

TEST(FieldCalibrationJson, PublishedKeysAloneAreEnough) {
  const auto read = fieldCalibrationFromJson(R"({"format": "straightedge-calibration", "version": 1, "kind": "field",
    "full_scale_T": 2.0, "reference_temperature_C": 24.0, "pt100": null, "future": 1,
    "axes": {"x": {"nonlinearity": [0, 1]}, "y": {"electronics_T": [0, 1e-6]}, "z": {}},
    "nonlinearity_orders": [{"axis": "x", "order": 1, "max_error_percent": 0.5}],
    "verification": [{"axis": "x", "state": "calibrated", "mean_percent": 0, "sigma_percent": 1, "peak_percent": 2}]})",
                                             "c.json");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->chain.axes[0].nonlinearity, (std::vector<double>{0.0, 1.0}));
  EXPECT_EQ(read->chain.axes[1].electronicsT, (std::array<double, 2>{0.0, 1e-6}));
  EXPECT_EQ(read->verification[0].ofFullScale.peak, 2.0);
}

struct Malformed {
  std::string name, find, replace, what;
};
void PrintTo(const Malformed& malformed, std::ostream* out) { *out << malformed.name; }

class FieldCalibrationJsonRefuses : public ::testing::TestWithParam<Malformed> {};

TEST_P(FieldCalibrationJsonRefuses, WithTheKeyAndWhatIsWrong) {
  std::string text = fieldCalibrationToJson(sample());
  const auto at = text.find(GetParam().find);
  ASSERT_NE(at, std::string::npos) << text;
  text.replace(at, GetParam().find.size(), GetParam().replace);
  const auto read = fieldCalibrationFromJson(text, "c.json");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().kind, ErrorKind::Input);
  EXPECT_FALSE(read.error().remedy.empty());
  EXPECT_EQ(read.error().where + ": " + read.error().what, GetParam().what);
}

INSTANTIATE_TEST_SUITE_P(
    Malformed, FieldCalibrationJsonRefuses,
    ::testing::Values(
        Malformed{"Angle", "\"kind\": \"field\"", "\"kind\": \"angle\"",
                  "c.json: this is an angle calibration, a field calibration is needed"},
        Malformed{"LaterVersion", "\"version\": 1", "\"version\": 2",
                  "c.json: the file is of version 2, this program reads version 1"},
        Malformed{"FullScaleMissing", "\"full_scale_T\"", "\"scale\"", "c.json: full_scale_T is missing"},
        Malformed{"FullScaleZero", "\"full_scale_T\": 2", "\"full_scale_T\": 0",
                  "c.json: full_scale_T is not positive"},
        Malformed{"AxisMissing", "\"y\": {", "\"w\": {", "c.json: axes.y is missing"},
        Malformed{"OffsetLength", "\"offset_T\": [", "\"offset_T\": [0, ",
                  "c.json: axes.x.offset_T has 3 entries instead of 2"},
        Malformed{"TextAmongNumbers", "\"nonlinearity\": [", "\"nonlinearity\": [\"a\", ",
                  "c.json: axes.x.nonlinearity[0] is a JSON string instead of a number"},
        Malformed{"NoCoefficients", "\"sensitivity_slope\": [", "\"sensitivity_slope\": [], \"was\": [",
                  "c.json: axes.x.sensitivity_slope has 0 entries instead of 1 to 16"},
        Malformed{"NoPt100", "\"pt100\": {", "\"pt\": {", "c.json: pt100 is missing, which axes.x.offset_T needs"},
        Malformed{"MatrixOfNumbers", "\"axis_matrix\": [", "\"axis_matrix\": [1, 2, 3], \"was\": [",
                  "c.json: axis_matrix is not 3 rows of 3 numbers"},
        Malformed{"SingularMatrix", "\"axis_matrix\": [", "\"axis_matrix\": [[1,0,0],[1,0,0],[0,0,1]], \"was\": [",
                  "c.json: axis_matrix is singular"},
        Malformed{"State", "\"state\": \"calibrated\"", "\"state\": \"better\"",
                  "c.json: verification[1].state is \"better\" but must be one of \"uncalibrated\", \"nonlinearity\", "
                  "\"offset\", \"sensitivity\", \"electronics\", \"electronics-sensitivity\", \"calibrated\", "
                  "\"axis-matrix\""}),
    [](const auto& param) { return param.param.name; });

TEST(FieldTables, ATablePerBlockThatIsOn) {
  FieldCalibration calibration = sample();
  for (AxisChain& axis : calibration.chain.axes) {
    axis.electronicsSensitivity.reset();
  }
  std::string names;
  for (const NamedTable& table : fieldBlockTables(calibration)) {
    names += table.fileName + " ";
  }
  EXPECT_EQ(names, "pt100.csv nonlinearity.csv offset.csv sensitivity.csv electronics.csv axis-matrix.csv "
                   "nonlinearity-orders.csv verification.csv ");
}

TEST(FieldTables, Content) {
  FieldCalibration calibration;
  calibration.chain.axes[0].nonlinearity = {0.1, 1.5};
  calibration.chain.axes[1].nonlinearity = {0.0, 1.0, 0.25};
  calibration.chain.axes[2].electronicsT = {1e-6, -2e-6};
  const auto tables = fieldBlockTables(calibration);
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[0].text, "axis,c_0,c_1,c_2\nx,0.1,1.5,\ny,0,1,0.25\nz,,,\n");
  EXPECT_EQ(tables[1].text, "axis,offset_0,offset_1\nx,,\ny,,\nz,1e-06,-2e-06\n");
  EXPECT_EQ(fieldCoefficientsCsv(calibration), "block,axis,name,power,value,unit\n"
                                               "nonlinearity,x,nonlinearity,0,0.1,T\n"
                                               "nonlinearity,x,nonlinearity,1,1.5,T/T\n"
                                               "nonlinearity,y,nonlinearity,0,0,T\n"
                                               "nonlinearity,y,nonlinearity,1,1,T/T\n"
                                               "nonlinearity,y,nonlinearity,2,0.25,T/T^2\n"
                                               "electronics,z,electronics_T,0,1e-06,T\n"
                                               "electronics,z,electronics_T,1,-2e-06,T/C\n");
}

} // namespace
} // namespace straightedge::exporting
