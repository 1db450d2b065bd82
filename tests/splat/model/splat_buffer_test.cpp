// Models on the device, and the structs and places that C++ and GLSL share.
#include "pipeline/splat/model/splat_buffer.h"

#include <random>

#include "gpu/shared_device.h"
#include "gpu/shared_layout.h"
#include "pipeline/gpu/spirv_reflection.h"
#include "shaders/splat.h"
#include "shared/splat_adam_params.h"
#include "shared/splat_loss_params.h"

namespace macula::splat {
namespace {

using SplatsOnDevice = gpu::SharedDeviceTest;

Splats anySplats(std::size_t count, int shDegree) {
    Splats splats{.originMm = {1e5, -2.0, 3.0}, .colourSpace = ColourSpace::display};
    splats.resize(count);
    splats.setShDegree(shDegree);
    std::mt19937 random(5);
    std::normal_distribution<float> normal;
    const auto fill = [&](auto& values) {
        for (auto& value : values)
            for (int c = 0; c < value.length(); ++c) value[c] = normal(random);
    };
    fill(splats.position);
    fill(splats.logScale);
    fill(splats.rotation);
    for (float& opacity : splats.opacityLogit) opacity = normal(random);
    fill(splats.dc);
    fill(splats.sh);
    return splats;
}

TEST_F(SplatsOnDevice, ComeBackAsTheyWere) {
    for (int degree = 0; degree <= kMaxShDegree; ++degree) {
        const Splats splats = anySplats(37, degree);
        SplatBuffer buffer = std::move(*SplatBuffer::create(device(), "splats", 50, degree));
        ASSERT_TRUE(buffer.upload(componentsOf(splats)).ok());
        const Splats back = splatsOf(*buffer.download(37), splats);
        EXPECT_EQ(back.originMm, splats.originMm);
        EXPECT_EQ(back.colourSpace, splats.colourSpace);
        EXPECT_EQ(back.shDegree, degree);
        EXPECT_EQ(back.position, splats.position);
        EXPECT_EQ(back.logScale, splats.logScale);
        EXPECT_EQ(back.rotation, splats.rotation);
        EXPECT_EQ(back.opacityLogit, splats.opacityLogit);
        EXPECT_EQ(back.dc, splats.dc);
        EXPECT_EQ(back.sh, splats.sh);
        // Room that nothing fills is 0.
        const auto all = *buffer.download(50);
        for (std::size_t k = 0; k < std::size_t(buffer.components()); ++k)
            for (std::size_t i = 37; i < 50; ++i) ASSERT_EQ(all[k * 50 + i], 0.0f);
    }
}

TEST_F(SplatsOnDevice, LieWhereTheLayoutSays) {
    const Splats splats = anySplats(4, 1);
    SplatBuffer buffer = std::move(*SplatBuffer::create(device(), "splats", 6, 1));
    ASSERT_TRUE(buffer.upload(componentsOf(splats)).ok());
    const auto all = *buffer.download(6);
    const auto at = [&](int component) { return all[std::size_t(component) * 6 + 2]; };
    EXPECT_EQ(buffer.components(), 23);
    EXPECT_EQ(at(shared::kSplatPosition + 1), splats.position[2].y);
    EXPECT_EQ(at(shared::kSplatLogScale + 2), splats.logScale[2].z);
    EXPECT_EQ(at(shared::kSplatRotation), splats.rotation[2][0]);
    EXPECT_EQ(at(shared::kSplatOpacity), splats.opacityLogit[2]);
    EXPECT_EQ(at(shared::kSplatDc + 2), splats.dc[2].z);
    EXPECT_EQ(at(shared::kSplatSh + 3 * 1 + 2), splats.sh[2 * 3 + 1].z);  // blue of the second coefficient
}

TEST_F(SplatsOnDevice, WithoutAnySplatAreAModelToo) {
    const Splats none = anySplats(0, 1);
    SplatBuffer buffer = std::move(*SplatBuffer::create(device(), "splats", 1, 1));
    ASSERT_TRUE(buffer.upload(componentsOf(none)).ok());
    EXPECT_EQ(splatsOf(*buffer.download(0), none).size(), 0u);
}

TEST_F(SplatsOnDevice, BeyondTheDevicesLimitsAreRefused) {
    const auto result = SplatBuffer::create(device(), "splats", 4000000000u, 3);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::outOfMemory);
}

TEST(SplatLayout, ParametersAgreeInEveryKernel) {
    using shared::SplatAdamParams;
    using shared::SplatLossParams;
    using shared::SplatLossResult;
    for (const auto& code : {shaders::splat_loss_windows_comp, shaders::splat_loss_compare_comp,
                             shaders::splat_loss_columns_comp, shaders::splat_loss_rows_comp,
                             shaders::splat_loss_back_columns_comp, shaders::splat_loss_gradient_comp,
                             shaders::splat_loss_total_comp}) {
        const auto reflection = gpu::reflectSpirv(code.words);
        ASSERT_TRUE(reflection.ok());
        expectLayoutMatches<SplatLossParams>(
            *reflection->bindings.front().block.find("params"),
            {MACULA_FIELD(SplatLossParams, imageSize), MACULA_FIELD(SplatLossParams, background),
             MACULA_FIELD(SplatLossParams, exposure), MACULA_FIELD(SplatLossParams, l1Scale),
             MACULA_FIELD(SplatLossParams, dssimScale), MACULA_FIELD(SplatLossParams, squareScale),
             MACULA_FIELD(SplatLossParams, partCount), MACULA_FIELD(SplatLossParams, coverageOnly)});
    }
    const auto total = gpu::reflectSpirv(shaders::splat_loss_total_comp.words);
    expectLayoutMatches<SplatLossResult>(
        *total->bindings.back().block.find("result"),
        {MACULA_FIELD(SplatLossResult, loss), MACULA_FIELD(SplatLossResult, l1),
         MACULA_FIELD(SplatLossResult, dssim), MACULA_FIELD(SplatLossResult, badRendered)});
    const auto downsample = gpu::reflectSpirv(shaders::splat_downsample_comp.words);
    ASSERT_TRUE(downsample.ok());
    expectLayoutMatches<shared::SplatDownsamplePush>(*downsample->pushConstants->block.find("push"),
                                                     {MACULA_FIELD(shared::SplatDownsamplePush, fromSize),
                                                      MACULA_FIELD(shared::SplatDownsamplePush, toSize)});
    const auto adam = gpu::reflectSpirv(shaders::splat_adam_comp.words);
    ASSERT_TRUE(adam.ok());
    expectLayoutMatches<SplatAdamParams>(
        *adam->bindings.front().block.find("params"),
        {MACULA_FIELD(SplatAdamParams, count), MACULA_FIELD(SplatAdamParams, capacity),
         MACULA_FIELD(SplatAdamParams, components), MACULA_FIELD(SplatAdamParams, lastCorrection),
         MACULA_FIELD(SplatAdamParams, beta1), MACULA_FIELD(SplatAdamParams, beta2),
         MACULA_FIELD(SplatAdamParams, epsilon), MACULA_FIELD(SplatAdamParams, rates)});
}

}  // namespace
}  // namespace macula::splat
