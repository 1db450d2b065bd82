// The kernels that run on the host of a CPU device, with each instruction set that this processor has, beside
// the shaders: both against the same maths in double.
#include <cmath>

#include "pipeline/trace/reference_tracer.h"
#include "trace/gpu_scene.h"
#include "trace/instruction_sets.h"
#include "trace/small_scenes.h"

namespace macula::trace {
namespace {

constexpr std::uint32_t kSamples = 4;

class NativeKernels : public DeviceTest {
  protected:
    void SetUp() override {
        if (!device()->runsNatively()) GTEST_SKIP() << "the device runs shaders";
    }

    static TracedImage pictureOn(const std::shared_ptr<gpu::Device>& on, const scenes::SmallScene& scene,
                                 const Settings& settings) {
        PathTracer t = tracerOn(on, scene.volume, scene.function, scene.environment(), scene.view, settings);
        EXPECT_TRUE(t.scene().setClip(scene.clip).ok());
        const auto traced = t.trace(kSamples);
        EXPECT_TRUE(traced.ok() && *traced);
        EXPECT_EQ(t.statistics()->nonFiniteSamples, 0u);
        EXPECT_EQ(t.statistics()->abandonedSamples, 0u);
        EXPECT_EQ(t.statistics()->collisionsAboveBound, 0u);
        return std::move(t.readback()).value();
    }

    static std::vector<glm::dvec4> truthOf(const scenes::SmallScene& scene, const Settings& settings) {
        const std::optional<MaskBits> mask =
            scene.clip.mask ? std::optional(maskBits(*scene.clip.mask, *scene.volume)) : std::nullopt;
        const Medium medium =
            makeMedium(*scene.volume, makeBrickGrid(*scene.volume, reachOf(settings.filter)), scene.function,
                       scene.clip, mask ? &*mask : nullptr);
        const auto params =
            makeTraceParams(*scene.volume, medium, scene.environment(), scene.view, settings, scene.clip);
        const ReferenceTracer reference(*scene.volume, medium, scene.environment(), mask ? &*mask : nullptr);
        return reference.trace(*params, settings.filter, Precision::twofold, 0, kSamples);
    }

    static std::vector<glm::dvec4> castTruthOf(const scenes::SmallScene& scene, const Settings& settings) {
        const std::optional<MaskBits> mask =
            scene.clip.mask ? std::optional(maskBits(*scene.clip.mask, *scene.volume)) : std::nullopt;
        const MaskBits* const bits = mask ? &*mask : nullptr;
        const BrickGrid grid = makeBrickGrid(*scene.volume);
        const auto projected = [&](Projection projection) {
            return makeMedium(*scene.volume, grid, projection, scene.clip, bits);
        };
        const Medium medium = settings.look == Look::mip     ? projected(Projection::maximum)
                              : settings.look == Look::minip ? projected(Projection::minimum)
                              : settings.look == Look::average
                                  ? projected(Projection::mean)
                                  : makeMedium(*scene.volume, grid, scene.function, scene.clip, bits);
        const ReferenceTracer::Cast what{.kind = settings.look == Look::mip       ? shared::kCastMaximum
                                                 : settings.look == Look::minip   ? shared::kCastMinimum
                                                 : settings.look == Look::average ? shared::kCastMean
                                                                                  : shared::kCastMatter,
                                         .shading = settings.shading == Shading::headlight,
                                         .filter = Filter::trilinear};
        const auto params =
            makeTraceParams(*scene.volume, medium, scene.environment(), scene.view, settings, scene.clip);
        return ReferenceTracer(*scene.volume, medium, scene.environment(), bits)
            .cast(*params, what, Precision::twofold, 0, kSamples);
    }

    // Cast rays are the same but for rounding, which may change the number of their steps.
    static void expectCast(const TracedImage& found, const std::vector<glm::dvec4>& sums) {
        int different = 0;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            const glm::dvec4 there = sums[i] / double(kSamples);
            if (glm::length(glm::dvec4(found.radiance[i]) - there) > 1e-3 * (glm::length(there) + 1e-2))
                ++different;
        }
        EXPECT_LE(different, int(sums.size()) / 64);
    }

    // Float sends a few paths another way than double.
    static void expectTruth(const TracedImage& found, const std::vector<glm::dvec4>& sums) {
        int different = 0;
        glm::dvec4 all(0.0);
        glm::dvec4 expected(0.0);
        for (std::size_t i = 0; i < sums.size(); ++i) {
            const glm::dvec4 here(found.radiance[i]);
            const glm::dvec4 there = sums[i] / double(kSamples);
            if (glm::length(here - there) > 1e-3 * (glm::length(there) + 1e-3)) ++different;
            all += here;
            expected += there;
        }
        EXPECT_LE(different, int(sums.size()) / 25);
        EXPECT_LE(glm::length(all - expected), 0.01 * glm::length(expected));
    }
};

TEST_F(NativeKernels, DrawTheSamplesOfTheReferenceWithEveryInstructionSet) {
    for (const scenes::SmallScene& scene : scenes::smallScenes()) {
        for (const Filter filter : {Filter::trilinear, Filter::stochastic, Filter::sharp}) {
            const Settings settings = scene.settings(Look::cinematic, filter, 11);
            SCOPED_TRACE(fmt::format("{}, {}", scene.name, nameOf(filter)));
            const std::vector<glm::dvec4> truth = truthOf(scene, settings);
            if (filter == Filter::trilinear) {
                SCOPED_TRACE("shader");
                expectTruth(pictureOn(deviceOfShaders(), scene, settings), truth);
            }
            onEachInstructionSet(true, [&] { expectTruth(pictureOn(device(), scene, settings), truth); });
        }
    }
}

TEST_F(NativeKernels, CastTheRaysOfTheReferenceWithEveryInstructionSet) {
    std::vector<scenes::SmallScene> all = scenes::smallScenes();
    scenes::SmallScene voxel = all.front();
    voxel.name = "a single voxel";
    voxel.volume = scenes::volumeOf({1, 1, 1}, scenes::grid(glm::dvec3(9.0), {1, 1, 1}),
                                    [](int, int, int) { return std::uint16_t(500); });
    all.push_back(voxel);
    for (scenes::SmallScene& scene : all) {
        if (scene.clip.box)
            scene.clip.greyFaces =
                DisplayWindow{.center = 300, .width = 600, .explanation = {}, .function = {}};
        for (const Look look : {Look::dvr, Look::mip, Look::minip, Look::average}) {
            for (const Shading shading : {Shading::none, Shading::headlight}) {
                if (look != Look::dvr && shading != Shading::none) continue;
                Settings settings = scene.settings(look, Filter::trilinear, 11);
                settings.shading = shading;
                settings.window =
                    DisplayWindow{.center = 400, .width = 1000, .explanation = {}, .function = {}};
                SCOPED_TRACE(fmt::format("{}, {} {}", scene.name, nameOf(look), int(shading)));
                const std::vector<glm::dvec4> truth = castTruthOf(scene, settings);
                onEachInstructionSet(true, [&] { expectCast(pictureOn(device(), scene, settings), truth); });
            }
        }
    }
}

}  // namespace
}  // namespace macula::trace
