// Files that are cut, or made to harm: an error or a preset that can be checked, never a crash.
#include <random>

#include "pipeline/volume/transfer_function_json.h"
#include "presets/imported.h"

namespace macula::presets {
namespace {

// One good file of each format.
const std::vector<std::pair<std::string, std::string>>& goodFiles() {
    static const std::vector<std::pair<std::string, std::string>> files{
        {"a.xml",
         R"(<?xml version="1.0"?><MRML><VolumeProperty name="CT-a" scalarOpacity="4 0 0 10 1" colorTransfer="8 0 1 1 1 9 0 0 0"
            gradientOpacity="4 0 1 255 1" shade="1" ambient="0.1" interpolation="1" effectiveRange="0 10"/></MRML>)"},
        {"a.vp", "1\n1\n0.9\n0.1\n0.2\n10\n4 0 0 10 1\n4 0 1 255 1\n8 0 1 0 0 10 0 0 1\n"},
        {"a.vp.json",
         R"({"macula": {"version": 1, "name": "a", "title": "A", "modality": ["CT"], "unit": "raw", "fitToVolume": true},
            "volumeProperties": [{"effectiveRange": [0, 10], "components": [{"scalarOpacity": {"points": [{"x": 0, "y": 0,
            "midpoint": 0.5, "sharpness": 0.5}, {"x": 10, "y": 1}]}, "gradientOpacity": {"points": [{"x": 0, "y": 1}]},
            "rgbTransferFunction": {"points": [{"x": 0, "color": [1, 0.5, 0]}]}}]}]})"},
        {"b.json",
         R"([{"Name": "CT-a", "ColorSpace": "Lab", "RGBPoints": [0, 0, 0, 0, 1, 1, 1, 1], "Points": [0, 0, 0.5, 0, 1, 1, 0.5, 0]}])"},
        {"b.xml",
         R"(<Version TransferfunctionVersion="1"/><TransferFunction><ScalarOpacity><point x="0" y="1"/></ScalarOpacity>
            <GradientOpacity><point x="0" y="1"/></GradientOpacity><Color><point x="0" r="1" g="1" b="1" midpoint="0.5" sharpness="0"/></Color></TransferFunction>)"},
        {"c.plist",
         R"(<!DOCTYPE plist PUBLIC "-//Apple//DTD PLIST 1.0//EN" "http://example.org/a.dtd"><plist version="1.0"><dict>
            <key>name</key><string>CT-a</string><key>16bitClutCurves</key><array><array><dict><key>x</key><real>0</real><key>y</key><real>1</real></dict></array></array>
            <key>16bitClutColors</key><array><array><dict><key>red</key><real>1</real><key>green</key><real>1</real><key>blue</key><real>1</real></dict></array></array></dict></plist>)"}};
    return files;
}

// What comes out can be checked, evaluated and written.
void expectHarmless(std::string_view text, const std::string& name) {
    const auto read = readText(text, name);
    if (!read.ok()) {
        EXPECT_FALSE(read.error().message.empty());
        EXPECT_FALSE(read.error().hint.empty()) << read.error().message;
        return;
    }
    for (const ImportedPreset& preset : *read) {
        ASSERT_TRUE(validate(preset.function).ok()) << name;
        for (const double x : {-1e9, 0.0, 0.3, 5.0, 1e9}) {
            const double opacity = opacityAt(preset.function, x);
            EXPECT_TRUE(opacity >= 0.0 && opacity <= 1.0) << text;
            const glm::dvec3 colour = colourAt(preset.function, x);
            EXPECT_TRUE(colour.r >= 0.0 && colour.r <= 1.0);
        }
        EXPECT_TRUE(transferFunctionFromJson(toJson(preset.function), "written").ok());
    }
}

TEST(Hostile, TheGoodFilesAreGood) {
    for (const auto& [name, text] : goodFiles()) {
        const auto read = readText(text, name);
        EXPECT_TRUE(read.ok()) << name << ": "
                               << (read.ok()
                                       ? ""
                                       : read.error().message.english() + " " + read.error().hint.english());
        expectHarmless(text, name);
    }
}

TEST(Hostile, CutAnywhere) {
    for (const auto& [name, text] : goodFiles()) {
        for (std::size_t length = 0; length < text.size(); ++length)
            expectHarmless(text.substr(0, length), name);
    }
}

TEST(Hostile, BytesChangedAnywhere) {
    std::mt19937 random(7);
    const std::string odd = std::string("<>&\"'{}[],:;-+eE.0919 \n\t\x80\xFF", 27) + '\0';
    for (const auto& [name, text] : goodFiles()) {
        for (int run = 0; run < 1500; ++run) {
            std::string changed = text;
            for (int i = 1 + static_cast<int>(random() % 4); i > 0; --i)
                changed[random() % changed.size()] = odd[random() % odd.size()];
            expectHarmless(changed, name);
        }
    }
}

TEST(Hostile, DeepNesting) {
    for (const std::size_t depth : {std::size_t{100}, std::size_t{200'000}}) {
        std::string open;
        std::string close;
        for (std::size_t i = 0; i < depth; ++i) {
            open += "<array>";
            close += "</array>";
        }
        expectRefused("<plist>" + open + close + "</plist>", "nested");
        expectRefused("<plist>" + open, "");
        expectRefused(std::string(depth, '[') + std::string(depth, ']'), "nested");
        expectRefused(std::string(depth, '['), "nested");
        std::string objects;
        for (std::size_t i = 0; i < depth; ++i) objects += R"({"a":)";
        expectRefused(objects + "1" + std::string(depth, '}'), "nested", "a.json");
        expectRefused(
            R"({"volumeProperties": [], "x": )" + std::string(depth, '[') + std::string(depth, ']') + "}",
            "nested");
    }
    // A quote in a comment hides nothing.
    expectRefused("// \"\n" + std::string(200, '['), "nested");
    expectRefused("/* \" */" + std::string(200, '['), "nested");
    EXPECT_EQ(only("// " + std::string(200, '[') + "\n" + goodFiles()[3].second).function.name, "ct-a");
    // Brackets in texts are no nesting.
    expectRefused(R"({"a": ")" + std::string(1000, '[') + R"(\"[["})", "volumeProperties");
}

// Numbers that fit their own format, but could not be read again from ours.
TEST(Hostile, RangesThatAreTooLarge) {
    const ImportedPreset slicer = only(
        R"(<MRML><VolumeProperty name="CT-a" scalarOpacity="4 0 0 10 1" colorTransfer="8 0 1 1 1 9 0 0 0"
            effectiveRange="0 1e23"/></MRML>)");
    EXPECT_FALSE(slicer.function.effectiveRange);
    EXPECT_EQ(slicer.notes.size(), 1u) << "it is said to be left out";
    EXPECT_TRUE(transferFunctionFromJson(toJson(slicer.function), "written").ok());
    const auto windowed = [](const std::string& level, const std::string& width) {
        return "<plist version=\"1.0\"><dict><key>name</key><string>CT-a</string><key>CLUT</key><string>No "
               "CLUT</string><key>wl</key><real>" +
               level + "</real><key>ww</key><real>" + width + "</real></dict></plist>";
    };
    expectRefused(windowed("1e9", "10"), "within");
    expectRefused(windowed("-9e8", "5e8"), "within");
    const ImportedPreset widest = only(windowed("5e8", "1e9"));
    EXPECT_TRUE(transferFunctionFromJson(toJson(widest.function), "written").ok());
}

// A megabyte of keys that mean nothing took minutes to be read and written.
TEST(Hostile, ObjectsOfManyKeys) {
    const auto withKeys = [](int count) {
        std::string text = R"({"volumeProperties": "x")";
        for (int i = 1; i < count; ++i) text += ",\"k" + std::to_string(i) + "\": 0";
        return text + "}";
    };
    expectRefused(withKeys(1001), "too many keys");
    expectRefused(withKeys(1000), "volumeProperties");
    // Each object counts for itself, and texts count for nothing.
    std::string list = R"({"a": ")" + std::string(2000, ':') + R"(", "b": [)";
    for (int i = 0; i < 2000; ++i) list += R"({"c": 0},)";
    expectRefused(list + "{}]}", "volumeProperties");
}

TEST(Hostile, EntitiesAreNotExpanded) {
    std::string bomb = "<?xml version=\"1.0\"?><!DOCTYPE plist [<!ENTITY a \"aaaaaaaaaa\">";
    for (char c = 'b'; c <= 'z'; ++c) {
        bomb += std::string("<!ENTITY ") + c + " \"";
        for (int i = 0; i < 10; ++i) bomb += std::string("&") + static_cast<char>(c - 1) + ";";
        bomb += "\">";
    }
    expectRefused(bomb + "]><plist><dict><key>name</key><string>&z;</string></dict></plist>", "entities");
    expectRefused(
        R"(<!DOCTYPE MRML [<!ENTITY x SYSTEM "file:///etc/passwd">]><MRML><VolumeProperty name="&x;"/></MRML>)",
        "entities");
    std::string wide;
    for (const char c : std::string(R"(<!DOCTYPE a [<!ENTITY x "y">]><MRML/>)")) wide += std::string{c, '\0'};
    expectRefused("\xFF\xFE" + wide, "entities");
}

TEST(Hostile, ManyOfEverything) {
    std::string points = "10000";
    for (int i = 0; i < 5000; ++i) points += " " + std::to_string(i) + " 0";
    expectRefused("<MRML><VolumeProperty scalarOpacity=\"" + points + "\"/></MRML>", "too many");
    std::string presets = "<MRML>";
    for (int i = 0; i < 2000; ++i)
        presets += R"(<VolumeProperty name="CT-a" scalarOpacity="2 0 0" colorTransfer="4 0 1 1 1"/>)";
    expectRefused(presets + "</MRML>", "too many presets");
    std::string list;
    for (int i = 0; i < 5000; ++i) list += R"({"x": 0, "y": 0},)";
    expectRefused(R"({"volumeProperties": [{"components": [{"scalarOpacity": {"points": [)" + list +
                      R"({"x": 0, "y": 0}]}, "rgbTransferFunction": {"points": []}}]}]})",
                  "1 to 4096");
}

TEST(Hostile, WhatIsNoXmlIsSaidWithItsLine) {
    expectRefused("<MRML>\n<VolumeProperty name=\"a\n", "line");
    expectRefused("<MRML>\n\n</WRONG>", "line 3");
    expectRefused("<!-- only a comment -->", "no XML element");
    expectRefused("<html><body>Not found</body></html>", "no volume property");
}

}  // namespace
}  // namespace macula::presets
