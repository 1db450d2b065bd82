// Measurements as CSV and JSON: what another program reads of them.
#include "scene/slices/measurements_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <locale>
#include <map>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "support.h"

namespace macula::scene {
namespace {

using dicom::test::TemporaryFolder;
using nlohmann::json;
using slices::Angle;
using slices::Distance;
using slices::Ellipse;
using slices::Measurement;

using Row = std::map<std::string, std::string>;  // by the name of the column

// All of a text as RFC 4180 has it, by itself: lines of fields, each in quotes or without any.
std::vector<std::vector<std::string>> fieldsOf(const std::string& text) {
    std::vector<std::vector<std::string>> lines;
    std::size_t i = 0;
    while (i < text.size()) {
        std::vector<std::string>& line = lines.emplace_back();
        for (bool goesOn = true; goesOn;) {
            std::string& field = line.emplace_back();
            const bool isQuoted = i < text.size() && text[i] == '"';
            if (isQuoted) ++i;
            for (; i < text.size(); ++i) {
                if (isQuoted && text[i] == '"') {
                    if (i + 1 >= text.size() || text[i + 1] != '"') break;
                    ++i;
                } else if (!isQuoted && (text[i] == ',' || text[i] == '\r')) {
                    break;
                }
                EXPECT_TRUE(isQuoted || (text[i] != '"' && text[i] != '\n')) << "must be in quotes";
                field += text[i];
            }
            if (isQuoted) ++i;
            goesOn = i < text.size() && text[i] == ',';
            i += goesOn ? 1 : 2;
        }
        EXPECT_LE(i, text.size());
        EXPECT_EQ(text.substr(i - 2, 2), "\r\n");
    }
    return lines;
}

std::vector<Row> rowsOf(const std::string& csv) {
    const auto lines = fieldsOf(csv);
    EXPECT_FALSE(lines.empty());
    std::vector<Row> rows;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        EXPECT_EQ(lines[i].size(), lines[0].size());
        Row& row = rows.emplace_back();
        for (std::size_t f = 0; f < std::min(lines[i].size(), lines[0].size()); ++f)
            EXPECT_TRUE(row.emplace(lines[0][f], lines[i][f]).second) << "a column of that name before";
    }
    return rows;
}

// 9 x 9 x 3 voxels of 1 mm at their indices: 0 at i = 4 and around, 200 from i = 5 on.
Volume volumeOf(Unit unit, const std::string& unitName = {}, bool isCalibrated = true) {
    std::vector<std::uint16_t> voxels(9 * 9 * 3);
    for (std::size_t n = 0; n < voxels.size(); ++n) voxels[n] = n % 9 > 4 ? 200 : 0;
    auto made = Volume::create({.size = {9, 9, 3},
                                .unit = unit,
                                .provenance = {.studyInstanceUid = "1.2.3.4",
                                               .description = "Doe^John",
                                               .isCalibrated = isCalibrated},
                                .unitName = unitName},
                               std::move(voxels));
    EXPECT_TRUE(made.ok());
    return std::move(made).value();
}

std::vector<Measurement> oneOfEachKind() {
    Ellipse ellipse{.radiiMm = {1.1, 1.2}};
    ellipse.plane.centreMm = {4.0, 4.0, 1.0};
    return {{.label = "cyst, \"left\"\nlobe",
             .shape = Distance{{glm::dvec3(-1.0, 2.0, 3.0), {2.0, 6.0, 15.00049}}},
             .normal = {1.0, 0.0, 0.0}},
            {.shape = Angle{{glm::dvec3(1.0, 0.0, -0.0001), {}, {1.0, 1.0, 0.0}}}},
            {.label = "Größe", .shape = ellipse}};
}

TEST(MeasurementsCsv, HasALineForEachWithAllNumbers) {
    const std::string csv = measurementsCsv(oneOfEachKind(), volumeOf(Unit::hounsfield));
    EXPECT_TRUE(
        csv.starts_with("kind,label,length_mm,angle_deg,area_mm2,voxels,mean,deviation,low,high,unit,"
                        "x1_mm,y1_mm,z1_mm,x2_mm,y2_mm,z2_mm,x3_mm,y3_mm,z3_mm,"
                        "normal_x,normal_y,normal_z,calibrated,slice,image,interpolated_voxels,short_mm,"
                        "node,x4_mm,y4_mm,z4_mm\r\n"));
    std::vector<Row> rows = rowsOf(csv);
    ASSERT_EQ(rows.size(), 3u);
    Row& distance = rows[0];
    EXPECT_EQ(distance["kind"], "distance");
    EXPECT_EQ(distance["label"], "cyst, \"left\"\nlobe");
    EXPECT_EQ(distance["length_mm"], "13.000");
    for (const char* none : {"angle_deg", "area_mm2", "voxels", "mean", "unit", "x3_mm", "z3_mm"})
        EXPECT_EQ(distance[none], "") << none;
    EXPECT_EQ(distance["x1_mm"], "-1.000");
    EXPECT_EQ(distance["y1_mm"], "2.000");
    EXPECT_EQ(distance["z1_mm"], "3.000");
    EXPECT_EQ(distance["x2_mm"], "2.000");
    EXPECT_EQ(distance["z2_mm"], "15.000");
    EXPECT_EQ(distance["normal_x"], "1.000");

    Row& angle = rows[1];
    EXPECT_EQ(angle["kind"], "angle");
    EXPECT_EQ(angle["label"], "");
    EXPECT_EQ(angle["angle_deg"], "45.000");
    EXPECT_EQ(angle["length_mm"], "");
    EXPECT_EQ(angle["z1_mm"], "0.000") << "no minus before a zero";
    EXPECT_EQ(angle["x2_mm"], "0.000");
    EXPECT_EQ(angle["y3_mm"], "1.000");

    // Five voxels, one of which is 200: a mean of 40 and a deviation of 200 / sqrt(5).
    Row& ellipse = rows[2];
    EXPECT_EQ(ellipse["kind"], "ellipse");
    EXPECT_EQ(ellipse["label"], "Größe");
    EXPECT_EQ(ellipse["area_mm2"], "4.147");
    EXPECT_EQ(ellipse["voxels"], "5");
    EXPECT_EQ(ellipse["mean"], "40");
    EXPECT_EQ(ellipse["deviation"], "89.4427191");
    EXPECT_EQ(ellipse["low"], "0");
    EXPECT_EQ(ellipse["high"], "200");
    EXPECT_EQ(ellipse["unit"], "HU");
    EXPECT_EQ(ellipse["x1_mm"], "4.000");
    EXPECT_EQ(ellipse["x2_mm"], "5.100") << "the end of its radius to the right";
    EXPECT_EQ(ellipse["y3_mm"], "5.200") << "the end of its radius down";
    EXPECT_EQ(ellipse["normal_z"], "1.000");
}

TEST(MeasurementsCsv, WithoutMeasurementsIsTheLineOfNames) {
    EXPECT_TRUE(rowsOf(measurementsCsv({}, volumeOf(Unit::raw))).empty());
}

TEST(MeasurementsCsv, NoTextIsAFormulaForASpreadsheet) {
    const std::vector<std::string> dangerous{
        "=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "\r=1", "\n=1", "  =1", "=HYPERLINK(\"http://a\",\"b\")"};
    std::vector<Measurement> measurements;
    for (const std::string& label : dangerous) measurements.push_back({.label = label, .shape = Distance{}});
    std::vector<Row> rows = rowsOf(measurementsCsv(measurements, volumeOf(Unit::hounsfield)));
    ASSERT_EQ(rows.size(), dangerous.size());
    for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i]["label"], "'" + dangerous[i]);

    for (const std::string harmless : {"L3 = 5", "a+b", "'quoted'", " ", "ß", "T-1"}) {
        measurements = {{.label = harmless, .shape = Distance{}}};
        EXPECT_EQ(rowsOf(measurementsCsv(measurements, volumeOf(Unit::hounsfield))).at(0)["label"], harmless);
    }
    // The unit is a word of the file.
    const auto unit = rowsOf(measurementsCsv(oneOfEachKind(), volumeOf(Unit::other, "=cmd|'/c'!A1"))).at(2);
    EXPECT_EQ(unit.at("unit"), "'=cmd|'/c'!A1");
}

TEST(MeasurementsCsv, WhatIsNotDefinedIsEmpty) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    Ellipse outside{.radiiMm = {2.0, 2.0}};
    outside.plane.centreMm = {4.0, 4.0, 100.0};
    std::vector<Row> rows = rowsOf(measurementsCsv(
        std::vector<Measurement>{{.shape = Distance{{glm::dvec3(nan, 0.0, 0.0), {infinity, 0.0, 0.0}}}},
                                 {.shape = Angle{}},
                                 {.shape = outside}},
        volumeOf(Unit::hounsfield)));
    ASSERT_EQ(rows.size(), 3u);
    for (const char* empty : {"length_mm", "x1_mm", "x2_mm"}) EXPECT_EQ(rows[0][empty], "") << empty;
    EXPECT_EQ(rows[0]["y1_mm"], "0.000");
    EXPECT_EQ(rows[1]["angle_deg"], "");
    EXPECT_EQ(rows[2]["area_mm2"], "12.566");
    for (const char* empty : {"voxels", "mean", "deviation", "low", "high", "unit"})
        EXPECT_EQ(rows[2][empty], "") << empty;
}

// By which a report finds it again: the InstanceNumber, not the place in the volume.
TEST(Measurements, SayTheSliceItsImageAndWhatIsInterpolated) {
    std::vector<std::uint16_t> voxels(9 * 9 * 3, 7);
    VolumeOptions options{.size = {9, 9, 3}};
    options.provenance.interpolatedSlices = {{2, 2}};
    const auto volume = Volume::create(std::move(options), std::move(voxels));
    const std::vector<int> numbers{153, 152, 0};
    std::vector<Measurement> measurements = oneOfEachKind();  // through slices, in the first, in the second
    measurements.push_back(measurements[2]);
    std::get<Ellipse>(measurements[3].shape).plane.centreMm.z = 2.0;
    std::vector<Row> rows = rowsOf(measurementsCsv(measurements, {*volume, numbers}));
    ASSERT_EQ(rows.size(), 4u);
    EXPECT_EQ(rows[0]["slice"] + rows[0]["image"], "") << "it goes through several";
    EXPECT_EQ(rows[1]["slice"], "1");
    EXPECT_EQ(rows[1]["image"], "153");
    EXPECT_EQ(rows[1]["interpolated_voxels"], "") << "it has no voxels";
    EXPECT_EQ(rows[2]["slice"], "2");
    EXPECT_EQ(rows[2]["image"], "152");
    EXPECT_EQ(rows[2]["interpolated_voxels"], "0");
    EXPECT_EQ(rows[3]["slice"], "3");
    EXPECT_EQ(rows[3]["image"], "") << "there is none";
    EXPECT_EQ(rows[3]["interpolated_voxels"], "5");
    const json all = json::parse(measurementsJsonText(measurements, {*volume, numbers}));
    EXPECT_FALSE(all.at("measurements")[0].contains("slice"));
    EXPECT_EQ(all.at("measurements")[2].at("image"), 152);
    EXPECT_EQ(all.at("measurements")[3].at("interpolatedVoxels"), 5);
}

struct Commas : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(MeasurementsFile, NumbersHaveAPointWhateverTheLocale) {
    const Volume volume = volumeOf(Unit::hounsfield);
    std::vector<Measurement> measurements = oneOfEachKind();
    measurements.push_back({.shape = Distance{{glm::dvec3(0.0), {12345.678, 0.0, 0.0}}}});
    const std::string csv = measurementsCsv(measurements, volume);
    const std::string text = measurementsJsonText(measurements, volume);
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Commas));
    const std::string csvThere = measurementsCsv(measurements, volume);
    const std::string textThere = measurementsJsonText(measurements, volume);
    std::locale::global(before);
    EXPECT_EQ(csvThere, csv);
    EXPECT_EQ(textThere, text);
    EXPECT_EQ(rowsOf(csv).at(3).at("length_mm"), "12345.678");
}

// In spreadsheets each line may go its own way.
TEST(Measurements, SayWhetherPixelsAreCalibrated) {
    for (const bool isCalibrated : {true, false}) {
        const Volume volume = volumeOf(Unit::hounsfield, {}, isCalibrated);
        std::vector<Row> rows = rowsOf(measurementsCsv(oneOfEachKind(), volume));
        ASSERT_EQ(rows.size(), 3u);
        for (Row& row : rows) EXPECT_EQ(row["calibrated"], isCalibrated ? "yes" : "no");
        EXPECT_EQ(rows[0]["length_mm"], "13.000") << "a number stays one";
        const json all = json::parse(measurementsJsonText(oneOfEachKind(), volume));
        EXPECT_EQ(all.at("calibrated"), isCalibrated);
    }
}

TEST(MeasurementsJson, HasWhatWasDrawnAndWhatItSays) {
    const json all = json::parse(measurementsJsonText(oneOfEachKind(), volumeOf(Unit::hounsfield)));
    EXPECT_EQ(all.at("version"), 1);
    EXPECT_EQ(all.at("frame"), "patient LPS, mm");
    const json& measurements = all.at("measurements");
    ASSERT_EQ(measurements.size(), 3u);
    EXPECT_EQ(measurements[0].at("kind"), "distance");
    EXPECT_EQ(measurements[0].at("label"), "cyst, \"left\"\nlobe");
    EXPECT_NEAR(measurements[0].at("lengthMm").get<double>(), 13.0, 1e-3);
    EXPECT_EQ(measurements[0].at("pointsMm").at(1), json({2.0, 6.0, 15.00049}));
    EXPECT_EQ(measurements[0].at("normal"), json({1.0, 0.0, 0.0}));
    EXPECT_NEAR(measurements[1].at("angleDeg").get<double>(), 45.0, 1e-3);
    EXPECT_FALSE(measurements[1].contains("label"));
    const json& ellipse = measurements[2];
    EXPECT_EQ(ellipse.at("centreMm"), json({4.0, 4.0, 1.0}));
    EXPECT_EQ(ellipse.at("radiiMm"), json({1.1, 1.2}));
    EXPECT_EQ(ellipse.at("voxels"), 5);
    EXPECT_DOUBLE_EQ(ellipse.at("mean").get<double>(), 40.0);
    EXPECT_EQ(ellipse.at("unit"), "HU");
}

TEST(MeasurementsJson, WhatIsNotDefinedIsNull) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Ellipse one{.radiiMm = {0.1, 0.1}};
    one.plane.centreMm = {4.0, 4.0, 1.0};
    const std::vector<Measurement> measurements{
        {.label = "\xff=", .shape = Distance{{glm::dvec3(nan, 0.0, 0.0), {}}}},
        {.shape = Angle{}},
        {.shape = one},
        {.shape = Ellipse{}}};
    const json all = json::parse(measurementsJsonText(measurements, volumeOf(Unit::raw)), nullptr, false);
    ASSERT_FALSE(all.is_discarded()) << "is JSON all the same";
    const json& read = all.at("measurements");
    EXPECT_TRUE(read[0].at("lengthMm").is_null());
    EXPECT_TRUE(read[0].at("pointsMm").at(0).at(0).is_null());
    EXPECT_TRUE(read[1].at("angleDeg").is_null());
    EXPECT_EQ(read[2].at("voxels"), 1);
    EXPECT_TRUE(read[2].at("deviation").is_null()) << "one value has none";
    EXPECT_EQ(read[2].at("unit"), "");
    EXPECT_FALSE(read[3].contains("mean"));
    EXPECT_EQ(read[3].at("areaMm2"), 0.0);
}

TEST(MeasurementsFile, IsWrittenByItsEndingAndNamesNobody) {
    const TemporaryFolder folder;
    const Volume volume = volumeOf(Unit::hounsfield);
    const std::vector<Measurement> measurements = oneOfEachKind();
    ASSERT_TRUE(writeMeasurements(folder / "a.csv", measurements, volume));
    ASSERT_TRUE(writeMeasurements(folder / "a.JSON", measurements, volume));
    const std::string csv = *readText(folder / "a.csv");
    const std::string text = *readText(folder / "a.JSON");
    EXPECT_EQ(csv, measurementsCsv(measurements, volume));
    EXPECT_EQ(text, measurementsJsonText(measurements, volume));
    for (const char* secret : {"Doe", "1.2.3.4"}) {
        EXPECT_EQ(csv.find(secret), std::string::npos) << secret;
        EXPECT_EQ(text.find(secret), std::string::npos) << secret;
    }

    const auto refused = writeMeasurements(folder / "a.txt", measurements, volume);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::usage);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
    const auto nowhere = writeMeasurements(folder / "no/a.csv", measurements, volume);
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().code, ErrorCode::outputNotWritable);
}

}  // namespace
}  // namespace macula::scene
