// The native kernel of projection is the same maths in double, whatever the splat.
#include "pipeline/splat/native/native_project.h"

#include <cmath>
#include <limits>

#include "splat/native/native_models.h"
#include "splat/native/native_pictures.h"

namespace macula::splat {
namespace {

// The texels that the kernel writes.
std::vector<glm::vec4> projected(NativeModel& model, const RasterView& view, const Blending& blending) {
    constexpr glm::vec4 kBehind(7.0f);
    std::vector<shared::SplatFrame> frame{model.frameOf(view, blending)};
    std::vector<glm::vec4> screen(model.count * shared::kScreenTexels + 1, kBehind);
    gpu::NativeDispatch dispatch({static_cast<std::uint32_t>(model.count + 63) / 64, 1, 1}, {});
    bindTo(dispatch, 0, frame);
    bindTo(dispatch, 1, screen);
    bindTo(dispatch, 2, model.parameters);
    nativeProject(model.degree)(dispatch);
    EXPECT_EQ(screen.back(), kBehind);
    return screen;
}

// With the tolerances of the device, see splat_maths_device_test.cpp. Returns how many show.
std::size_t expectLikeReference(const Splats& splats, const RasterView& view, const Blending& blending) {
    NativeModel model(splats);
    const std::vector<ProjectedSplat> exact =
        projectSplats(ReferenceSplats(splats), view, blending, Precision::twofold);
    std::size_t visible = 0;
    onEachInstructionSet([&] {
        const std::vector<glm::vec4> screen = projected(model, view, blending);
        visible = 0;
        for (std::size_t i = 0; i < splats.size(); ++i) {
            SCOPED_TRACE(i);
            const glm::vec4* t = &screen[i * shared::kScreenTexels];
            const ProjectedSplat& e = exact[i];
            ASSERT_EQ(t[1].y > 0.0f, e.opacity > 0.0);
            if (!(e.opacity > 0.0)) continue;
            ++visible;
            EXPECT_LT(differenceOf(glm::vec2(t[0]), e.mean), 1e-5);
            EXPECT_LT(differenceOf(t[0].z, e.conic.x), 1e-4);
            const double across = std::sqrt(e.conic.x * e.conic.z);
            EXPECT_LT(differenceOf(glm::vec1(t[0].w), glm::dvec1(e.conic.y), across), 2e-4);
            EXPECT_LT(differenceOf(t[1].x, e.conic.z), 1e-4);
            EXPECT_LT(differenceOf(t[1].y, e.opacity), 1e-4);
            EXPECT_LT(differenceOf(t[1].z, e.depthMm), 1e-5);
            EXPECT_LT(differenceOf(glm::vec2(t[1].w, t[2].w), e.extent), 5e-5);
            EXPECT_LT(differenceOf(glm::vec3(t[2]), e.colour, 0.1), 1e-5);
        }
    });
    return visible;
}

TEST(NativeProject, IsThatOfTheReferenceForSplatsOfAllKinds) {
    std::vector<SingleSplat> kinds = splatsOfAllKinds();
    for (const float far : {1e20f, 1e29f, 1e31f, 8e37f})
        kinds.push_back({{0.03f * far, far, -0.02f * far}, {0.0f, 1.0f, 2.0f}, {1, 0, 0, 0}, 1.0f});
    for (const bool isParallel : {false, true}) {
        for (const LowPass lowPass : kLowPasses) {
            const RasterView view = isParallel ? someParallelView() : someView();
            EXPECT_GT(expectLikeReference(modelOf(kinds, 1), view, blendingOf(lowPass)), 250u);
        }
    }
}

TEST(NativeProject, IsThatOfTheReferenceForAllDegreesAndCounts) {
    for (const int degree : {0, 1, 2, 3})
        for (const std::size_t count : {0, 1, 15, 16, 33, 1500})
            EXPECT_EQ(expectLikeReference(singleOf(randomModel(3, count, degree)), frontView(), {}) > 0,
                      count > 0);
}

TEST(NativeProject, LeavesOutWhatIsNotFinite) {
    std::vector<SingleSplat> kinds = splatsNotFinite();
    const std::size_t bad = kinds.size();
    kinds.push_back({{0, 0, 0}, {0, 1, 2}, {1, 0, 0, 0}, 1.0f});
    Splats splats = modelOf(kinds, 1);
    EXPECT_EQ(expectLikeReference(splats, someView(), {}), 1u);
    splats.sh[bad * shCount(1) + 2].y = std::numeric_limits<float>::infinity();
    EXPECT_EQ(expectLikeReference(splats, someView(), {}), 0u);
}

}  // namespace
}  // namespace macula::splat
