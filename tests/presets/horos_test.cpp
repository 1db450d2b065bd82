// Presets of Horos and OsiriX.
#include "presets/importers.h"

#include <filesystem>
#include <fstream>

#include "presets/imported.h"

namespace macula::presets {
namespace {

std::string plist(const std::string& inside) {
    return R"(<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE plist PUBLIC "-//Apple Computer//DTD PLIST 1.0//EN" "http://www.apple.com/DTDs/PropertyList-1.0.dtd">
<plist version="1.0"><dict>)" +
           inside + "</dict></plist>\n";
}

std::string key(const std::string& name, const std::string& value) {
    return "<key>" + name + "</key>" + value;
}
std::string real(double value) {
    return "<real>" + std::to_string(value) + "</real>";
}
std::string point(double x, double y) {
    return "<dict>" + key("x", real(x)) + key("y", real(y)) + "</dict>";
}
std::string colour(double r, double g, double b) {
    return "<dict>" + key("red", real(r)) + key("green", real(g)) + key("blue", real(b)) + "</dict>";
}
std::string array(const std::string& items) {
    return "<array>" + items + "</array>";
}

const std::string kName = key("name", "<string>CT-Vessels</string>");

TEST(Horos, SixteenBitCurvesAreSquaredAndMerged) {
    const ImportedPreset preset = only(
        plist(kName + key("advancedCLUT", "<true/>") + key("useShading", "<true/>") +
              key("shading", "<string>Glossy Bone</string>") +
              key("16bitClutCurves", array(array(point(200, 0.0) + point(300, 0.5) + point(400, 0.0)) +
                                           array(point(-100, 0.0) + point(0, 1.0) + point(100, 0.0)))) +
              key("16bitClutColors", array(array(colour(1, 0, 0) + colour(1, 0.5, 0) + colour(1, 1, 1)) +
                                           array(colour(0, 0, 1) + colour(0, 0, 1) + colour(0, 0, 1))))));
    const TransferFunction& f = preset.function;
    EXPECT_EQ(f.title, "CT-Vessels");
    EXPECT_EQ(f.opacity,
              (std::vector<OpacityPoint>{{-100, 0}, {0, 1}, {100, 0}, {200, 0}, {300, 0.25}, {400, 0}}));
    EXPECT_EQ(colourAt(f, 300.0), glm::dvec3(1, 0.5, 0));
    EXPECT_EQ(f.lighting, (Lighting{true, 0.15, 0.24, 1.17, 6.98}));
    EXPECT_EQ(f.unit, Unit::hounsfield);
    EXPECT_TRUE(preset.notes.empty());
}

TEST(Horos, ASimplePresetIsATableOverItsWindow) {
    const std::string simple = kName + key("CLUT", "<string>No CLUT</string>") +
                               key("wl", "<integer>100</integer>") + key("ww", "<real>510</real>") +
                               key("convolutionFilters", array("<string>Basic Smooth 5x5</string>"));
    const ImportedPreset linear = only(plist(simple + key("opacity", "<string>Linear Table</string>")));
    EXPECT_NEAR(opacityAt(linear.function, 100.0), 0.5, 1e-12);
    EXPECT_EQ(opacityAt(linear.function, -155.0), 0.0);
    EXPECT_EQ(opacityAt(linear.function, 355.0), 1.0);
    EXPECT_NEAR(colourAt(linear.function, 100.0).g, 0.5, 1e-12);
    EXPECT_FALSE(linear.function.lighting.shade);
    EXPECT_EQ(linear.notes.size(), 1u) << "the filter is said to be left out";
    const ImportedPreset inverse =
        only(plist(simple + key("opacity", "<string>Logarithmic Inverse Table</string>")));
    EXPECT_NEAR(opacityAt(inverse.function, -155.0 + 510.0 * 128.0 / 255.0),
                1.0 - std::log10(1.0 + 9.0 * 127.0 / 255.0), 1e-12);
    expectRefused(plist(simple + key("opacity", "<string>Mine</string>")), "opacity table 'Mine'");
}

TEST(Horos, ColourTablesLieBesideThePreset) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / ("macula-horos-" + std::to_string(::getpid()));
    fs::create_directories(folder / "CLUTs");
    std::string reds;
    std::string zeros;
    for (int i = 0; i < 256; ++i) {
        reds += "<integer>" + std::to_string(i) + "</integer>";
        zeros += "<integer>0</integer>";
    }
    std::ofstream(folder / "CLUTs" / "Hot.plist")
        << plist(key("Red", array(reds)) + key("Green", array(zeros)) + key("Blue", array(zeros)));
    const auto preset = [&](const std::string& clut) {
        std::ofstream(folder / "a.plist") << plist(kName + key("CLUT", "<string>" + clut + "</string>") +
                                                   key("wl", real(0)) + key("ww", real(100)));
        return readPresetFile(folder / "a.plist");
    };
    const auto hot = preset("Hot");
    ASSERT_TRUE(hot.ok()) << hot.error().message;
    EXPECT_EQ(colourAt(hot->front().function, 50.0), glm::dvec3(1, 0, 0));
    EXPECT_NEAR(colourAt(hot->front().function, 0.0).r, 0.5, 1e-12);
    for (const std::string name : {"Cold", "../CLUTs/Hot", "/etc/passwd", "..", ""}) {
        const auto missing = preset(name);
        ASSERT_FALSE(missing.ok()) << name;
        EXPECT_NE(missing.error().hint.english().find("16-bit"), std::string::npos) << missing.error().hint;
    }
    fs::remove_all(folder);
}

TEST(Horos, RefusesWhatIsIncomplete) {
    expectRefused(plist(kName), "wl is missing");
    expectRefused(plist(kName + key("advancedCLUT", "<true/>")), "16bitClutCurves");
    expectRefused(plist("<key>name</key>"), "key without a value");
    expectRefused(plist("<string>value</string>"), "key without a value");
    expectRefused(plist(key("wl", "<real>NaN</real>")), "number that cannot be read");
    expectRefused(plist(key("wl", "<float>1</float>")), "<float>");
    expectRefused("<plist/>", "no property list");
    expectRefused("bplist00abc", "plutil");
    expectRefused(plist(kName + key("16bitClutCurves", array(array(point(0, 1)))) +
                        key("16bitClutColors", array(array("")))),
                  "16bitClutColors[0]");
    expectRefused(plist(kName + key("16bitClutCurves", array(array(point(0, 7)))) +
                        key("16bitClutColors", array(array(colour(1, 1, 1))))),
                  "from 0 to 1");
    expectRefused(plist(kName + key("wl", real(0)) + key("ww", real(0))), "ww");
}

}  // namespace
}  // namespace macula::presets
