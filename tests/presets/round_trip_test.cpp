// Export, import and export again give the same bytes, and nothing that others wrote is lost.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "pipeline/volume/json_writer.h"
#include "pipeline/volume/transfer_function_json.h"
#include "presets/embedded_files.h"
#include "presets/imported.h"

namespace macula {
namespace {

void expectEqual(const TransferFunction& a, const TransferFunction& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.title, b.title);
    EXPECT_EQ(a.number, b.number);
    EXPECT_EQ(a.source, b.source);
    EXPECT_EQ(a.modalities, b.modalities);
    EXPECT_EQ(a.unit, b.unit);
    EXPECT_EQ(a.opacity, b.opacity);
    EXPECT_EQ(a.colour, b.colour);
    EXPECT_EQ(a.gradientOpacity, b.gradientOpacity);
    EXPECT_EQ(a.colourSpace, b.colourSpace);
    EXPECT_EQ(a.unitDistanceMm, b.unitDistanceMm);
    EXPECT_EQ(a.density, b.density);
    EXPECT_EQ(a.albedo, b.albedo);
    EXPECT_EQ(a.anisotropy, b.anisotropy);
    EXPECT_EQ(a.surface, b.surface);
    EXPECT_EQ(a.steep, b.steep);
    EXPECT_EQ(a.fitToVolume, b.fitToVolume);
    EXPECT_EQ(a.lighting, b.lighting);
    EXPECT_EQ(a.interpolation, b.interpolation);
    EXPECT_EQ(a.effectiveRange, b.effectiveRange);
}

// Reads back what was written; writing that gives the same bytes.
void expectStable(const TransferFunction& function) {
    const std::string first = toJson(function);
    const auto read = transferFunctionFromJson(first, "first");
    ASSERT_TRUE(read.ok()) << read.error().message << " " << read.error().hint << "\n" << first;
    expectEqual(*read, function);
    EXPECT_EQ(toJson(*read), first);
    // Without the document as well: what is Macula's own says everything of it.
    TransferFunction bare = *read;
    bare.document.clear();
    const auto again = transferFunctionFromJson(toJson(bare), "again");
    ASSERT_TRUE(again.ok());
    expectEqual(*again, function);
}

TEST(RoundTrip, FilesThatAreCarriedAreWrittenAsTheyAre) {
    for (const auto& file : presets::transferFiles()) {
        const auto preset = transferFunctionFromJson(file.text, std::string(file.name));
        ASSERT_TRUE(preset.ok());
        EXPECT_EQ(toJson(*preset), file.text) << file.name << ": let macula presets import write it";
        expectStable(*preset);
    }
}

TEST(RoundTrip, AnyNumbers) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> fraction(0.0, 1.0);
    std::uniform_int_distribution<int> count(1, 9);
    for (int run = 0; run < 300; ++run) {
        TransferFunction f;
        f.name = "random";
        f.title = "Zuf\xC3\xA4llig \"\\\n";
        f.unit = run % 2 == 0 ? Unit::hounsfield : Unit::raw;
        const auto points = [&] {
            std::vector<double> values;
            for (int i = count(random); i > 0; --i)
                values.push_back((fraction(random) - 0.5) * std::pow(10.0, run % 12 - 3));
            std::sort(values.begin(), values.end());
            return values;
        };
        for (const double x : points())
            f.opacity.push_back({x, fraction(random), fraction(random), fraction(random)});
        for (const double x : points())
            f.colour.push_back({x,
                                {fraction(random), fraction(random), fraction(random)},
                                fraction(random),
                                fraction(random)});
        if (run % 3 == 0) {
            for (const double x : points()) f.gradientOpacity.push_back({x, fraction(random)});
        }
        f.density = 0.001 + fraction(random);
        f.albedo = fraction(random);
        f.anisotropy = 0.9 * fraction(random);
        f.surface = {fraction(random), 1e3 * fraction(random) + 1e-3, 0.1 + 0.9 * fraction(random),
                     fraction(random)};
        if (run % 5 == 1) {
            for (const double x : points())
                f.steep.opacity.push_back({x, fraction(random), fraction(random), fraction(random)});
            for (const double x : points())
                f.steep.colour.push_back({x, {fraction(random), fraction(random), fraction(random)}});
        }
        if (run % 5 > 1) f.steep.gradientPerMm = 1e3 * fraction(random) + 1e-3;
        f.unitDistanceMm = 0.1 + fraction(random);
        f.lighting = {run % 5 == 0, fraction(random), fraction(random), fraction(random),
                      100.0 * fraction(random)};
        f.colourSpace = static_cast<ColourSpace>(run % 6);
        f.interpolation = static_cast<Interpolation>(run % 3);
        if (run % 4 == 0) f.number = run + 1;
        if (run % 2 == 0) f.effectiveRange = ValueRange{-fraction(random), fraction(random) + 0.1};
        if (run % 8 == 0) {
            f.fitToVolume = TransferFunction::Fit{f.effectiveRange->low, f.effectiveRange->high,
                                                  static_cast<TransferFunction::Fit::To>(run / 8 % 2)};
        }
        expectStable(f);
    }
}

TEST(RoundTrip, OddDoubles) {
    TransferFunction f;
    f.name = "odd";
    f.opacity = {{-1e9, 0.1},
                 {-0.0, 1.0 / 3.0},
                 {std::numeric_limits<double>::denorm_min(), std::nextafter(1.0, 0.0)},
                 {std::numeric_limits<double>::min(), 1e-300},
                 {0.1 + 0.2, 5e-324},
                 {33600.00000000001, 1.0},
                 {1e9, -0.0}};
    f.colour = {{1e22 / 1e14, {0.0, 1.0, 0.5}}};
    f.opacity.back().opacity = 0.0;
    expectStable(f);
    EXPECT_NE(toJson(f).find("0.30000000000000004"), std::string::npos);
    EXPECT_NE(toJson(f).find("\"x\": -0.0,"), std::string::npos);
}

TEST(RoundTrip, UnknownKeysSurviveEverywhere) {
    const std::string text = R"({
        "before": {"a": [1, 2.50, null, {"deep": "\u00e4"}]}, "@schema": "mine",
        "volumeProperties": [{"isoSurfaceValues": [3], "useClippedVoxelIntensity": true, "vendor": 12345678901234567,
            "components": [{"scalarOpacity": {"type": "piecewiseLinearFunction", "extra": 1,
                "points": [{"x": 0, "y": 0, "midpoint": 0.5, "sharpness": 0, "label": "air"}, {"x": 10, "y": 1, "label": "bone"}]},
                "rgbTransferFunction": {"points": [{"x": 0, "color": [1, 0, 0], "tag": true}]},
                "grayTransferFunction": {"points": []}, "componentWeight": 0.5}, {"second": "component"}]},
            {"second": "property"}],
        "macula": {"version": 1, "name": "a", "title": "A", "modality": ["CT"], "unit": "HU", "author": "me", "fitToVolume": false},
        "after": "kept"})";
    auto read = transferFunctionFromJson(text, "f");
    ASSERT_TRUE(read.ok()) << read.error().message;
    const std::string first = toJson(*read);
    for (const char* kept : {"before", "deep", "\xC3\xA4", "2.5", "12345678901234567", "extra", "\"air\"",
                             "\"bone\"", "tag", "grayTransferFunction", "component\"", "\"property\"",
                             "author", "after", "\"mine\"", "[3]", "useClippedVoxelIntensity"}) {
        EXPECT_NE(first.find(kept), std::string::npos) << kept << "\n" << first;
    }
    expectStable(*read);
    // In the order in which they were, and numbers that say the same are not rewritten.
    EXPECT_LT(first.find("before"), first.find("@schema"));
    EXPECT_LT(first.find("macula"), first.find("after"));
    EXPECT_NE(first.find("\"x\": 0, \"y\": 0, \"midpoint\": 0.5, \"sharpness\": 0, \"label\": \"air\""),
              std::string::npos)
        << first;
    // A point that moved is another one; those at their place keep what was said of them.
    read->opacity[1].value = 12.0;
    read->opacity.push_back({20.0, 0.5});
    const std::string moved = toJson(*read);
    EXPECT_NE(moved.find("\"air\""), std::string::npos);
    EXPECT_EQ(moved.find("\"bone\""), std::string::npos);
    expectStable(*read);
}

// Gradient opacity that is switched off stays switched off, and stays in the file.
TEST(RoundTrip, DisabledGradientOpacity) {
    const std::string text = R"({"volumeProperties": [{"components": [{"disableGradientOpacity": true,
        "gradientOpacity": {"points": [{"x": 5, "y": 0.25}]}, "scalarOpacity": {"points": [{"x": 0, "y": 1}]},
        "rgbTransferFunction": {"points": [{"x": 0, "color": [1, 1, 1]}]}}]}]})";
    const auto read = transferFunctionFromJson(text, "f", "a");
    ASSERT_TRUE(read.ok());
    EXPECT_TRUE(read->gradientOpacity.empty());
    EXPECT_TRUE(validate(*read).ok());
    const std::string written = toJson(*read);
    EXPECT_NE(written.find("0.25"), std::string::npos);
    const auto again = transferFunctionFromJson(written, "f");
    ASSERT_TRUE(again.ok());
    EXPECT_TRUE(again->gradientOpacity.empty());
    EXPECT_EQ(toJson(*again), written);
}

// A view that holds a preset of 3D Slicer, which has no name, could be written but not opened again.
TEST(RoundTrip, APresetWithoutANameGetsOne) {
    const auto read = transferFunctionFromJson(
        R"({"volumeProperties": [{"components": [{"scalarOpacity": {"points": [{"x": 0, "y": 1}]},
            "rgbTransferFunction": {"points": [{"x": 0, "color": [1, 1, 1]}]}}]}]})",
        "f");
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(read->name, "preset");
    expectStable(*read);
}

TEST(RoundTrip, WhatOtherFormatsHoldComesThrough) {
    const auto vp =
        presets::only("0\n0\n0.9\n0.1\n0.2\n10\n8 -1 0 5 0 5 1 9 0.5\n4 0 1 5 0.5\n4 0 1 0 0\n", "US-a.vp");
    expectStable(vp.function);
    const auto map =
        presets::only(R"([{"Name": "a", "ColorSpace": "Diverging", "RGBPoints": [0, 0, 0, 1, 1, 1, 0, 0]}])");
    expectStable(map.function);
}

TEST(JsonWriter, ShortestNumbersAndLines) {
    using Json = nlohmann::ordered_json;
    EXPECT_EQ(prettyJson(Json(0.1)), "0.1\n");
    EXPECT_EQ(prettyJson(Json(100.0)), "100.0\n");
    EXPECT_EQ(prettyJson(Json(100)), "100\n");
    EXPECT_EQ(prettyJson(Json(1e300)), "1e+300\n");
    EXPECT_EQ(prettyJson(Json::parse(R"({"a": [1, 2], "b": {"c": {}}})")),
              "{\n    \"a\": [1, 2],\n    \"b\": {\n        \"c\": {}\n    }\n}\n");
    EXPECT_EQ(prettyJson(Json("\xFF\"")), "\"\xEF\xBF\xBD\\\"\"\n");
}

}  // namespace
}  // namespace macula
