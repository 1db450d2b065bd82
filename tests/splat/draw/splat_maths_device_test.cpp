// shaders/lib/splat_*.glsl gives the same on a device as in C++, whatever the splat: before any kernel is
// built on it.
#include <cmath>

#include "gpu/gpu_test.h"
#include "gpu/shared_layout.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/splat/draw/reference_host.h"
#include "shaders/test_splat.h"
#include "splat/draw/reference_scenes.h"
#include "splat/draw/splat_kinds.h"

namespace macula::splat {
namespace {

#define OUT(type) type&
#define INOUT(type) type&
struct Single : reference::HostSingle {
    using HostSingle::HostSingle;
#include "splat/splat_outcome.glsl"
};
struct Twofold : reference::HostTwofold {
    using HostTwofold::HostTwofold;
#define float double
#include "splat/splat_outcome.glsl"
#undef float
};
#undef OUT
#undef INOUT

using shared::SplatView;

class SplatDevice : public gpu::GpuTest {
  protected:
    std::vector<Single::Outcome> run(const std::vector<Single::Splat>& splats, const Blending& blending,
                                     const RasterView& raster = someView()) {
        using gpu::Buffer;
        const auto count = static_cast<std::uint32_t>(splats.size());
        const gpu::Kernel kernel = gpu::expectOk(gpu::Kernel::create(device(), shaders::splat_outcome_comp));
        const Buffer view =
            gpu::expectOk(Buffer::create(device(), {.label = "view", .bytes = sizeof(SplatView)}));
        const Buffer in = gpu::expectOk(
            Buffer::create(device(), {.label = "splats", .bytes = count * sizeof(Single::Splat)}));
        const Buffer out = gpu::expectOk(
            Buffer::create(device(), {.label = "outcomes", .bytes = count * sizeof(Single::Outcome)}));
        gpu::expectOk(gpu::uploadTo<SplatView>(view, std::vector{splatView(raster, blending)}));
        gpu::expectOk(gpu::uploadTo<Single::Splat>(in, splats));
        auto recorder = gpu::expectOk(gpu::Recorder::create(device(), "outcomes"));
        recorder.dispatch(kernel, {count}, count, {view, in, out});
        gpu::expectOk(recorder.submit());
        return gpu::expectOk(gpu::read<Single::Outcome>(out));
    }
};

class SplatDeviceOfViews : public SplatDevice, public testing::WithParamInterface<bool> {};
INSTANTIATE_TEST_SUITE_P(Rays, SplatDeviceOfViews, testing::Bool());

TEST_P(SplatDeviceOfViews, ComputesWhatCppComputes) {
    const RasterView view = GetParam() ? someParallelView() : someView();
    const std::vector<Single::Splat> splats = splatsOfAllKinds();
    for (const LowPass lowPass : kLowPasses) {
        const Blending blending = blendingOf(lowPass);
        const std::vector<Single::Outcome> outcomes = run(splats, blending, view);
        Twofold host(view, blending);
        std::size_t visible = 0;
        for (std::size_t i = 0; i < splats.size(); ++i) {
            SCOPED_TRACE(i);
            const Single::Splat& s = splats[i];
            const Single::Outcome& ours = outcomes[i];
            const Twofold::Outcome exact =
                host.outcomeOf({s.position, s.logScale, s.rotation, double(s.opacityLogit)}, host.frame);
            ASSERT_EQ(ours.screen.opacity > 0.0f, exact.screen.opacity > 0.0);
            EXPECT_LT(differenceOf(ours.colour, exact.colour), 1e-5);
            EXPECT_LT(differenceOf(ours.byBand.s2, exact.byBand.s2), 1e-4);
            if (!(exact.screen.opacity > 0.0)) {
                EXPECT_EQ(ours.transmittance, 0.8f);
                continue;
            }
            ++visible;
            EXPECT_LT(differenceOf(ours.screen.mean, exact.screen.mean), 1e-5);
            EXPECT_LT(differenceOf(ours.screen.conic.x, exact.screen.conic.x), 1e-4);
            // Beside the others it may be next to nothing.
            const double across = std::sqrt(exact.screen.conic.x * exact.screen.conic.z);
            EXPECT_LT(differenceOf(glm::vec1(ours.screen.conic.y), glm::dvec1(exact.screen.conic.y), across),
                      2e-4);
            EXPECT_LT(differenceOf(ours.screen.conic.z, exact.screen.conic.z), 1e-4);
            EXPECT_LT(differenceOf(ours.screen.opacity, exact.screen.opacity), 1e-4);
            EXPECT_LT(differenceOf(ours.screen.depthMm, exact.screen.depthMm), 1e-5);
            EXPECT_LT(differenceOf(ours.screen.extent, exact.screen.extent), 5e-5);
            EXPECT_LE(glm::length(glm::dvec2(ours.first - exact.first)), 1.0);
            EXPECT_LE(glm::length(glm::dvec2(ours.end - exact.end)), 1.0);
            EXPECT_TRUE(ours.shows == exact.shows || ours.first != exact.first || ours.end != exact.end);
            EXPECT_LT(glm::length(glm::dvec3(ours.blended) - exact.blended), 1e-4);
            EXPECT_NEAR(ours.transmittance, exact.transmittance, 1e-4);
            EXPECT_LT(differenceOf(ours.byScreen.colour, exact.byScreen.colour), 1e-3);
            EXPECT_LT(differenceOf(ours.byScreen.opacity, exact.byScreen.opacity), 1e-3);
            EXPECT_LT(differenceOf(ours.byScreen.conic, exact.byScreen.conic), 1e-3);
            EXPECT_LT(differenceOf(ours.bySplat.position, exact.bySplat.position), 1e-3);
            EXPECT_LT(differenceOf(ours.bySplat.logScale, exact.bySplat.logScale), 1e-3);
            // That of a sphere is 0.
            const double leastTurn = std::max(1e-5, 1e-3 * glm::length(exact.bySplat.logScale));
            // 3.1e-3 on an H100.
            EXPECT_LT(differenceOf(ours.bySplat.rotation, exact.bySplat.rotation, leastTurn), 5e-3);
            EXPECT_LT(differenceOf(ours.bySplat.opacityLogit, exact.bySplat.opacityLogit), 1e-3);
            EXPECT_LT(differenceOf(ours.byPositionOfColour, exact.byPositionOfColour), 1e-4);
        }
        EXPECT_GT(visible, 250u);
    }
}

// Beside the middle of the picture, and so far away that a card need not divide by the distance: it lies
// where it should, and so does its derivative, which is as large as the derivative by the depth is at 1e38
// mm.
TEST_F(SplatDevice, ProjectsWhatLies1e38MmAway) {
    std::vector<Single::Splat> splats;
    for (const float far : {1e20f, 1e29f, 1e31f, 8e37f, 1e38f}) {
        for (const glm::vec2 slope : {glm::vec2(0.03f, -0.02f), glm::vec2(-0.01f, 0.04f)}) {
            splats.push_back({{slope.x * far, far, slope.y * far}, {0.0f, 1.0f, 2.0f}, {1, 0, 0, 0}, 1.0f});
        }
    }
    const Blending blending = blendingOf(LowPass::classic);  // which lets no splat vanish
    const std::vector<Single::Outcome> outcomes = run(splats, blending);
    Twofold host(someView(), blending);
    for (std::size_t i = 0; i < splats.size(); ++i) {
        SCOPED_TRACE(i);
        const Single::Splat& s = splats[i];
        const Twofold::Outcome exact =
            host.outcomeOf({s.position, s.logScale, s.rotation, double(s.opacityLogit)}, host.frame);
        ASSERT_GT(exact.screen.opacity, 0.0);
        ASSERT_GT(outcomes[i].screen.opacity, 0.0f);
        EXPECT_LT(differenceOf(outcomes[i].screen.mean, exact.screen.mean), 1e-5);
        ASSERT_GT(glm::length(exact.bySplat.position), 1e-6);
        EXPECT_LT(differenceOf(outcomes[i].bySplat.position, exact.bySplat.position), 1e-2);
    }
}

TEST_F(SplatDevice, LeavesOutWhatIsNotFinite) {
    const std::vector<Single::Splat> splats = splatsNotFinite();
    for (const Single::Outcome& outcome : run(splats, {})) {
        EXPECT_EQ(outcome.screen.opacity, 0.0f);
        EXPECT_EQ(outcome.transmittance, 0.8f);
    }
}

TEST(SplatLayout, ViewIsLaidOutAlike) {
    const auto reflection = gpu::reflectSpirv(shaders::splat_outcome_comp.words);
    ASSERT_TRUE(reflection.ok());
    const gpu::ReflectedMember* view = reflection->bindings.front().block.find("view");
    ASSERT_NE(view, nullptr);
    expectLayoutMatches<SplatView>(
        *view, {MACULA_FIELD(SplatView, right), MACULA_FIELD(SplatView, down),
                MACULA_FIELD(SplatView, forward), MACULA_FIELD(SplatView, eyeMm),
                MACULA_FIELD(SplatView, focalPx), MACULA_FIELD(SplatView, principalPx),
                MACULA_FIELD(SplatView, sizePx), MACULA_FIELD(SplatView, lowestSlope),
                MACULA_FIELD(SplatView, highestSlope), MACULA_FIELD(SplatView, nearMm),
                MACULA_FIELD(SplatView, lowPassPx2), MACULA_FIELD(SplatView, lowPassLeastPx2),
                MACULA_FIELD(SplatView, compensated), MACULA_FIELD(SplatView, parallel),
                MACULA_FIELD(SplatView, maxAlpha), MACULA_FIELD(SplatView, minAlpha),
                MACULA_FIELD(SplatView, fringe), MACULA_FIELD(SplatView, minTransmittance)});
}

}  // namespace
}  // namespace macula::splat
