// Malformed presets and rigs: the message names the line or the key, the hint what belongs there.
#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/trace/light_rig_json.h"
#include "pipeline/volume/transfer_function_json.h"

namespace macula {
namespace {

// A minimal 3D Slicer file, with these opacity points.
std::string slicer(const std::string& points, const std::string& more = {}) {
    return R"({"volumeProperties": [{"components": [{"scalarOpacity": {"points": [)" + points +
           R"(]}, "rgbTransferFunction": {"points": [{"x": 0, "color": [1, 0.5, 0]}]}}]}])" + more + "}";
}

void expectError(const Result<TransferFunction>& read, const std::string& message, const std::string& hint) {
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.error().code, ErrorCode::inputNotUsable);
    EXPECT_EQ(read.error().where, "file.json");
    EXPECT_NE(read.error().message.english().find(message), std::string::npos) << read.error().message;
    EXPECT_NE(read.error().hint.english().find(hint), std::string::npos) << read.error().hint;
}

Result<TransferFunction> read(const std::string& text) {
    return transferFunctionFromJson(text, "file.json", "mine");
}

TEST(JsonErrors, SyntaxIsToldByLineAndColumn) {
    expectError(read("{\n  \"a\": 1,\n  oops\n}"), "line 3, column 3", "comma");
    expectError(read(""), "line 1, column 1", "");
    expectError(read(R"({"a": 1e999})"), "JSON", "");
}

TEST(JsonErrors, ContentIsToldByKey) {
    expectError(read("[]"), "The file", "object");
    expectError(read("{}"), "volumeProperties", "Add it");
    expectError(read(R"({"volumeProperties": []})"), "volumeProperties", "list");
    expectError(read(slicer(R"({"x": 0, "y": 2})")), "scalarOpacity.points[0].y", "from 0 to 1");
    expectError(read(slicer(R"({"x": 0, "y": "a"})")), "points[0].y", "number");
    expectError(read(slicer(R"({"x": 0})")), "points[0].y is missing", "");
    expectError(read(slicer("")), "scalarOpacity.points", "list");
    expectError(read(slicer(R"({"x": 5, "y": 0}, {"x": 4, "y": 1})")), "points[1].x", "sorted");
    expectError(read(slicer(R"({"x": 5, "y": 0})", R"(, "macula": {"version": 2})")), "macula.version",
                "newer");
    expectError(read(slicer(R"({"x": 5, "y": 0})", R"(, "macula": {"version": 1, "name": "../x"})")),
                "macula.name", "lower-case");
}

TEST(JsonErrors, SlicerFilesAreReadAsTheyAre) {
    const auto plain = read(slicer(R"({"x": 0, "y": 0}, {"x": 100, "y": 1})"));
    ASSERT_TRUE(plain.ok()) << plain.error().message;
    EXPECT_EQ(plain->name, "mine");
    EXPECT_EQ(plain->unit, Unit::hounsfield);
    EXPECT_EQ(plain->opacity.size(), 2u);
    EXPECT_DOUBLE_EQ(opacityAt(*plain, 25.0), 0.25);

    // Midpoint: the half value lies there. Sharpness 1: a step there.
    const auto bent =
        read(slicer(R"({"x": 0, "y": 0, "midpoint": 0.25, "sharpness": 0}, {"x": 100, "y": 1})"));
    ASSERT_TRUE(bent.ok());
    EXPECT_NEAR(opacityAt(*bent, 25.0), 0.5, 1e-9);
    EXPECT_NEAR(opacityAt(*bent, 62.5), 0.75, 1e-9);
    const auto step =
        read(slicer(R"({"x": 0, "y": 0, "midpoint": 0.5, "sharpness": 1}, {"x": 100, "y": 1})"));
    ASSERT_TRUE(step.ok());
    EXPECT_NEAR(opacityAt(*step, 45.0), 0.0, 1e-9);
    EXPECT_NEAR(opacityAt(*step, 55.0), 1.0, 1e-9);
    const auto soft =
        read(slicer(R"({"x": 0, "y": 0, "midpoint": 0.5, "sharpness": 0.5}, {"x": 100, "y": 1})"));
    ASSERT_TRUE(soft.ok());
    EXPECT_NEAR(opacityAt(*soft, 50.0), 0.5, 1e-9);
    EXPECT_LT(opacityAt(*soft, 25.0), 0.25);
}

TEST(JsonErrors, LightRigs) {
    const std::string head = R"({"version": 1, "name": "a", "title": "A", "frame": )";
    const std::string sky =
        R"(, "ambient": {"zenith": [1, 1, 1], "horizon": [1, 1, 1], "nadir": [0, 0, 0]}, "lights": [)";
    EXPECT_TRUE(trace::lightRigFromJson(head + R"("camera")" + sky + "]}", "f").ok());
    const auto expectKey = [](const std::string& text, const std::string& key) {
        const auto rig = trace::lightRigFromJson(text, "f");
        ASSERT_FALSE(rig.ok());
        EXPECT_NE(rig.error().message.english().find(key), std::string::npos) << rig.error().message;
    };
    expectKey(head + R"("room")" + sky + "]}", "frame");
    expectKey(head + R"("camera")" + sky + R"({"azimuth": 3}]})", "lights[0].azimuth is unknown");
    expectKey(head + R"("camera")" + sky + R"({"azimuthDeg": 3}]})", "elevationDeg is missing");
    expectKey(head + R"("camera", "lights": []})", "ambient is missing");
    expectKey(R"({"version": 1, "name": "a", "title": "A", "frame": "camera", "lights": [],
        "ambient": {"zenith": [0, 0, 0], "horizon": [0, 0, 0], "nadir": [0, 0, 0]}})",
              "The file is not as expected");
}

}  // namespace
}  // namespace macula
