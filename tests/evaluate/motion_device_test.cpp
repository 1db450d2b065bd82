// Frames after the eye has moved, of the phantom, small.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "evaluate/benchmark_reports.h"
#include "evaluate/motion.h"
#include "gpu/shared_device.h"
#include "scene/choice/lights_choice.h"

namespace macula::evaluate {
namespace {

constexpr int kSidePx = 48;

class MotionOnDevice : public gpu::SharedDeviceTest {};

TEST_F(MotionOnDevice, ABorderIsToldOfWhatHasAFovea) {
    Progress progress;
    BenchStudy study =
        std::move(
            openBenchStudy({.preset = "cinematic-bone", .lights = scene::kDefaultLights, .size = kSidePx},
                           progress))
            .value();
    study.device = device();
    MotionOptions options{
        .sizePx = glm::ivec2(kSidePx), .stepsMm = {5.0}, .turnsDeg = {2.0}, .truthSamples = 4};
    options.model = {.points = {.count = 300},
                     .views = 4,
                     .samplesPerPixel = 1,
                     .directions = 6,
                     .sizePx = kSidePx,
                     .iterations = 20,
                     .capacity = 330};
    const auto measured = measureMotion(study, options, progress);
    ASSERT_TRUE(measured) << measured.error().message;
    ASSERT_EQ(measured->frames.size(), 6u);  // three viewpoints, a step and a turn
    const auto report = reportOf(study, options, *measured);
    ASSERT_EQ(report["frames"].size(), 6u);
    for (const auto& frame : report["frames"]) {
        EXPECT_FALSE(frame["splats"].contains("seam"));
        for (const char* way : {"reprojected", "pasted"}) {
            ASSERT_TRUE(frame[way].contains("seam")) << frame;
            EXPECT_GT(frame[way]["seam"]["ratio"].get<double>(), 0.0);
        }
        EXPECT_FALSE(frame["splats"].contains("mixed"));
        EXPECT_EQ(frame["splats"]["darkerPx"], 0) << "no darker than itself";
        for (const char* way : {"reprojected", "pasted"}) {
            EXPECT_GT(frame[way]["mixed"]["meanRatio"].get<double>(), 0.0);
            EXPECT_LT(frame[way]["darkerPx"].get<int>(), kSidePx * kSidePx / 10);
        }
        for (const char* way : {"reprojected", "pasted", "splats"}) {
            EXPECT_GT(frame[way]["flip"].get<double>(), 0.0);
            EXPECT_LE(frame[way]["flip"].get<double>(), 1.0);
        }
    }
}

}  // namespace
}  // namespace macula::evaluate
