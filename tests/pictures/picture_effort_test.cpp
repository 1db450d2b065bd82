#include "pictures/picture_effort.h"

#include <gtest/gtest.h>

#include "scene/choice/quality_choice.h"

namespace macula::pictures {
namespace {

Effort effort(const EffortRequest& request, trace::Look look = trace::Look::cinematic) {
    const auto of = effortOf(request, {.look = look});
    EXPECT_TRUE(of);
    return *of;
}

TEST(PictureEffort, WithoutARequestIsForTheLook) {
    EXPECT_EQ(effort({}).samplesPerPixel, 64u);
    EXPECT_EQ(effort({}, trace::Look::clear).samplesPerPixel, 64u);
    EXPECT_EQ(effort({}, trace::Look::dvr).samplesPerPixel, 8u);
    EXPECT_EQ(effort({}, trace::Look::mip).samplesPerPixel, 8u);
    EXPECT_EQ(effort({}).settings, trace::Settings{});
}

// What is given itself counts more than the quality.
TEST(PictureEffort, OfAQualityUnlessGiven) {
    const auto draft = scene::chooseQuality("draft");
    ASSERT_TRUE(draft);
    const Effort all = effort({.quality = "draft"});
    EXPECT_EQ(all.samplesPerPixel, draft->samplesPerPixel);
    EXPECT_EQ(all.settings.bounces, draft->bounces);
    EXPECT_EQ(all.settings.denoising, draft->denoising);
    const Effort given = effort({.quality = "draft", .samplesPerPixel = 7, .bounces = 2, .denoise = false});
    EXPECT_EQ(given.samplesPerPixel, 7u);
    EXPECT_EQ(given.settings.bounces, 2);
    EXPECT_EQ(given.settings.denoising, trace::Denoising::off);
    EXPECT_EQ(given.settings.filter, draft->filter);
    EXPECT_EQ(effortOf({.quality = "no-such"}, {}).error().code, ErrorCode::usage);
}

TEST(PictureEffort, OfAnErrorHasNearlyNoEnd) {
    EXPECT_EQ(effort({.error = 0.01}).settings.errorThreshold, 0.01);
    EXPECT_EQ(effort({.quality = "draft", .error = 0.01}).samplesPerPixel, kMostSamplesPerPixel);
    EXPECT_EQ(effort({.samplesPerPixel = 5, .error = 0.01}).samplesPerPixel, 5u);
}

}  // namespace
}  // namespace macula::pictures
