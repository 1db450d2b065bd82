// The looks on the device: against the reference, and every preset against a dense march that shares
// with it only voxels, curves and clip.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numeric>

#include "base/parallel.h"
#include "base/phantom.h"
#include "pipeline/trace/reference_tracer.h"
#include "presets/catalogue.h"
#include "trace/clips.h"
#include "trace/dense_cast.h"
#include "trace/gpu_scene.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

using CastOnDevice = DeviceTest;

const Environment kSky = Environment::constant(glm::vec3(1.0f));

std::shared_ptr<const Volume> smallPhantom() {
    static const auto volume =
        std::make_shared<const Volume>(phantom::make({.size = {80, 70, 50}, .spacingMm = {3.84, 3.84, 6.0}}));
    return volume;
}

View oblique(const Volume& volume, int pixels) {
    const Box box = volume.worldBox();
    return {.camera = {.positionMm = box.centre() + glm::dvec3(0.5, -1.6, 0.4) * box.diagonal(),
                       .targetMm = box.centre(),
                       .up = {0, 0, 1},
                       .verticalFovDeg = 32},
            .width = pixels,
            .height = pixels};
}

TransferFunction builtIn(const std::string& name) {
    const auto all = presets::builtInPresets();
    for (const TransferFunction& preset : *all) {
        if (preset.name == name) return preset;
    }
    ADD_FAILURE() << name;
    return {};
}

std::vector<glm::dvec4> truthOf(const Volume& volume, const TransferFunction& function, const View& view,
                                int perSide = 1) {
    std::vector<glm::dvec4> truth(std::size_t(view.width) * std::size_t(view.height));
    parallelFor(truth.size(), [&](std::size_t i) {
        const int x = static_cast<int>(i) % view.width;
        const int y = static_cast<int>(i) / view.width;
        for (int s = 0; s < perSide * perSide; ++s) {
            const glm::dvec2 at =
                glm::dvec2(x, y) + (glm::dvec2(s % perSide, s / perSide) + 0.5) / double(perSide);
            truth[i] += scenes::denseCast(volume, function, {}, view.camera.positionMm,
                                          scenes::eyeRay(view, at.x, at.y), perSide == 1 ? 160 : 20)
                            .matter /
                        double(perSide * perSide);
        }
    });
    return truth;
}

// The phantom; for curves that are over other numbers than Hounsfield units, its values spread over where
// they change.
std::shared_ptr<const Volume> phantomFor(const TransferFunction& function) {
    if (function.unit == Unit::hounsfield || function.fitToVolume) return smallPhantom();
    const double low = function.opacity.front().value;
    const double high = function.opacity.back().value;
    const Volume& plain = *smallPhantom();
    const StoredRange stored = plain.storedRange();
    const double slope = (high - low) / double(stored.high - stored.low);
    auto made = Volume::create({.size = plain.size(),
                                .worldFromVoxel = plain.worldFromVoxel(),
                                .unitsFromStored = {.slope = slope, .intercept = low - slope * stored.low},
                                .unit = Unit::raw,
                                .modality = "OT",
                                .padding = {},
                                .provenance = {}},
                               {plain.voxels().begin(), plain.voxels().end()});
    return std::make_shared<const Volume>(std::move(made).value());
}

class EveryPresetCast : public DeviceTest, public ::testing::WithParamInterface<std::string> {};

TEST_P(EveryPresetCast, IsWithinOnePercentOfADenseMarch) {
    const TransferFunction function = builtIn(GetParam());
    const auto volume = phantomFor(function);
    const View view = oblique(*volume, 24);
    PathTracer t = tracer(volume, function, kSky, view, {.look = Look::dvr});
    ASSERT_TRUE(*t.trace(1));
    const auto image = t.readback();
    ASSERT_TRUE(image.ok());
    const auto truth = truthOf(*volume, fitted(function, *volume), view);
    double error = 0.0;
    double coverageError = 0.0;
    int covered = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        if (truth[i].a < 0.002 && image->radiance[i].a < 0.002f) continue;  // all else would only dilute
        const glm::dvec4 difference = glm::abs(glm::dvec4(image->radiance[i]) - truth[i]);
        error += (difference.r + difference.g + difference.b) / 3.0;
        coverageError += difference.a;
        ++covered;
    }
    const double mean = covered > 0 ? error / covered : 0.0;
    const double meanCoverage = covered > 0 ? coverageError / covered : 0.0;
    std::printf("  %-30s %4d pixels  colour %.5f  coverage %.5f\n", GetParam().c_str(), covered, mean,
                meanCoverage);
    EXPECT_GT(covered, 20);
    EXPECT_LT(mean, 0.01);
    EXPECT_LT(meanCoverage, 0.01);
}

// Every fourth, of each source some; with MACULA_EVERY_PRESET in the environment all.
std::vector<std::string> presetNames() {
    std::vector<std::string> names;
    const auto all = presets::builtInPresets();
    const std::size_t stride = std::getenv("MACULA_EVERY_PRESET") == nullptr ? 4 : 1;
    for (std::size_t i = 0; i < all->size(); i += stride) names.push_back((*all)[i].name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Presets, EveryPresetCast, ::testing::ValuesIn(presetNames()), [](const auto& p) {
    std::string name = p.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

// How much of its light paths meet matter is 1 - transmittance, also with gradient opacity.
TEST_F(CastOnDevice, PathsCoverWhatADenseMarchSays) {
    const View view = oblique(*smallPhantom(), 8);
    constexpr std::uint32_t kSamples = 1024;
    for (const char* name : {"ct-bone", "ct-cardiac3", "mr-default", "uct-skull"}) {
        const TransferFunction function = builtIn(name);
        const auto volume = phantomFor(function);
        const auto truth = truthOf(*volume, fitted(function, *volume), view, 6);
        for (const Look look : {Look::cinematic, Look::clear}) {
            PathTracer t = tracer(volume, function, kSky, view, {.bounces = 1, .look = look});
            ASSERT_TRUE(*t.trace(kSamples));
            const auto image = t.readback();
            ASSERT_TRUE(image.ok());
            double bias = 0.0;
            double error = 0.0;
            for (std::size_t i = 0; i < truth.size(); ++i) {
                bias += (double(image->radiance[i].a) - truth[i].a) / double(truth.size());
                error += std::abs(double(image->radiance[i].a) - truth[i].a) / double(truth.size());
            }
            EXPECT_NEAR(bias, 0.0, 0.005) << name;
            EXPECT_LT(error, 0.015) << name;
        }
    }
}

// The same steps in float: the same picture, with clips, grey faces and shading.
TEST_F(CastOnDevice, DrawsWhatTheReferenceDraws) {
    const auto volume = smallPhantom();
    const TransferFunction function = builtIn("ct-cardiac3");
    const View view = oblique(*volume, 32);
    scenes::Chance chance(31);
    for (int trial = 0; trial < 5; ++trial) {
        Clip clip = trial == 0 ? Clip{} : scenes::anyClip(chance, volume->worldBox());
        if (trial == 2)
            clip.greyFaces = DisplayWindow{.center = 40, .width = 400, .explanation = {}, .function = {}};
        for (const LookTraits& look : kLooks) {
            if (isPathTraced(look.look)) continue;
            Settings settings{.exposure = 1.3, .look = look.look};
            settings.window = DisplayWindow{.center = 0, .width = 2000, .explanation = {}, .function = {}};
            if (trial % 2 == 1) settings.shading = Shading::headlight;
            if (trial % 3 == 1) settings.filter = trial % 2 == 1 ? Filter::smooth : Filter::sharp;
            PathTracer t = tracer(volume, function, kSky, view, settings);
            ASSERT_TRUE(t.scene().setClip(clip).ok());
            ASSERT_TRUE(*t.trace(3));
            const auto image = t.readback();
            ASSERT_TRUE(image.ok()) << image.error().message;
            const Filter filter = filterOf(look.look, settings.filter);
            const BrickGrid grid = makeBrickGrid(*volume, reachOf(filter));
            const Medium medium =
                look.look == Look::dvr     ? makeMedium(*volume, grid, function, clip)
                : look.look == Look::mip   ? makeMedium(*volume, grid, Projection::maximum, clip)
                : look.look == Look::minip ? makeMedium(*volume, grid, Projection::minimum, clip)
                                           : makeMedium(*volume, grid, Projection::mean, clip);
            const ReferenceTracer::Cast what{.kind = look.look == Look::dvr     ? shared::kCastMatter
                                                     : look.look == Look::mip   ? shared::kCastMaximum
                                                     : look.look == Look::minip ? shared::kCastMinimum
                                                                                : shared::kCastMean,
                                             .shading = trial % 2 == 1 && look.look == Look::dvr,
                                             .filter = filter};
            const auto params = makeTraceParams(*volume, medium, kSky, view, settings, clip);
            ASSERT_TRUE(params.ok());
            const auto sums =
                ReferenceTracer(*volume, medium, kSky).cast(*params, what, Precision::twofold, 0, 3);
            int different = 0;
            for (std::size_t i = 0; i < sums.size(); ++i)
                different += glm::length(glm::dvec4(image->radiance[i]) - sums[i] / 3.0) > 3e-3 ? 1 : 0;
            EXPECT_LE(different, int(sums.size()) / 100) << look.name << " clip " << trial;
        }
    }
}

// A picture does not depend on how it was cut into calls, and can be interrupted.
TEST_F(CastOnDevice, IsTheSameHoweverItIsCut) {
    const auto volume = smallPhantom();
    const View view = oblique(*volume, 96);
    const Settings settings{.look = Look::dvr};
    PathTracer whole = tracer(volume, builtIn("ct-bone"), kSky, view, settings);
    ASSERT_TRUE(*whole.trace(6));
    PathTracer parts = tracer(volume, builtIn("ct-bone"), kSky, view, settings);
    bool interrupted = false;
    while (!*parts.trace(2, [&] { return std::exchange(interrupted, true); })) {
    }
    ASSERT_TRUE(*parts.trace(1));
    while (parts.statistics()->samplesPerPixel < 6) ASSERT_TRUE(*parts.trace(1));
    EXPECT_EQ(parts.readback()->radiance, whole.readback()->radiance);
}

// Greys are those of the window, to one step of eight bits, whatever exposure and tone map; and looks can be
// changed at any time.
TEST_F(CastOnDevice, ProjectionsAreExactlyGrey) {
    const auto volume =
        scenes::volumeOf({32, 32, 32}, affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-15.5, -15.5, -15.5}),
                         [](int i, int j, int) { return std::uint16_t(100 + i + (j == 9 ? 40 : 0)); });
    const View view{.camera = {.positionMm = {0, -3000, 0}, .targetMm = {0, 0, 0}, .verticalFovDeg = 0.5},
                    .width = 26,
                    .height = 26};
    Settings settings{.exposure = 2.5};
    settings.window =
        DisplayWindow{.center = 135, .width = 100, .explanation = {}, .function = "LINEAR_EXACT"};
    PathTracer t = tracer(volume, scenes::homogeneous(1.0), kSky, view, settings);
    ASSERT_TRUE(*t.trace(1));
    const auto before = t.readback();
    constexpr std::array<std::pair<Look, ToneMap>, 5> kShown{{{Look::mip, ToneMap::neutral},
                                                              {Look::mip, ToneMap::hue},
                                                              {Look::minip, ToneMap::hue},
                                                              {Look::average, ToneMap::neutral},
                                                              {Look::average, ToneMap::hue}}};
    for (const auto& [look, map] : kShown) {
        settings.look = look;
        settings.toneMap = map;
        ASSERT_TRUE(t.setSettings(settings).ok());
        ASSERT_TRUE(*t.trace(1));
        const auto shown = t.readDisplay(glm::vec3(0.0f));
        ASSERT_TRUE(shown.ok());
        for (int x = 0; x < 26; ++x) {
            const double mm = (x + 0.5 - 13.0) * 2.0 * 3000.0 * std::tan(glm::radians(0.25)) / 26.0;
            const double value = 115.5 + mm +
                                 (look == Look::mip       ? 40.0
                                  : look == Look::average ? 40.0 / 32.0
                                                          : 0.0);
            EXPECT_NEAR((*shown)[std::size_t(4 * (13 * 26 + x))], 255.0 * (value - 85.0) / 100.0, 1.6)
                << nameOf(look) << " " << nameOf(map) << " " << x;
        }
        EXPECT_EQ(t.readback()->depthMm[13 * 26 + 13], std::numeric_limits<float>::infinity());
    }
    settings.look = Look::cinematic;
    settings.toneMap = ToneMap::neutral;
    ASSERT_TRUE(t.setSettings(settings).ok());
    ASSERT_TRUE(*t.trace(1));
    EXPECT_EQ(t.readback()->radiance, before->radiance);
}

// A white wall lit by one lamp: which side of the picture is lit tells where it hangs.
TEST_F(CastOnDevice, LightsTurnAndGrow) {
    const auto volume = scenes::volumeOf(
        {24, 24, 24}, affine({4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {-46, -46, -46}), [](int i, int j, int k) {
            return std::uint16_t(glm::length(glm::dvec3(i, j, k) - 11.5) < 10 ? 1 : 0);
        });
    const View view{
        .camera = frameBox(volume->worldBox(), ViewDirection::anterior, 20, 1.0), .width = 24, .height = 24};
    for (const LightFrame frame : {LightFrame::patient, LightFrame::camera}) {
        LightRig rig;
        rig.frame = frame;
        rig.lights = {{.azimuthDeg = 0,
                       .elevationDeg = 0,
                       .angularRadiusDeg = 15,
                       .colour = glm::dvec3(1),
                       .radiance = 20}};
        // Patient: in front of the patient. Camera: behind the viewer, who stands in front of the patient.
        const Environment lamp = Environment::fromRig(rig);
        const auto sides = [&](double rotationDeg, double strength) {
            Settings settings{.bounces = 1};
            settings.lightRotationDeg = rotationDeg;
            settings.lightStrength = strength;
            PathTracer t = tracer(volume, scenes::homogeneous(3.0), lamp, view, settings);
            EXPECT_TRUE(*t.trace(16));
            const auto image = t.readback();
            glm::dvec2 sum(0.0);  // left and right half of the picture
            for (std::size_t i = 0; i < image->radiance.size(); ++i)
                sum[i % 24 < 12 ? 0 : 1] += image->radiance[i].r;
            return sum;
        };
        const glm::dvec2 straight = sides(0, 1);
        EXPECT_NEAR(straight.x / straight.y, 1.0, 0.1);
        // Seen from the front, the patient's left is on the right of the picture.
        const glm::dvec2 turned = sides(90, 1);
        EXPECT_GT(turned.y, 4.0 * turned.x);
        const glm::dvec2 back = sides(-90, 1);
        EXPECT_GT(back.x, 4.0 * back.y);
        const glm::dvec2 around = sides(450, 1);
        EXPECT_NEAR(around.y, turned.y, 1e-4 * turned.y);
        // The same random numbers: exactly in proportion.
        const glm::dvec2 strong = sides(0, 2.5);
        EXPECT_NEAR(strong.x, 2.5 * straight.x, 1e-4 * strong.x);
        EXPECT_NEAR(sides(0, 0).x, 0.0, 1e-9);
    }
}

TEST_F(CastOnDevice, RefusesSettingsThatMeanNothing) {
    const auto volume = smallPhantom();
    PathTracer t = tracer(volume, builtIn("ct-bone"), kSky, oblique(*volume, 8), {});
    const auto refused = [&](const Settings& settings) {
        EXPECT_TRUE(t.setSettings(settings).ok());
        const auto traced = t.trace(1);
        return !traced.ok() && traced.error().code == ErrorCode::usage && !traced.error().hint.empty();
    };
    EXPECT_TRUE(refused({.exposure = 0.0}));
    EXPECT_TRUE(refused({.exposure = std::nan("")}));
    EXPECT_TRUE(refused({.lightRotationDeg = std::numeric_limits<double>::infinity()}));
    EXPECT_TRUE(refused({.lightStrength = -1.0}));
    EXPECT_TRUE(
        refused({.window = DisplayWindow{.center = 0, .width = 0, .explanation = {}, .function = {}}}));
    EXPECT_FALSE(refused({}));
}

TEST_F(CastOnDevice, DegenerateVolumes) {
    for (const glm::ivec3 size : {glm::ivec3(1, 1, 1), glm::ivec3(9, 9, 1), glm::ivec3(12, 1, 1)}) {
        const auto volume = scenes::volumeOf(size, affine({2, 0, 0}, {0, 3, 0}, {0, 0, 4}, {0, 0, 0}),
                                             [](int, int, int) { return 700; });
        const View view{.camera = frameBox(volume->worldBox(), ViewDirection::anterior, 20, 1.0),
                        .width = 9,
                        .height = 9};
        for (const LookTraits& look : kLooks) {
            Settings settings{.look = look.look};
            settings.window =
                DisplayWindow{.center = 700, .width = 100, .explanation = {}, .function = "LINEAR_EXACT"};
            PathTracer t = tracer(volume, scenes::homogeneous(2.0), kSky, view, settings);
            ASSERT_TRUE(*t.trace(16));
            const auto image = t.readback();
            ASSERT_TRUE(image.ok());
            EXPECT_GT(image->radiance[40].a, 0.5f) << look.name;
            EXPECT_GT(image->radiance[40].r, 0.02f) << look.name;
            EXPECT_EQ(image->radiance[0], glm::vec4(0.0f)) << look.name;
        }
        TransferFunction unseen = scenes::homogeneous(2.0);
        unseen.opacity = {{0, 0.0}};
        PathTracer t = tracer(volume, unseen, kSky, view, {.look = Look::dvr});
        ASSERT_TRUE(*t.trace(2));
        const auto empty = t.readback();
        for (const glm::vec4& pixel : empty->radiance) EXPECT_EQ(pixel, glm::vec4(0.0f));
    }
}

}  // namespace
}  // namespace macula::trace
