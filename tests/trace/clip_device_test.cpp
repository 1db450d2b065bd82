// The device clips as the reference does.
#include <algorithm>

#include "base/phantom.h"
#include "pipeline/trace/reference_tracer.h"
#include "pipeline/volume/transfer_function_json.h"
#include "presets/embedded_files.h"
#include "trace/clips.h"
#include "trace/gpu_scene.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

using ClipOnDevice = DeviceTest;

// The same random numbers, in float: the same paths, but for a few that rounding sends another way.
TEST_F(ClipOnDevice, DrawsTheSamplesOfTheReference) {
    const auto volume =
        std::make_shared<const Volume>(phantom::make({.size = {96, 80, 64}, .spacingMm = {3.2, 3.2, 4.7}}));
    TransferFunction bone;
    for (const auto& file : presets::transferFiles()) {
        if (file.name == "ct-bone") bone = *transferFunctionFromJson(file.text, std::string(file.name));
    }
    const Environment sky = Environment::constant(glm::vec3(0.8f, 0.9f, 1.0f));
    constexpr int kSize = 32;
    constexpr std::uint32_t kSamples = 8;
    const View view{.camera = frameBox(volume->worldBox(), ViewDirection::left, 30, 1.0),
                    .width = kSize,
                    .height = kSize};
    const Settings settings{.bounces = 3, .seed = 9, .filter = Filter::trilinear, .exposure = 1.4};
    PathTracer t = tracer(volume, bone, sky, view, settings);
    scenes::Chance chance(21);
    Box middle = volume->worldBox();
    for (int trial = 0; trial < 6; ++trial) {
        Clip clip = scenes::anyClip(chance, middle);
        if (trial == 0) clip = {.cut = Octant{.pointMm = middle.centre(), .towards = {1, -1, 1}}};
        clip.removedCastsShadow = trial % 2 == 1;
        if (trial % 3 == 0)
            clip.greyFaces = DisplayWindow{.center = 40, .width = 400, .explanation = {}, .function = {}};
        ASSERT_TRUE(t.scene().setClip(clip).ok());
        ASSERT_TRUE(*t.trace(kSamples));
        const auto image = t.readback();
        ASSERT_TRUE(image.ok()) << image.error().message;
        const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), bone, clip);
        const auto params = makeTraceParams(*volume, medium, sky, view, settings, clip);
        const auto sums = ReferenceTracer(*volume, medium, sky)
                              .trace(*params, settings.filter, Precision::single, 0, kSamples);
        int different = 0;
        glm::dvec4 bias(0.0);
        for (std::size_t i = 0; i < sums.size(); ++i) {
            const glm::dvec4 d = glm::dvec4(image->radiance[i]) - sums[i] / double(kSamples);
            bias += d / double(sums.size());
            different += glm::length(d) > 1e-3 ? 1 : 0;
        }
        EXPECT_LT(different, int(sums.size()) / 20) << "clip " << trial;
        EXPECT_LT(glm::length(bias), 4e-3) << "clip " << trial;
    }
    // And without a clip all of it is there again.
    ASSERT_TRUE(t.scene().setClip({}).ok());
    ASSERT_TRUE(*t.trace(kSamples));
    PathTracer fresh = tracer(volume, bone, sky, view, settings);
    ASSERT_TRUE(*fresh.trace(kSamples));
    EXPECT_EQ(t.readback()->radiance, fresh.readback()->radiance);
}

// Grey goes through exposure and tone map and comes out as the window says, to one step of eight bits.
TEST_F(ClipOnDevice, FacesAreExactlyGrey) {
    const auto volume =
        scenes::volumeOf({32, 32, 32}, affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-15.5, -15.5, -15.5}),
                         [](int i, int, int) { return std::uint16_t(100 + i); });
    TransferFunction unseen = scenes::homogeneous(2.0);
    unseen.opacity = {{1000, 0.0}, {1001, 1.0}};
    const View view{.camera = {.positionMm = {0, -3000, 0}, .targetMm = {0, 0, 0}, .verticalFovDeg = 0.5},
                    .width = 26,
                    .height = 26};
    Settings settings{.bounces = 1, .exposure = 2.5};
    PathTracer t = tracer(volume, unseen, Environment::constant(glm::vec3(1.0f)), view, settings);
    Clip clip{.planes = {{{0, 1, 0}, 3.0}}};
    clip.greyFaces = DisplayWindow{.center = 115, .width = 40, .explanation = {}, .function = "LINEAR_EXACT"};
    ASSERT_TRUE(t.scene().setClip(clip).ok());
    for (const ToneMap map : kToneMaps) {
        settings.toneMap = map;
        ASSERT_TRUE(t.setSettings(settings).ok());
        ASSERT_TRUE(*t.trace(16));
        const auto shown = t.readDisplay(glm::vec3(0.0f));
        ASSERT_TRUE(shown.ok());
        for (int x = 0; x < 26; ++x) {
            const double mm = (x + 0.5 - 13.0) * 2.0 * 3003.0 * std::tan(glm::radians(0.25)) / 26.0;
            const int grey = (*shown)[std::size_t(4 * (13 * 26 + x))];
            EXPECT_NEAR(grey, 255.0 * (115.5 + mm - 95.0) / 40.0, 1.5) << nameOf(map) << x;
            EXPECT_EQ(grey, (*shown)[std::size_t(4 * (13 * 26 + x) + 2)]);
        }
    }
}

// A ball of a label map, kept or hidden: on the device as in the reference, and as large as it should be.
TEST_F(ClipOnDevice, MasksAsTheReferenceDoes) {
    const glm::ivec3 size(40, 36, 32);
    const glm::dmat4 grid = affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1.2}, {-19.5, -17.5, -18.6});
    const auto volume = scenes::volumeOf(size, grid, [](int, int, int) { return std::uint16_t(1); });
    std::vector<std::uint16_t> labels;
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i)
                labels.push_back(glm::length(transformPoint(grid, {i, j, k})) < 12.0 ? 7 : 2);
        }
    }
    const auto map = std::make_shared<const LabelMap>(
        std::move(
            LabelMap::create(size, grid, {{.number = 2, .label = "a"}, {.number = 7, .label = "b"}}, labels))
            .value());
    const Environment sky = Environment::constant(glm::vec3(0.8f, 0.9f, 1.0f));
    constexpr int kSize = 32;
    constexpr std::uint32_t kSamples = 8;
    const View view{.camera = {.positionMm = {0, -2000, 0}, .targetMm = {0, 0, 0}, .verticalFovDeg = 1.2},
                    .width = kSize,
                    .height = kSize};
    const TransferFunction opaque = scenes::homogeneous(50.0);
    for (const Filter filter : kFilters) {
        const Settings settings{.bounces = 2, .seed = 9, .filter = filter};
        PathTracer t = tracer(volume, opaque, sky, view, settings);
        for (const bool casts : {false, true}) {
            Clip clip{.mask = Mask{map, {7}, Keep::inside}};
            clip.removedCastsShadow = casts;
            ASSERT_TRUE(t.scene().setClip(clip).ok());
            ASSERT_TRUE(*t.trace(kSamples));
            const auto image = t.readback();
            ASSERT_TRUE(image.ok()) << image.error().message;
            const MaskBits bits = maskBits(*clip.mask, *volume);
            const Medium medium =
                makeMedium(*volume, makeBrickGrid(*volume, reachOf(filter)), opaque, clip, &bits);
            const auto params = makeTraceParams(*volume, medium, sky, view, settings, clip);
            const auto sums = ReferenceTracer(*volume, medium, sky, &bits)
                                  .trace(*params, filter, Precision::single, 0, kSamples);
            int different = 0;
            double coverage = 0.0;
            double light = 0.0;
            for (std::size_t i = 0; i < sums.size(); ++i) {
                different +=
                    glm::length(glm::dvec4(image->radiance[i]) - sums[i] / double(kSamples)) > 1e-3 ? 1 : 0;
                coverage += double(image->radiance[i].a) / double(sums.size());
                light += double(image->radiance[i].g) / double(sums.size());
            }
            EXPECT_LT(different, int(sums.size()) / 20);
            const double side = 2.0 * 2000.0 * std::tan(glm::radians(0.6));
            EXPECT_NEAR(coverage * side * side, 3.14159265 * 12.0 * 12.0, 15.0);
            // All around it is opaque: the ball is seen, and no light comes to it.
            if (casts) {
                EXPECT_LT(light, 0.01);
            } else {
                EXPECT_GT(light, 0.05);
            }
        }
    }
}

}  // namespace
}  // namespace macula::trace
