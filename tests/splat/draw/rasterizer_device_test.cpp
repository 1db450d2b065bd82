// The rasterizer on the device against the reference: pictures, depths and derivatives.
#include <cmath>
#include <utility>

#include "base/worst.h"
#include "gpu/shared_device.h"
#include "gpu/shared_layout.h"
#include "pipeline/gpu/spirv_reflection.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/splat/draw/rasterizer.h"
#include "pipeline/splat/draw/reference_rasterizer.h"
#include "shaders/splat.h"
#include "splat/draw/reference_scenes.h"

namespace macula::splat {
namespace {

class RasterizerOnDevice : public gpu::SharedDeviceTest {
  protected:
    struct Drawn {
        SplatBuffer parameters;
        Rasterizer rasterizer;
        RasterPass pass;
    };
    static Drawn draw(const Splats& splats, const RasterView& view, const Blending& blending,
                      const RasterShape& shape = {}) {
        const auto count = static_cast<std::uint32_t>(splats.size());
        SplatBuffer parameters =
            std::move(*SplatBuffer::create(device(), "parameters", std::max(count, 1u), splats.shDegree));
        EXPECT_TRUE(parameters.upload(componentsOf(splats)).ok());
        Rasterizer rasterizer =
            std::move(*Rasterizer::create(device(), std::max(count, 1u), splats.shDegree, shape));
        const RasterPass pass = *rasterizer.draw(parameters, count, view, blending);
        return {std::move(parameters), std::move(rasterizer), pass};
    }
};

double worstOf(const std::vector<glm::vec4>& device, const RasterImage& reference) {
    double worst = 0.0;
    for (std::size_t i = 0; i < device.size(); ++i) {
        const glm::dvec4 off = glm::abs(glm::dvec4(device[i]) - reference.rgba[i]);
        for (int k = 0; k < 4; ++k) worst = test::worse(worst, off[k]);
    }
    return worst;
}

TEST_F(RasterizerOnDevice, PicturesAreThoseOfTheReference) {
    for (const auto& shape : {RasterShape{}, RasterShape{16, 16}, RasterShape{8, 2}}) {
        for (const int degree : {0, 1, 2, 3}) {
            const Splats splats = singleOf(randomModel(17 + std::uint32_t(degree), 300, degree));
            const bool isParallel = shape.tileRows == 16;  // else rays of an eye
            const RasterView view =
                isParallel ? parallelFrontView({61, 47}, 123.0) : frontView({61, 47}, 14.0);
            const Drawn drawn = draw(splats, view, {}, shape);
            const RasterImage expected = rasterize(ReferenceSplats(splats), view, {}, Precision::twofold);
            const auto pixels = drawn.rasterizer.picture().read();
            ASSERT_TRUE(pixels.ok());
            EXPECT_LT(worstOf(*pixels, expected), 1e-4) << degree;
            const auto depths = gpu::read<float>(drawn.rasterizer.depths());
            ASSERT_TRUE(depths.ok());
            for (std::size_t i = 0; i < depths->size(); ++i)
                EXPECT_NEAR(double((*depths)[i]), expected.depth[i], 1e-4 * 500.0);
        }
    }
}

TEST_F(RasterizerOnDevice, DerivativesAreThoseOfTheReference) {
    for (const auto& [shape, isParallel] :
         {std::pair(RasterShape{}, false), std::pair(RasterShape{8, 4}, false),
          std::pair(RasterShape{}, true)}) {
        for (const int degree : {0, 1}) {
            const Splats splats = singleOf(randomModel(5 + std::uint32_t(degree), 200, degree));
            const RasterView view =
                isParallel ? parallelFrontView({61, 47}, 123.0) : frontView({61, 47}, 14.0);
            Drawn drawn = draw(splats, view, {}, shape);
            const std::size_t pixels = 61 * 47;
            Dice dice(3);
            RasterGradient gradient{.rgba = std::vector<glm::dvec4>(pixels),
                                    .depth = std::vector<double>(pixels)};
            std::vector<glm::vec4> single(pixels);
            for (std::size_t i = 0; i < pixels; ++i) {
                single[i] = glm::vec4(dice.vec3(-1, 1), dice.uniform(-1, 1));
                gradient.rgba[i] = single[i];
            }
            const auto uploaded = DevicePicture::upload(device(), "gradient", 61, 47, single);
            ASSERT_TRUE(uploaded.ok());
            SplatBuffer gradients =
                std::move(*SplatBuffer::create(device(), "gradients", drawn.parameters.capacity(), degree));
            auto recorder = std::move(*gpu::Recorder::create(device(), "test"));
            ASSERT_TRUE(
                drawn.rasterizer.recordBackward(recorder, drawn.pass, drawn.parameters, *uploaded, gradients)
                    .ok());
            ASSERT_TRUE(recorder.submit().ok());
            const auto found = gradients.download(drawn.parameters.capacity());
            ASSERT_TRUE(found.ok());

            const ReferenceSplats model(splats);
            const RasterImage image = rasterize(model, view, {}, Precision::twofold);
            const ReferenceSplats expected =
                rasterizeBackward(model, view, {}, image, gradient, Precision::twofold);
            const std::vector<float> reference = componentsOf(singleOf(expected));
            ASSERT_EQ(found->size(), reference.size());
            for (int k = 0; k < componentCount(degree); ++k) {
                const auto first = reference.begin() + std::ptrdiff_t(k) * std::ptrdiff_t(splats.size());
                double most = 0.0;
                for (std::size_t i = 0; i < splats.size(); ++i)
                    most = std::max(most, std::abs(double(first[std::ptrdiff_t(i)])));
                // Each relative to itself; what all but cancels over hundreds of pixels, to the rounding of
                // their sum.
                for (std::size_t i = 0; i < splats.size(); ++i) {
                    const double right = first[std::ptrdiff_t(i)];
                    EXPECT_NEAR((*found)[std::size_t(k) * splats.size() + i], right,
                                1e-3 * std::abs(right) + 1e-5 * most)
                        << "component " << k;
                }
            }
        }
    }
}

TEST_F(RasterizerOnDevice, NothingToDrawIsAnEmptyPicture) {
    const RasterView view = frontView({20, 9}, 14.0);
    for (const std::size_t count : {0u, 1u}) {
        Splats splats = singleOf(emptyModel(count));
        for (glm::vec3& p : splats.position) p.y = -1000.0f;  // behind the eye
        const Drawn drawn = draw(splats, view, {});
        const auto pixels = drawn.rasterizer.picture().read();
        ASSERT_TRUE(pixels.ok());
        for (const glm::vec4& pixel : *pixels) EXPECT_EQ(pixel, glm::vec4(0.0f));
        EXPECT_EQ(drawn.pass.pairCount(), 0u);
    }
}

TEST_F(RasterizerOnDevice, ASplatThatDoesNotShowKeepsWhatWasThere) {
    Splats splats = singleOf(randomModel(8, 4, 0));
    splats.position[2] = {0.0f, -1000.0f, 0.0f};
    const RasterView view = frontView({20, 9}, 14.0);
    Drawn drawn = draw(splats, view, {});
    SplatBuffer gradients = std::move(*SplatBuffer::create(device(), "gradients", 4, 0));
    const std::vector<float> before(std::size_t(4 * gradients.components()), 7.0f);
    ASSERT_TRUE(gradients.upload(before).ok());
    const auto gradient =
        DevicePicture::upload(device(), "gradient", 20, 9, std::vector<glm::vec4>(180, glm::vec4(0.5f)));
    for (int turn = 0; turn < 2; ++turn) {
        auto recorder = std::move(*gpu::Recorder::create(device(), "test"));
        ASSERT_TRUE(
            drawn.rasterizer.recordBackward(recorder, drawn.pass, drawn.parameters, *gradient, gradients)
                .ok());
        ASSERT_TRUE(recorder.submit().ok());
    }
    const auto visible = gpu::read<std::uint32_t>(drawn.rasterizer.visible());
    ASSERT_TRUE(visible.ok());
    EXPECT_EQ(*visible, (std::vector<std::uint32_t>{1, 1, 0, 1}));
    const auto after = gradients.download(4);
    ASSERT_TRUE(after.ok());
    for (int k = 0; k < gradients.components(); ++k) {
        EXPECT_EQ((*after)[std::size_t(4 * k + 2)], 7.0f);
        EXPECT_NE((*after)[std::size_t(4 * k)], 7.0f);
    }
    const auto statistics = gpu::read<shared::SplatStatistics>(drawn.rasterizer.statistics());
    ASSERT_TRUE(statistics.ok());
    EXPECT_EQ((*statistics)[0].views, 2.0f);
    EXPECT_FLOAT_EQ((*statistics)[0].weight, 2.0f * (*statistics)[0].mostWeight);
    EXPECT_EQ((*statistics)[2].views, 0.0f);
}

// Pixels that pull a splat to opposite sides do not cancel in what is known about it.
TEST_F(RasterizerOnDevice, PullsAddUp) {
    Splats splats = singleOf(randomModel(8, 1, 0));
    splats.position[0] = {0.0f, 0.0f, 0.0f};
    const RasterView view = frontView({32, 32}, 14.0);
    const auto pullOf = [&](const auto& takesPart) {
        Drawn drawn = draw(splats, view, {});
        SplatBuffer gradients = std::move(*SplatBuffer::create(device(), "gradients", 1, 0));
        std::vector<glm::vec4> pixels;
        for (int i = 0; i < 32 * 32; ++i)
            pixels.push_back(takesPart(i % 32 < 16, i / 32 < 16) ? glm::vec4(0, 0, 0, 1) : glm::vec4(0));
        const auto gradient = DevicePicture::upload(device(), "gradient", 32, 32, pixels);
        auto recorder = std::move(*gpu::Recorder::create(device(), "test"));
        EXPECT_TRUE(
            drawn.rasterizer.recordBackward(recorder, drawn.pass, drawn.parameters, *gradient, gradients)
                .ok());
        EXPECT_TRUE(recorder.submit().ok());
        return double(gpu::read<shared::SplatStatistics>(drawn.rasterizer.statistics())->front().pull);
    };
    const double whole = pullOf([](bool, bool) { return true; });
    double quarters = 0.0;
    for (const bool left : {false, true}) {
        for (const bool top : {false, true}) {
            quarters += pullOf([=](bool isLeft, bool isTop) { return isLeft == left && isTop == top; });
        }
    }
    EXPECT_GT(whole, 0.01);
    EXPECT_NEAR(quarters, whole, 1e-4 * whole);
}

TEST(RasterizerLayout, IsThatOfTheKernels) {
    using shared::SplatFrame, shared::SplatView, shared::SplatStatistics;
    // All that read the frame, those of the lists made on the device included.
    for (const auto& code :
         {shaders::splat_project_comp, shaders::splat_raster_comp, shaders::splat_raster_back_comp,
          shaders::splat_gather_comp, shaders::splat_tile_keys_comp, shaders::splat_tile_count_comp,
          shaders::splat_tile_starts_comp, shaders::splat_tile_emit_comp, shaders::splat_tile_ranges_comp}) {
        const auto reflection = gpu::reflectSpirv(code.words);
        ASSERT_TRUE(reflection.ok());
        const auto* frame = reflection->bindings.front().block.find("frame");
        ASSERT_NE(frame, nullptr) << code.name;
        expectLayoutMatches<SplatFrame>(*frame,
                                        {MACULA_FIELD(SplatFrame, view), MACULA_FIELD(SplatFrame, count),
                                         MACULA_FIELD(SplatFrame, capacity), MACULA_FIELD(SplatFrame, tiles),
                                         MACULA_FIELD(SplatFrame, tileRows)});
    }
    const auto gather = gpu::reflectSpirv(shaders::splat_gather_comp.words);
    expectLayoutMatches<SplatStatistics>(
        *gather->bindings.back().block.find("statistics"),
        {MACULA_FIELD(SplatStatistics, views), MACULA_FIELD(SplatStatistics, weight),
         MACULA_FIELD(SplatStatistics, pull), MACULA_FIELD(SplatStatistics, mostWeight)});
}

}  // namespace
}  // namespace macula::splat
