// 3D Slicer's and MITK's files, and how formats are told apart.
#include <limits>

#include "presets/imported.h"
#include "presets/preset_name.h"

namespace macula::presets {
namespace {

const std::string kVp =
    "1\n1\n0.9\n0.1\n0.2\n10\n8 -3024 0 -16.5 0 641 0.7 3071 0.75\n4 0 1 255 1\n8 0 1 0 0 10 0 0 1\n";

std::string slicerXml(const std::string& attributes) {
    return R"(<MRML><VolumeProperty name="MR-Test" )" + attributes + "/></MRML>";
}
const std::string kCurves = R"(scalarOpacity="4 0 0 10 1" colorTransfer="4 0 1 1 1")";

std::string mitk(const std::string& opacity, const std::string& colour) {
    return R"(<?xml version="1.0"?><Version TransferfunctionVersion="1"/><TransferFunction><ScalarOpacity>)" +
           opacity + R"(</ScalarOpacity><GradientOpacity><point x="0" y="1"/></GradientOpacity><Color>)" +
           colour + "</Color></TransferFunction>";
}
const std::string kMitkPoint = R"(<point x="0" r="1" g="0.5" b="0" midpoint="0.25" sharpness="0.75"/>)";

TEST(SlicerVp, HasNineLines) {
    const ImportedPreset preset = only(kVp, "CT-Mine.vp");
    EXPECT_EQ(preset.function.name, "ct-mine");
    EXPECT_EQ(preset.function.unit, Unit::hounsfield);
    EXPECT_TRUE(preset.notes.empty());
    EXPECT_EQ(preset.function.opacity.size(), 4u);
    EXPECT_EQ(opacityAt(preset.function, 2000.0), 0.7 + (2000.0 - 641.0) / (3071.0 - 641.0) * (0.75 - 0.7));
    EXPECT_EQ(preset.function.lighting, (Lighting{true, 0.1, 0.9, 0.2, 10.0}));
    EXPECT_FALSE(usesGradientOpacity(preset.function));
    std::string windows;
    for (const char c : kVp) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    EXPECT_EQ(only(windows, "CT-Mine.vp").function.opacity, preset.function.opacity);
    EXPECT_EQ(only(kVp, "other.vp").notes, std::vector<Text>{assumedHounsfield()});
}

TEST(SlicerVp, SaysWhichLineIsWrong) {
    expectRefused("1\n1\n0.9\n", "9 lines", "a.vp");
    expectRefused("", "empty", "a.vp");
    expectRefused("x" + kVp, "Line 1", "a.vp");
    expectRefused("1\n7" + kVp.substr(3), "Line 2", "a.vp");
    expectRefused(kVp.substr(0, 4) + "bright" + kVp.substr(7), "Line 3", "a.vp");
    expectRefused(kVp + "more\n", "this has 10", "a.vp");
}

TEST(SlicerXml, ReadsAttributesOfEveryVolumeProperty) {
    const ImportedPreset preset = only(
        slicerXml(kCurves + R"( shade="0" ambient="0.3" interpolation="0" effectiveRange="2 8" novel="x")"));
    EXPECT_EQ(preset.function.title, "MR-Test");
    EXPECT_EQ(preset.function.unit, Unit::raw);
    EXPECT_EQ(preset.function.modalities, std::vector<std::string>{"MR"});
    EXPECT_EQ(preset.function.effectiveRange, (ValueRange{2.0, 8.0}));
    EXPECT_EQ(preset.function.interpolation, Interpolation::nearest);
    EXPECT_FALSE(preset.function.lighting.shade);
    EXPECT_TRUE(preset.notes.empty());
}

// 3D Slicer moves the second of two points up by the least possible: the first holds at their value.
TEST(SlicerXml, AStepHoldsBelowItsSecondPoint) {
    const ImportedPreset preset =
        only(slicerXml(R"(scalarOpacity="8 0 0 5 0 5 1 9 1" colorTransfer="4 0 1 1 1")"));
    EXPECT_EQ(opacityAt(preset.function, 5.0), 0.0);
    EXPECT_EQ(opacityAt(preset.function, std::nextafter(5.0, 6.0)), 1.0);
    const ImportedPreset atZero =
        only(slicerXml(R"(scalarOpacity="8 0 0 0 0.5 0 1 9 1" colorTransfer="4 0 1 1 1")"));
    EXPECT_EQ(opacityAt(atZero.function, 0.0), 0.0);
    EXPECT_EQ(opacityAt(atZero.function, 1e-300), 1.0);
    // Doubles that are the same stay as they were written.
    const ImportedPreset same =
        only(slicerXml(R"(scalarOpacity="8 5 0 5 0 7 1 7 1" colorTransfer="4 0 1 1 1")"));
    EXPECT_EQ(same.function.opacity, (std::vector<OpacityPoint>{{5, 0}, {5, 0}, {7, 1}, {7, 1}}));
}

TEST(SlicerXml, ClampsHeightsAndSaysSo) {
    const ImportedPreset preset =
        only(slicerXml(R"(scalarOpacity="4 0 -0.5 10 1.5" colorTransfer="4 0 1 1 2")"));
    EXPECT_EQ(opacityAt(preset.function, 10.0), 1.0);
    EXPECT_EQ(opacityAt(preset.function, 0.0), 0.0);
    EXPECT_EQ(preset.notes.size(), 1u);
}

TEST(SlicerXml, RefusesCurvesThatMeanNothing) {
    const auto opacity = [](const std::string& curve) {
        return slicerXml("scalarOpacity=\"" + curve + R"(" colorTransfer="4 0 1 1 1")");
    };
    expectRefused(opacity(""), "empty");
    expectRefused(opacity("0"), "no points");
    expectRefused(opacity("6 0 0 10 1"), "should have 6 numbers and has 4");
    expectRefused(opacity("3 0 0 10"), "groups of 2");
    expectRefused(opacity("4 10 0 0 1"), "not sorted");
    expectRefused(opacity("4 0 0 nan 1"), "no usable number");
    expectRefused(opacity("4 0 0 inf 1"), "no usable number");
    expectRefused(opacity("4 0 0 1e999 1"), "no usable number");
    expectRefused(opacity("4 0 0 1e12 1"), "too large");
    expectRefused(opacity("4 0 0 1,5 1"), "no usable number");
    expectRefused(opacity("1e300 0 0"), "should have");
    expectRefused("<MRML/>", "no volume property");
    expectRefused(slicerXml(R"(colorTransfer="4 0 1 1 1")"), "scalarOpacity");
    expectRefused(slicerXml(kCurves + R"( specular="-1")"), "specular");
    expectRefused(slicerXml(kCurves + R"( interpolation="9")"), "interpolation");
}

TEST(SlicerJson, WithoutOurObjectIsNamedAfterItsFile) {
    const std::string json =
        R"({"volumeProperties": [{"components": [{"scalarOpacity": {"points": [{"x": 0, "y": 1}]},
            "rgbTransferFunction": {"points": [{"x": 0, "color": [1, 1, 1]}]}}]}, {}]})";
    const ImportedPreset preset = only(json, "MR-Mine.vp.json");
    EXPECT_EQ(preset.function.title, "MR-Mine");
    EXPECT_EQ(preset.function.name, "mr-mine");
    EXPECT_EQ(preset.function.unit, Unit::raw);
    EXPECT_EQ(preset.notes.size(), 1u) << "a second volume property is said to be left out";
}

TEST(MitkXml, HasTwoRoots) {
    const ImportedPreset preset = only(
        mitk(R"(<point x="10" y="1"/><point x="0" y="0"/><point x="10" y="0.5"/>)", kMitkPoint), "CT-M.xml");
    // Sorted, and of two points at one value the last, as VTK adds them.
    EXPECT_EQ(preset.function.opacity, (std::vector<OpacityPoint>{{0, 0}, {10, 0.5}}));
    EXPECT_EQ(preset.function.colour, (std::vector<ColourPoint>{{0, {1, 0.5, 0}, 0.25, 0.75}}));
    EXPECT_EQ(preset.function.source, "MITK");
    EXPECT_FALSE(usesGradientOpacity(preset.function));
    EXPECT_TRUE(preset.notes.empty());
}

TEST(MitkXml, RefusesWhatIsMissing) {
    expectRefused(mitk("", kMitkPoint), "ScalarOpacity");
    expectRefused(mitk(R"(<point x="0"/>)", kMitkPoint), "no usable y");
    expectRefused(mitk(R"(<point x="nan" y="0"/>)", kMitkPoint), "no usable x");
    expectRefused(mitk(R"(<point x="0" y="1"/>)", R"(<point x="0" r="1" g="1" b="1"/>)"), "midpoint");
    expectRefused(
        mitk(R"(<point x="0" y="1"/>)", R"(<point x="0" r="1" g="1" b="1" midpoint="3" sharpness="0"/>)"),
        "from 0 to 1");
    expectRefused(R"(<Version TransferfunctionVersion="2"/><TransferFunction/>)", "version");
}

TEST(PresetName, BecomesAKey) {
    EXPECT_EQ(keyFrom("CT-Coronary-Arteries-2"), "ct-coronary-arteries-2");
    EXPECT_EQ(keyFrom("  Knochen & Gefäße!  "), "knochen-gef-e");
    EXPECT_EQ(keyFrom("../../etc/passwd"), "etc-passwd");
    EXPECT_EQ(keyFrom("骨"), "preset");
    EXPECT_EQ(keyFrom(std::string(1000, 'a')).size(), 64u);
}

TEST(Formats, UnknownOnesAreSaid) {
    expectRefused("hello", "no preset of a known format");
    expectRefused("   \n", "empty");
    expectRefused(std::string_view("\0\0\0", 3), "empty");
}

}  // namespace
}  // namespace macula::presets
