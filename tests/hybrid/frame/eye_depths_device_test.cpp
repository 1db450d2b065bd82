// Depths of splats as a headset wants them: held to the same in double, and at the extremes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "gpu/shared_layout.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/hybrid/frame/eye_depths.h"
#include "shaders/hybrid.h"
#include "shared/eye_depth_params.h"
#include "trace/gpu_scene.h"

namespace macula::hybrid {
namespace {

class EyeDepthsTest : public trace::DeviceTest {
  protected:
    // Of pixels with that coverage, at these distances.
    static std::vector<float> depthsOf(EyeDepths& made, std::size_t eye, const glm::ivec2& sizePx,
                                       const std::vector<float>& coverages, const std::vector<float>& mm,
                                       const DepthRange& range) {
        std::vector<glm::vec4> pixels(coverages.size());
        std::vector<float> sums(coverages.size());
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            pixels[i].w = coverages[i];
            sums[i] = coverages[i] * mm[i];
        }
        const auto picture = splat::DevicePicture::upload(device(), "splats", sizePx.x, sizePx.y, pixels);
        auto buffer = gpu::Buffer::create(device(), {.bytes = sums.size() * sizeof(float)});
        EXPECT_TRUE(picture.ok() && buffer.ok());
        EXPECT_TRUE(gpu::uploadTo<float>(*buffer, sums).ok());
        const auto depths = made.make(eye, {&*picture, &*buffer}, range);
        EXPECT_TRUE(depths.ok());
        std::vector<float> read = gpu::read<float>(**depths).value();
        read.resize(pixels.size());  // the buffer may have room for more
        return read;
    }
};

TEST(EyeDepthLayout, PushConstantsAgree) {
    using shared::EyeDepthPush;
    const auto depth = gpu::reflectSpirv(shaders::hybrid_eye_depth_comp.words);
    ASSERT_TRUE(depth.ok());
    expectLayoutMatches<EyeDepthPush>(
        *depth->pushConstants->block.find("push"),
        {MACULA_FIELD(EyeDepthPush, size), MACULA_FIELD(EyeDepthPush, unitsPerMm),
         MACULA_FIELD(EyeDepthPush, nearest), MACULA_FIELD(EyeDepthPush, farthest)});
}

TEST_F(EyeDepthsTest, AreOfADepthBuffer) {
    auto made = EyeDepths::create(device());
    ASSERT_TRUE(made.ok());
    const glm::ivec2 sizePx(29, 13);
    const std::size_t count = 29 * 13;
    std::mt19937 random(3);
    std::uniform_real_distribution<float> exponent(0.0f, 6.0f);
    std::uniform_real_distribution<float> share(0.0f, 1.0f);
    std::vector<float> coverages(count);
    std::vector<float> mm(count);
    for (std::size_t i = 0; i < count; ++i) {
        coverages[i] = share(random);
        mm[i] = std::pow(10.0f, exponent(random));  // a millimetre to a kilometre
    }
    const DepthRange range{.nearest = 0.01f, .farthest = 100.0f, .unitsPerMm = 2e-3f};
    // Both eyes, and one that becomes smaller and larger again.
    for (const std::size_t eye : {0, 1, 0}) {
        const auto depths = depthsOf(*made, eye, sizePx, coverages, mm, range);
        for (std::size_t i = 0; i < count; ++i) {
            const double m = std::max(double(mm[i]) * 2e-3, 0.01);
            const double wanted = coverages[i] > 0.5f ? std::min(100.0 / 99.99 * (1.0 - 0.01 / m), 1.0) : 1.0;
            ASSERT_NEAR(depths[i], wanted, 1e-5) << i;
        }
        const auto few = depthsOf(*made, eye, {3, 2}, {1, 1, 1, 0, 0, 1}, {5, 5e7f, 0, 5, 5, 1000}, range);
        EXPECT_NEAR(few[0], 0.0f, 1e-6f) << "the near plane";
        EXPECT_EQ(few[1], 1.0f) << "behind the far one";
        EXPECT_NEAR(few[2], 0.0f, 1e-6f) << "before the near one";
        EXPECT_EQ(few[3], 1.0f) << "nothing";
        EXPECT_NEAR(few[5], 100.0 / 99.99 * (1.0 - 0.005), 1e-5);
    }
}

TEST_F(EyeDepthsTest, WhatIsNoNumberStaysBetweenThePlanes) {
    auto made = EyeDepths::create(device());
    ASSERT_TRUE(made.ok());
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinite = std::numeric_limits<float>::infinity();
    const auto depths =
        depthsOf(*made, 0, {4, 1}, {1.0f, 1.0f, nan, 1.0f}, {infinite, -infinite, 5.0f, -5.0f}, {});
    for (const float depth : depths) {
        EXPECT_GE(depth, 0.0f);
        EXPECT_LE(depth, 1.0f);
    }
    EXPECT_EQ(depths[2], 1.0f) << "a coverage that is no number covers nothing";
}

}  // namespace
}  // namespace macula::hybrid
