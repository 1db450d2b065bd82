// The fovea's size for the time that there is.
#include "pipeline/hybrid/frame/fovea_size.h"

#include <gtest/gtest.h>

#include <cmath>

namespace macula::hybrid {
namespace {

const trace::View kWhole{.camera = {}, .width = 1280, .height = 720};  // 30 degrees

double msOf(const FoveaAim& aim, double msPerSample) {
    return double(aim.sidePx) * double(aim.sidePx) * double(aim.samplesPerPixel) * msPerSample;
}

double pixelsPerTangent(const FoveaAim& aim) {
    return 0.5 * aim.sidePx / std::tan(0.5 * glm::radians(aim.fieldDeg));
}

TEST(FoveaSize, WithEnoughTimeItIsWhatIsWanted) {
    const FoveaAim aim = affordableFovea(kWhole, {0.25, -0.5}, 1e-9);
    EXPECT_NEAR(aim.fieldDeg, trace::kFovealFieldDeg, 1e-9);
    EXPECT_EQ(aim.sidePx, std::lround(720.0 * std::tan(glm::radians(10.0)) / std::tan(glm::radians(15.0))));
    EXPECT_EQ(aim.gaze, glm::dvec2(0.25, -0.5));
}

TEST(FoveaSize, WithLessItShrinksFirstAndIsCoarserThen) {
    const double fine = pixelsPerTangent(affordableFovea(kWhole, {}, 1e-9));
    double field = 21.0;
    double fineness = 1.01 * fine;
    for (double msPerSample = 1e-6; msPerSample < 1e3; msPerSample *= 1.3) {
        const FoveaAim aim = affordableFovea(kWhole, {}, msPerSample);
        EXPECT_LE(aim.fieldDeg, field + 1e-9);
        EXPECT_LE(pixelsPerTangent(aim), 1.05 * fineness);  // but for whole pixels
        if (aim.fieldDeg > 12.5) {
            EXPECT_NEAR(pixelsPerTangent(aim), fine, 0.02 * fine);
        }
        if (aim.fieldDeg > 2.1) {
            EXPECT_LE(msOf(aim, msPerSample), 1.05 * kFoveaBudgetMs);
        }
        EXPECT_GT(aim.fieldDeg, 1.9);
        field = aim.fieldDeg;
        fineness = pixelsPerTangent(aim);
    }
}

TEST(FoveaSize, IsAsRequested) {
    const FoveaOptions request{.fieldDeg = 10.0, .samplesPerPixel = 16, .denoising = trace::Denoising::off};
    const FoveaAim all = affordableFovea(kWhole, {}, 1e-9, kFoveaBudgetMs, request);
    EXPECT_NEAR(all.fieldDeg, 10.0, 1e-9);
    EXPECT_EQ(all.samplesPerPixel, 16u);
    EXPECT_EQ(all.denoising, trace::Denoising::off);
    EXPECT_NEAR(pixelsPerTangent(all), pixelsPerTangent(affordableFovea(kWhole, {}, 1e-9)),
                0.02 * pixelsPerTangent(all));
    // All of its samples have to fit into the time.
    for (const double budgetMs : {50.0, 250.0, 2000.0}) {
        const FoveaAim some = affordableFovea(kWhole, {}, 1e-3, budgetMs, request);
        EXPECT_LE(msOf(some, 1e-3), 1.05 * budgetMs);
    }
}

TEST(FoveaSize, HoldsAtTheExtremes) {
    trace::View narrow = kWhole;
    narrow.camera.verticalFovDeg = 0.1;
    const FoveaAim all = affordableFovea(narrow, {}, 1e-9);
    EXPECT_LT(all.fieldDeg, 0.2);
    EXPECT_GE(affordableFovea(narrow, {}, 1e3).fieldDeg, 0.1);
    EXPECT_LE(all.sidePx, 1280);
    for (const auto& [width, height] : {std::pair{1, 1}, std::pair{1, 4096}, std::pair{4096, 1}}) {
        const FoveaAim aim = affordableFovea({.camera = {}, .width = width, .height = height}, {}, 1e-9);
        EXPECT_GE(aim.sidePx, 1);
        EXPECT_LE(aim.sidePx, 4096);
        EXPECT_GT(aim.fieldDeg, 0.0);
        EXPECT_LT(aim.fieldDeg, 170.0);
    }
    for (const double ms : {1e-300, 1e300}) {
        const FoveaAim aim = affordableFovea(kWhole, {}, ms);
        EXPECT_GE(aim.sidePx, 1);
        EXPECT_TRUE(std::isfinite(aim.fieldDeg));
    }
}

}  // namespace
}  // namespace macula::hybrid
