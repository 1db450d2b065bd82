// Lens and fog of pictures that are saved.
#include "pictures/picture_effects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/phantom.h"
#include "gpu/gpu_test.h"
#include "pictures/drawn_picture.h"
#include "pictures/render_record.h"
#include "scene/choice/lights_choice.h"
#include "scene/choice/preset_choice.h"

namespace macula::pictures {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(Fog, FadesByWhatLiesBetween) {
    std::vector<glm::vec4> pixels(5, glm::vec4(0.8f, 0.4f, 0.2f, 1.0f));
    pixels[3] = glm::vec4(0.1f, 0.05f, 0.025f, 0.25f);
    pixels[4] = glm::vec4(0.0f);
    const std::vector<glm::vec4> before = pixels;
    addFog(pixels, std::vector<float>{200.0f, 250.0f, 400.0f, 250.0f, kInfinity}, 50.0);
    EXPECT_EQ(pixels[0], before[0]) << "the nearest is as it was";
    for (int k = 0; k < 4; ++k) {
        EXPECT_NEAR(pixels[1][k], before[1][k] / std::exp(1.0), 1e-6);
        EXPECT_NEAR(pixels[2][k], before[2][k] * std::exp(-4.0), 1e-6);
        EXPECT_NEAR(pixels[3][k], before[3][k] / std::exp(1.0), 1e-6) << "light and coverage alike";
    }
    EXPECT_EQ(pixels[4], glm::vec4(0.0f));
}

TEST(Fog, OfNothingAndAtTheExtremesIsFinite) {
    std::vector<glm::vec4> empty(2, glm::vec4(0.0f));
    addFog(empty, std::vector<float>{kInfinity, kInfinity}, 1.0);
    EXPECT_EQ(empty[0], glm::vec4(0.0f));
    for (const double fogMm : {kLeastFogMm, kMostFogMm}) {
        std::vector<glm::vec4> pixels(2, glm::vec4(1.0f));
        addFog(pixels, std::vector<float>{0.0f, 1e6f}, fogMm);
        EXPECT_EQ(pixels[0], glm::vec4(1.0f));
        EXPECT_NEAR(pixels[1].x, std::exp(-1e6 / fogMm), 1e-6);
    }
}

TEST(PictureEffects, WhatIsNoNumberOfThemIsRefused) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(check({}).ok());
    EXPECT_TRUE(check({.lensMm = 10.0, .focusMm = 300.0, .fogMm = 80.0}).ok());
    for (const PictureEffects& effects :
         {PictureEffects{.lensMm = -1.0}, PictureEffects{.lensMm = kNan}, PictureEffects{.lensMm = 1e5},
          PictureEffects{.focusMm = 0.0}, PictureEffects{.focusMm = -1.0}, PictureEffects{.focusMm = kNan},
          PictureEffects{.fogMm = -1.0}, PictureEffects{.fogMm = kNan}, PictureEffects{.fogMm = 1e7}}) {
        const auto checked = check(effects);
        ASSERT_FALSE(checked.ok());
        EXPECT_EQ(checked.error().code, ErrorCode::usage);
        EXPECT_FALSE(checked.error().hint.empty());
    }
    EXPECT_EQ(*parseFocus("auto"), std::nullopt);
    EXPECT_EQ(*parseFocus("312.5"), 312.5);
    for (const char* typed : {"", "near", "0", "-5", "nan", "inf", "1e9", "300mm", "300,5", " 300"})
        EXPECT_FALSE(parseFocus(typed).ok()) << typed;
}

TEST(PictureEffects, TheFocusIsWhereTheMiddleIs) {
    const glm::ivec2 size(80, 60);
    std::vector<trace::GuidePixel> guides(80 * 60);
    Camera camera{.positionMm = {0, -300, 0}, .targetMm = {0, 0, 0}, .verticalFovDeg = 90.0};
    const auto refused = focusOfMiddle(guides, size, camera);
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().hint.english().find("--focus-mm"), std::string::npos);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x)
            if (std::abs(x - 40) < 6 && std::abs(y - 30) < 6)
                guides[std::size_t(y * 80 + x)].depthMm = 250.0f;
    guides[30 * 80 + 40].depthMm = 3.0f;  // a speck does not decide
    // The rays are as long as the depth: along the axis it is a little less, by at most 3 pixels of 60.
    const double mm = *focusOfMiddle(guides, size, camera);
    EXPECT_LE(mm, 250.0);
    EXPECT_GE(mm, 250.0 / std::hypot(1.0, 2.0 * 3.0 / 60.0));
    camera.parallelHeightMm = 200.0;
    EXPECT_EQ(*focusOfMiddle(guides, size, camera), 250.0);
}

class EffectsOnDevice : public gpu::GpuTest {
  protected:
    static PictureRequest request(trace::Look look = trace::Look::cinematic) {
        PictureRequest asked{.scene = {.volume = std::make_shared<const Volume>(phantom::make(
                                           {.size = {48, 42, 30}, .spacingMm = {6.4, 6.4, 10.0}})),
                                       .function = scene::choosePreset("cinematic-bone")->function,
                                       .environment = *scene::chooseLights("studio")},
                             .sizePx = {64, 48},
                             .samplesPerPixel = 4};
        asked.settings.look = look;
        return asked;
    }
    DrawnPicture draw(const PictureRequest& asked) {
        Progress progress;
        return gpu::expectOk(drawPicture(device(), asked, progress));
    }
    static nlohmann::ordered_json recordOf(const PictureRequest& asked, const DrawnPicture& drawn) {
        RenderRecord record;
        record.add(asked, drawn);
        return toJson(record);
    }
};

TEST_F(EffectsOnDevice, FogIsThatOfTheDepthsOfThePicture) {
    for (const trace::Look look : {trace::Look::cinematic, trace::Look::dvr}) {
        PictureRequest asked = request(look);
        asked.isLinear = true;
        const DrawnPicture clear = draw(asked);
        asked.effects.fogMm = 60.0;
        const DrawnPicture foggy = draw(asked);
        const auto& depths = clear.traced->depthMm;
        const float nearest = *std::min_element(depths.begin(), depths.end());
        int faded = 0;
        for (std::size_t i = 0; i < depths.size(); ++i) {
            const glm::vec4& a = clear.traced->radiance[i];
            const glm::vec4& b = foggy.traced->radiance[i];
            if (a.w <= 0.0f || !std::isfinite(depths[i])) continue;
            const double share = std::exp(-double(depths[i] - nearest) / 60.0);
            // What is too thin for a depth may be nearer than all that has one.
            EXPECT_LE(b.w, a.w * share * 1.0001) << i;
            EXPECT_NEAR(b.x * double(a.w), a.x * double(b.w), 1e-4) << "the colour is the same";
            faded += b.w < 0.9f * a.w ? 1 : 0;
        }
        EXPECT_GT(faded, 100) << nameOf(look);
    }
}

TEST_F(EffectsOnDevice, WhatIsDisplayedIsTheSameOfAVeryDeepFog) {
    PictureRequest asked = request();
    asked.settings.exposure = 1.7;
    for (const trace::ToneMap map : trace::kToneMaps) {
        asked.settings.toneMap = map;
        asked.effects = {};
        const DrawnPicture clear = draw(asked);
        asked.effects.fogMm = kMostFogMm;
        const DrawnPicture foggy = draw(asked);
        int different = 0;
        for (std::size_t i = 0; i < clear.rgba.size(); ++i)
            different += std::abs(int(clear.rgba[i]) - int(foggy.rgba[i])) > 1 ? 1 : 0;
        EXPECT_EQ(different, 0) << nameOf(map);
    }
}

TEST_F(EffectsOnDevice, ALensIsFocusedOnTheMiddleUnlessItIsSaid) {
    PictureRequest asked = request();
    asked.isLinear = true;
    const DrawnPicture sharp = draw(asked);
    asked.effects.lensMm = 60.0;
    const DrawnPicture found = draw(asked);
    EXPECT_NE(found.traced->radiance, sharp.traced->radiance);
    // Within what the middle of the picture shows, of which one pixel may lie in front of the others.
    float nearest = kInfinity;
    float farthest = 0.0f;
    for (int y = 21; y < 27; ++y) {
        for (int x = 29; x < 35; ++x) {
            const float mm = sharp.traced->depthMm[std::size_t(y * 64 + x)];
            nearest = std::min(nearest, mm);
            farthest = std::isfinite(mm) ? std::max(farthest, mm) : farthest;
        }
    }
    EXPECT_GE(found.focusMm, nearest - 1.0);
    EXPECT_LE(found.focusMm, farthest + 1.0);
    EXPECT_EQ(recordOf(asked, found)["focusMm"], found.focusMm);
    EXPECT_EQ(recordOf(asked, found)["lensMm"], 60.0);
    asked.effects.focusMm = found.focusMm;
    EXPECT_EQ(draw(asked).traced->radiance, found.traced->radiance);
    asked.effects.focusMm = 0.5 * found.focusMm;
    EXPECT_NE(draw(asked).traced->radiance, found.traced->radiance);
}

TEST_F(EffectsOnDevice, LooksWithoutThemAreAsTheyWere) {
    for (const trace::Look look : {trace::Look::dvr, trace::Look::mip}) {
        PictureRequest asked = request(look);
        const DrawnPicture plain = draw(asked);
        asked.effects.lensMm = 60.0;
        if (look == trace::Look::mip) asked.effects.fogMm = 50.0;
        const DrawnPicture wanted = draw(asked);
        EXPECT_EQ(wanted.rgba, plain.rgba) << nameOf(look);
        const auto told = recordOf(asked, wanted);
        EXPECT_EQ(told["lensMm"], 0.0);
        EXPECT_TRUE(told["focusMm"].is_null());
        EXPECT_EQ(told["fogMm"], 0.0);
    }
}

TEST_F(EffectsOnDevice, ALensOnNothingSaysWhatToDo) {
    PictureRequest asked = request();
    asked.camera = Camera{.positionMm = {0.0, -2000.0, 0.0}, .targetMm = {0.0, -4000.0, 0.0}};
    asked.effects.lensMm = 5.0;
    Progress progress;
    const auto refused = drawPicture(device(), asked, progress);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::usage);
    EXPECT_NE(refused.error().hint.english().find("--focus-mm"), std::string::npos);
}

}  // namespace
}  // namespace macula::pictures
