// Clips as people write them.
#include <gtest/gtest.h>

#include "base/phantom.h"
#include "pipeline/volume/clip_json.h"
#include "presets/embedded_files.h"
#include "trace/scenes.h"

namespace macula {
namespace {

const Volume& volume() {
    static const Volume made =
        *scenes::volumeOf({10, 20, 30}, affine({2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {-100, 50, 1000}),
                          [](int i, int, int) { return std::uint16_t(i * 10); });
    return made;
}

Clip builtIn(std::string_view name) {
    for (const auto& file : presets::clipFiles()) {
        if (file.name != name) continue;
        const auto preset = clipPresetFromJson(file.text, std::string(name));
        EXPECT_TRUE(preset) << preset.error().message;
        EXPECT_EQ(preset->name, name);
        return clipFor(*preset, volume());
    }
    ADD_FAILURE() << name;
    return {};
}

TEST(ClipJson, BuiltInOnesAreUsable) {
    ASSERT_GE(presets::clipFiles().size(), 10u);
    for (const auto& file : presets::clipFiles()) {
        const Clip clip = builtIn(file.name);
        EXPECT_TRUE(validate(clip)) << file.name;
        EXPECT_FALSE(clip.isNothing()) << file.name;
        EXPECT_EQ(file.text.find("\r"), std::string_view::npos);
    }
}

TEST(ClipJson, SidesAreThePatients) {
    const glm::dvec3 centre = volume().worldBox().centre();
    const auto keeps = [&](std::string_view name, const glm::dvec3& direction) {
        const Clip clip = builtIn(name);
        EXPECT_TRUE(shows(clip, centre + 0.5 * direction)) << name;
        EXPECT_FALSE(shows(clip, centre - 0.5 * direction)) << name;
    };
    keeps("left-half", {1, 0, 0});
    keeps("right-half", {-1, 0, 0});
    keeps("posterior-half", {0, 1, 0});
    keeps("anterior-half", {0, -1, 0});
    keeps("superior-half", {0, 0, 1});
    keeps("inferior-half", {0, 0, -1});
    const Clip corner = builtIn("corner-open");
    EXPECT_FALSE(shows(corner, centre + glm::dvec3(1, -1, 1)));
    EXPECT_TRUE(shows(corner, centre + glm::dvec3(-1, -1, 1)));
    EXPECT_TRUE(shows(corner, centre + glm::dvec3(1, 1, 1)));
    EXPECT_TRUE(shows(corner, centre + glm::dvec3(1, -1, -1)));
    // Without a window in the series its range of values is taken.
    ASSERT_TRUE(corner.greyFaces);
    EXPECT_EQ(corner.greyFaces->center, 45.0);
    EXPECT_EQ(corner.greyFaces->width, 90.0);
    EXPECT_FALSE(corner.facesBelowWindowAreBlack);
    EXPECT_TRUE(builtIn("corner-open-black").facesBelowWindowAreBlack);
    const Clip slab = builtIn("slab-axial");
    EXPECT_TRUE(shows(slab, centre));
    EXPECT_FALSE(shows(slab, centre + glm::dvec3(0, 0, 3.1)));
    EXPECT_TRUE(shows(slab, centre + glm::dvec3(0, 0, 2.9)));
    const Clip ball = builtIn("centre-ball");
    EXPECT_TRUE(shows(ball, centre + glm::dvec3(0, 7.9, 0)));
    EXPECT_FALSE(shows(ball, centre + glm::dvec3(0, 8.1, 0)));
}

TEST(ClipJson, ErrorsSayWhatWasExpected) {
    const auto says = [](const std::string& fields) {
        const auto read =
            clipPresetFromJson("{\"version\":1,\"name\":\"a\",\"title\":\"A\"" + fields + "}", "a.json");
        return read ? std::string() : read.error().message.english() + " " + read.error().hint.english();
    };
    EXPECT_EQ(says(""), "");
    EXPECT_NE(says(",\"plane\":[]").find("plane"), std::string::npos);
    EXPECT_NE(says(",\"planes\":[{\"normal\":[0,0,0],\"at\":[0,0,0]}]").find("direction"), std::string::npos);
    EXPECT_NE(says(",\"cut\":{\"at\":[0,0,0],\"towards\":\"SAL\"}").find("LAS"), std::string::npos);
    EXPECT_NE(says(",\"cut\":{\"at\":[0,0,0],\"towards\":\"L\"}").find("LAS"), std::string::npos);
    EXPECT_NE(says(",\"box\":{\"low\":[0,0,0],\"high\":[1,0,1],\"keep\":\"inside\"}").find("below"),
              std::string::npos);
    EXPECT_NE(says(",\"ball\":{\"centre\":[0,0,0],\"radius\":0,\"keep\":\"inside\"}"), "");
    EXPECT_NE(says(",\"ball\":{\"centre\":[0,0,0],\"radius\":1,\"keep\":\"all\"}").find("outside"),
              std::string::npos);
    EXPECT_NE(says(",\"greyFaces\":\"yes\"").find("series"), std::string::npos);
    EXPECT_NE(says(",\"greyFaces\":{\"center\":1,\"width\":-1}"), "");
    EXPECT_NE(says(",\"belowWindow\":\"black\"").find("greyFaces"), std::string::npos);
    EXPECT_NE(says(",\"greyFaces\":\"series\",\"belowWindow\":\"white\"").find("clear"), std::string::npos);
    EXPECT_NE(says(",\"planes\":[0,0,0,0,0,0,0]"), "");
    EXPECT_FALSE(clipPresetFromJson("", "a.json"));
    EXPECT_FALSE(clipPresetFromJson("[]", "a.json"));
    EXPECT_FALSE(clipPresetFromJson("{\"version\":2,\"name\":\"a\",\"title\":\"A\"}", "a.json"));
}

}  // namespace
}  // namespace macula
