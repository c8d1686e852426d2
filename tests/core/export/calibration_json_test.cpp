#include "core/export/calibration_json.h"

#include <gtest/gtest.h>

#include <limits>

namespace straightedge::exporting {
namespace {

using namespace angle;

Model harmonicModel() {
  Model model;
  model.name = {ModelKind::Harmonic, 2, FitMethod::ByAmplitude, std::nullopt};
  model.body = HarmonicModel{-89.82120676800716, {{2, 1.0 / 3.0, -3.0}, {1, 5e-324, 0.1}}};
  model.errors = {0.4, 0.1 + 0.2, 0.5, 1e-17};
  return model;
}

Model linearModel() {
  Model model;
  model.name = {ModelKind::Linear, 3, FitMethod::Minimax, std::nullopt};
  model.body = LinearModel{Eigen::Vector3d(0.1, -180.00000000000003, 12.0)};
  return model;
}

Model quantisedTable() {
  Model model;
  model.name = {ModelKind::LookupTable, 2, FitMethod::Mean, 8};
  model.body = LookupTableModel{Eigen::Vector2d(10.0 - 0.5 * 127, 10.0 + 0.5 * 127)};
  model.stored = StoredIntegers{8, 0.5, 10.0, std::nullopt, {-127, 127}};
  return model;
}

AngleCalibration sample() {
  AngleCalibration calibration;
  calibration.created = "2026-03-01T09:30:00Z";
  calibration.software = "straightedge 0.1.0";
  calibration.source = {"a \"b\".csv", std::string(64, 'a'), 32};
  calibration.traceability = {"SN 1", "MAG\\X", "J. Ünal", {"RON 886", "7", "C-1", "2027-01-31", 0.001}, 23.1};
  calibration.direction = SensorDirection::Decreasing;
  calibration.models = {harmonicModel(), linearModel(), quantisedTable()};
  calibration.uncertainty = {{"harmonic:2", {{"noise", 0.01, "normal"}}, 0.01, 2.0, 0.02}};
  calibration.curveMethod = CurveMethod::Regress;
  calibration.curveHarmonics = 6;
  calibration.leaveOneOutRmsDeg = 0.144;
  calibration.leaveOneOutMaxDeg = 0.3;
  calibration.passes.noiseDeg = 0.02;
  calibration.passes.turns = 3;
  calibration.passes.bothDirections = true;
  calibration.gaps = {{350.0, 20.5}};
  calibration.warnings = {{Warning::Topic::CoverageGap, "There is a gap."}};
  return calibration;
}

TEST(CalibrationJson, ReadsBackToTheSameDoubles) {
  const AngleCalibration written = sample();
  const auto read = calibrationFromJson(calibrationToJson(written), "c.json");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->created, written.created);
  EXPECT_EQ(read->software, written.software);
  EXPECT_EQ(read->source.file, written.source.file);
  EXPECT_EQ(read->source.points, 32);
  EXPECT_EQ(read->traceability.operatorName, "J. Ünal");
  EXPECT_EQ(read->traceability.reference.due, "2027-01-31");
  EXPECT_EQ(read->traceability.reference.uncertainty, 0.001);
  EXPECT_EQ(read->traceability.ambientC, 23.1);
  EXPECT_EQ(read->direction, SensorDirection::Decreasing);
  ASSERT_EQ(read->models.size(), 3U);

  const auto& harmonics = std::get<HarmonicModel>(read->models[0].body);
  EXPECT_EQ(harmonics.offsetDeg, -89.82120676800716);
  ASSERT_EQ(harmonics.terms.size(), 2U);
  EXPECT_EQ(harmonics.terms[0].order, 2);
  EXPECT_EQ(harmonics.terms[0].amplitudeDeg, 1.0 / 3.0);
  EXPECT_EQ(harmonics.terms[1].amplitudeDeg, 5e-324);
  EXPECT_EQ(read->models[0].errors.rmsCurveDeg, 0.1 + 0.2);
  EXPECT_EQ(read->models[0].errors.rmsPointsDeg, 1e-17);
  EXPECT_EQ(read->models[1].name.text(), "linear:3@minimax");
  EXPECT_EQ(std::get<LinearModel>(read->models[1].body).valuesDeg, Eigen::Vector3d(0.1, -180.00000000000003, 12.0));
  ASSERT_TRUE(read->models[2].stored);
  EXPECT_EQ(read->models[2].stored->integers, (std::vector<int>{-127, 127}));

  ASSERT_EQ(read->uncertainty.size(), 1U);
  EXPECT_EQ(read->uncertainty[0].contributions[0].standardDeg, 0.01);
  EXPECT_EQ(read->curveMethod, CurveMethod::Regress);
  EXPECT_EQ(read->curveHarmonics, 6);
  EXPECT_EQ(read->passes.turns, 3);
  EXPECT_EQ(read->gaps[0].widthDeg, 20.5);
  EXPECT_EQ(read->warnings[0].topic, Warning::Topic::CoverageGap);
  EXPECT_EQ(calibrationToJson(*read), calibrationToJson(written));
}

TEST(CalibrationJson, OptionalAndUnknownKeysDoNotMatter) {
  const auto read = calibrationFromJson(R"({"format": "straightedge-calibration", "version": 1, "kind": "angle",
    "created": "2026-03-01T09:30:00Z", "software": "other", "source": {"file": "a", "sha256": "", "points": 8},
    "device": {"serial": "", "model": ""}, "direction": "increasing", "future": {"x": [1]}, "uncertainty": "0.1 deg",
    "warnings": [{"topic": "of-a-later-version", "text": "Look."}],
    "models": [{"name": "linear:2", "storage_entries": 2, "max_error_deg": {"curve": 1, "points": 1},
                "rms_error_deg": {"curve": 1, "points": 1}, "values_deg": [1, 2], "colour": "red"}]})",
                                        "c.json");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(std::get<LinearModel>(read->models[0].body).valuesDeg[1], 2.0);
  EXPECT_EQ(read->warnings[0].text, "Look.");
}

TEST(CalibrationJson, ModelsAreFoundByName) {
  const AngleCalibration calibration = sample();
  EXPECT_EQ(findModel(calibration, "", "c.json").value(), calibration.models.data());
  EXPECT_EQ(findModel(calibration, "linear:3@minimax", "c.json").value(), &calibration.models[1]);
  EXPECT_EQ(
      findModel(calibration, "linear:4", "c.json").error().message(),
      "c.json: there is no model linear:4 in the calibration; choose one of harmonic:2, linear:3@minimax, lut:2/8");
}

struct Malformed {
  std::string name;
  std::string find;    ///< in the sample's text; empty: the whole text
  std::string replace; ///< by this
  std::string what;    ///< in the message
};
void PrintTo(const Malformed& malformed, std::ostream* out) { *out << malformed.name; }

class CalibrationJsonRefuses : public ::testing::TestWithParam<Malformed> {};

TEST_P(CalibrationJsonRefuses, WithTheKeyAndWhatIsWrong) {
  std::string text = calibrationToJson(sample());
  if (GetParam().find.empty()) {
    text = GetParam().replace;
  } else {
    const auto at = text.find(GetParam().find);
    ASSERT_NE(at, std::string::npos) << text;
    text.replace(at, GetParam().find.size(), GetParam().replace);
  }
  const auto read = calibrationFromJson(text, "c.json");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().kind, ErrorKind::Input);
  EXPECT_FALSE(read.error().remedy.empty());
  EXPECT_EQ(read.error().where + ": " + read.error().what, GetParam().what);
}

INSTANTIATE_TEST_SUITE_P(
    Malformed, CalibrationJsonRefuses,
    ::testing::Values(
        Malformed{"Empty", "", "", "c.json: the file is empty"},
        Malformed{"Csv", "", "encoder_deg,sensor_deg\n", "c.json:1: this is not JSON at column 1"},
        Malformed{"CutOff", "", "{\"format\":\n \"straightedge-calibration\",\n",
                  "c.json:3: the file ends too early, it is not complete JSON"},
        Malformed{"NotANumber", "\"version\": 1", "\"version\": NaN", "c.json:3: this is not JSON at column 14"},
        Malformed{"TooLarge", "0.4,", "1e999,", "c.json: a number is too large to be read"},
        Malformed{"List", "", "[1]", "c.json: the file is a JSON array instead of an object"},
        Malformed{"OtherFormat", "", "{\"format\": \"x\"}", "c.json: this is not a Straightedge calibration"},
        Malformed{"NoFormat", "", "{}", "c.json: this is not a Straightedge calibration"},
        Malformed{"LaterVersion", "\"version\": 1", "\"version\": 2",
                  "c.json: the file is of version 2, this program reads version 1"},
        Malformed{"VersionOfText", "\"version\": 1", "\"version\": \"1\"",
                  "c.json: version is a JSON string instead of a number"},
        Malformed{"Field", "\"kind\": \"angle\"", "\"kind\": \"field\"",
                  "c.json: this is a field calibration, an angle calibration is needed"},
        Malformed{"OtherKind", "\"kind\": \"angle\"", "\"kind\": \"force\"",
                  "c.json: the calibration is of the unknown kind \"force\""},
        Malformed{"NoKind", "\"kind\": \"angle\",", "", "c.json: kind is missing"},
        Malformed{"Direction", "\"decreasing\"", "\"sideways\"",
                  "c.json: direction is \"sideways\" but must be one of \"increasing\", \"decreasing\""},
        Malformed{"ModelName", "\"harmonic:2\"", "\"spline:2\"",
                  "c.json: models[0].name: model 'spline:2': unknown kind 'spline'"},
        Malformed{"MissingKey", "\"offset_deg\": -89.82120676800716,", "", "c.json: models[0].offset_deg is missing"},
        Malformed{"MissingValues", "\"values_deg\"", "\"values\"", "c.json: models[1].values_deg is missing"},
        Malformed{"TooFewValues", "[0.1, -180.00000000000003, 12]", "[0.1, 12]",
                  "c.json: models[1].values_deg has 2 entries instead of 3"},
        Malformed{"TextAmongValues", "[0.1, -180.00000000000003, 12]", "[0.1, \"a\", 12]",
                  "c.json: models[1].values_deg[1] is a JSON string instead of a number"},
        Malformed{"NullAmongValues", "[0.1, -180.00000000000003, 12]", "[0.1, null, 12]",
                  "c.json: models[1].values_deg[1] is a JSON null instead of a number"},
        Malformed{"TooFewHarmonics", "\"name\": \"harmonic:2\",\n      \"storage_entries\": 5",
                  "\"name\": \"harmonic:3\",\n      \"storage_entries\": 7",
                  "c.json: models[0].harmonics has 2 entries instead of 3"},
        Malformed{"SameOrder", "{\"order\": 1,", "{\"order\": 2,",
                  "c.json: models[0].harmonics[1].order is 2 for the second time"},
        Malformed{"FractionalOrder", "{\"order\": 1,", "{\"order\": 1.5,",
                  "c.json: models[0].harmonics[1].order is 1.5 but must be a whole number from 1 to 2048"},
        Malformed{"Entries", "\"storage_entries\": 5", "\"storage_entries\": 4",
                  "c.json: models[0].storage_entries is 4 but harmonic:2 has 5"},
        Malformed{"ErrorsMissing", "\"max_error_deg\"", "\"max_error\"", "c.json: models[0].max_error_deg is missing"},
        Malformed{"IntegerRange", "[-127, 127]", "[-127, 128]",
                  "c.json: models[2].stored.integers[1] is 128 but must be a whole number from -128 to 127"},
        Malformed{"IntegersDisagree", "[-127, 127]", "[-127, 120]",
                  "c.json: models[2].stored does not stand for the values of the model"},
        Malformed{"Bits", "\"bits\": 8", "\"bits\": 9", "c.json: models[2].stored.bits is 9 but the model is lut:2/8"},
        Malformed{"ModelsNoList", "\"models\": [", "\"models\": 1, \"others\": [",
                  "c.json: models is a JSON number instead of a list"}),
    [](const auto& param) { return param.param.name; });

TEST(CalibrationJson, WithoutModelsThereIsNothingToApply) {
  AngleCalibration calibration = sample();
  calibration.models.clear();
  const auto read = calibrationFromJson(calibrationToJson(calibration), "c.json");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message(), "c.json: the calibration holds no models; fit again with at least one --model");
}

} // namespace
} // namespace straightedge::exporting
