// Ray casting against closed forms and against a dense march, without a device.
#include <gtest/gtest.h>

#include "pipeline/trace/reference_tracer.h"
#include "trace/clips.h"
#include "trace/dense_cast.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

const Environment kSky = Environment::constant(glm::vec3(1.0f));

std::vector<glm::dvec4> castMatter(const Volume& volume, const TransferFunction& function, const View& view,
                                   const Clip& clip = {}, bool shading = false, std::uint32_t samples = 1,
                                   Filter filter = Filter::trilinear) {
    const Medium medium = makeMedium(volume, makeBrickGrid(volume, reachOf(filter)), function, clip);
    const auto params = makeTraceParams(volume, medium, kSky, view, {.look = Look::dvr}, clip);
    auto sums = ReferenceTracer(volume, medium, kSky)
                    .cast(*params, {.kind = shared::kCastMatter, .shading = shading, .filter = filter},
                          Precision::twofold, 0, samples);
    for (glm::dvec4& sum : sums) sum /= double(samples);
    return sums;
}

// The values behind the greys of a projection, for a window that loses nothing.
std::vector<double> project(const Volume& volume, Projection projection, const View& view, const Clip& clip,
                            std::vector<bool>& met) {
    const Medium medium = makeMedium(volume, makeBrickGrid(volume), projection, clip);
    constexpr double kLow = -5000.0;
    constexpr double kWidth = 10000.0;
    const Settings settings{
        .look = Look::mip,
        .window = DisplayWindow{
            .center = kLow + kWidth / 2.0, .width = kWidth, .explanation = {}, .function = "LINEAR_EXACT"}};
    const auto params = makeTraceParams(volume, medium, kSky, view, settings, clip);
    const int kind = projection == Projection::maximum   ? shared::kCastMaximum
                     : projection == Projection::minimum ? shared::kCastMinimum
                                                         : shared::kCastMean;
    const auto sums =
        ReferenceTracer(volume, medium, kSky).cast(*params, {.kind = kind}, Precision::twofold, 0, 1);
    std::vector<double> values;
    met.clear();
    for (const glm::dvec4& sum : sums) {
        met.push_back(sum.a > 0.0);
        // Between 0.08 and 0.8 the tone map takes 0.04 away, and nothing else.
        const double linear = sum.r - 0.04;
        const double encoded =
            linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
        values.push_back(kLow + kWidth * encoded);
    }
    return values;
}

// Smooth bumps on an oblique, anisotropic grid: 0 to 1000.
std::shared_ptr<const Volume> bumps(glm::ivec3 size = {30, 23, 17}) {
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1, 2, -1)));
    const glm::dmat4 toWorld = turn * affine({0.7, 0, 0}, {0, 1.1, 0}, {0, 0, 2.5}, {-11, -12, -20});
    return scenes::volumeOf(size, toWorld, [](int i, int j, int k) {
        return std::uint16_t(500.0 + 499.0 * std::sin(0.5 * i) * std::cos(0.4 * j) * std::sin(0.7 * k + 1.0));
    });
}

TransferFunction coloured() {
    TransferFunction function;
    function.name = "coloured";
    function.unit = Unit::raw;
    function.opacity = {{300, 0.0}, {600, 0.3}, {800, 0.05}, {1000, 0.9}};
    function.colour = {{0, {0.1, 0.2, 0.9}}, {600, {0.9, 0.3, 0.2}}, {1000, {1, 1, 0.8}}};
    function.unitDistanceMm = 3.0;
    function.albedo = 0.9;
    return function;
}

View lookAt(const Volume& volume, int pixels) {
    const Box box = volume.worldBox();
    return {.camera = {.positionMm = box.centre() + glm::dvec3(0.9, -1.4, 0.5) * box.diagonal(),
                       .targetMm = box.centre(),
                       .up = {0, 0, 1},
                       .verticalFovDeg = 28},
            .width = pixels,
            .height = pixels};
}

// Homogeneous matter is what the exponential says, whatever the steps.
TEST(Cast, IsExactForASlab) {
    for (const double perMm : {0.01, 0.2, 1.0, 5.0}) {
        const auto [volume, view] = scenes::slab(2.0, 2);
        TransferFunction function = scenes::homogeneous(perMm, 0.5);
        function.colour = {{0.0, {1.0, 0.5, 0.0}}};
        for (const glm::dvec4& pixel : castMatter(*volume, function, view)) {
            double coverage = 1.0 - std::exp(-2.0 * perMm);
            if (coverage > 1.0 - 1.0 / 256.0) coverage = 1.0;  // opaque
            EXPECT_NEAR(pixel.a, coverage, 2e-6);
            EXPECT_NEAR(pixel.r, 0.5 * coverage, 2e-6);
            EXPECT_NEAR(pixel.g, 0.5 * scenes::linearOf(0.5) * coverage, 2e-6);
            EXPECT_EQ(pixel.b, 0.0);
        }
    }
}

TEST(Cast, MatterIsThatOfADenseMarch) {
    const auto volume = bumps();
    const View view = lookAt(*volume, 16);
    scenes::Chance chance(5);
    for (int trial = 0; trial < 12; ++trial) {
        const Clip clip = trial == 0 ? Clip{} : scenes::anyClip(chance, volume->worldBox());
        const auto cast = castMatter(*volume, coloured(), view, clip);
        double error = 0.0;
        for (std::size_t i = 0; i < cast.size(); ++i) {
            const auto x = double(i % 16) + 0.5;
            const auto y = double(i / 16) + 0.5;
            const auto truth = scenes::denseCast(*volume, coloured(), clip, view.camera.positionMm,
                                                 scenes::eyeRay(view, x, y), 40);
            const glm::dvec4 difference = glm::abs(cast[i] - truth.matter);
            EXPECT_LT(std::max({difference.r, difference.g, difference.b, difference.a}), 0.02)
                << "clip " << trial << " pixel " << i;
            error += (difference.r + difference.g + difference.b + difference.a) / 4.0 / double(cast.size());
        }
        EXPECT_LT(error, 0.001) << "clip " << trial;
    }
}

TEST(Cast, ProjectionsAreThoseOfADenseMarch) {
    const auto volume = bumps();
    const View view = lookAt(*volume, 16);
    scenes::Chance chance(6);
    for (int trial = 0; trial < 12; ++trial) {
        const Clip clip = trial == 0 ? Clip{} : scenes::anyClip(chance, volume->worldBox());
        for (const auto projection : {Projection::maximum, Projection::minimum, Projection::mean}) {
            std::vector<bool> met;
            const auto values = project(*volume, projection, view, clip, met);
            int touching = 0;
            double error = 0.0;
            int counted = 0;
            for (std::size_t i = 0; i < values.size(); ++i) {
                const auto x = double(i % 16) + 0.5;
                const auto y = double(i / 16) + 0.5;
                const auto truth = scenes::denseCast(*volume, coloured(), clip, view.camera.positionMm,
                                                     scenes::eyeRay(view, x, y), 40);
                if (met[i] != truth.met) {  // by less than a step
                    ++touching;
                    continue;
                }
                if (!truth.met) continue;
                const double expected = projection == Projection::maximum   ? truth.largest
                                        : projection == Projection::minimum ? truth.smallest
                                                                            : truth.mean;
                // Values change by up to 250 per voxel; half a step beside a peak that is not lost of it is a
                // sixth of that, but at the end of a short ray.
                EXPECT_NEAR(values[i], expected, 60.0) << "clip " << trial << " pixel " << i;
                error += std::abs(values[i] - expected);
                ++counted;
            }
            EXPECT_LE(touching, 2) << "clip " << trial;
            EXPECT_LE(error, 1.5 * counted) << "clip " << trial;
        }
    }
}

// Samples beside each other in the pixel and in their steps come to the mean of the truth over the pixel.
TEST(Cast, SamplesConverge) {
    const auto volume = bumps();
    const View view = lookAt(*volume, 6);
    const auto few = castMatter(*volume, coloured(), view, {}, false, 4);
    const auto many = castMatter(*volume, coloured(), view, {}, false, 256);
    for (std::size_t i = 0; i < many.size(); ++i) {
        glm::dvec4 truth(0.0);
        for (int s = 0; s < 64; ++s) {
            const double x = double(i % 6) + (s % 8 + 0.5) / 8.0;
            const double y = double(i / 6) + (s / 8 + 0.5) / 8.0;
            truth += scenes::denseCast(*volume, coloured(), {}, view.camera.positionMm,
                                       scenes::eyeRay(view, x, y), 20)
                         .matter /
                     64.0;
        }
        EXPECT_LT(glm::length(many[i] - truth), 0.02) << i;
        EXPECT_LT(glm::length(few[i] - truth), 0.15) << i;
    }
}

// Volumes of one voxel, one slice, one row; and one of which nothing can be seen.
TEST(Cast, DegenerateVolumes) {
    for (const glm::ivec3 size :
         {glm::ivec3(1, 1, 1), glm::ivec3(9, 9, 1), glm::ivec3(1, 9, 9), glm::ivec3(12, 1, 1)}) {
        const auto volume = scenes::volumeOf(size, affine({2, 0, 0}, {0, 3, 0}, {0, 0, 4}, {0, 0, 0}),
                                             [](int, int, int) { return 700; });
        const Box box = volume->worldBox();
        const View view{.camera = frameBox(box, ViewDirection::anterior, 20, 1.0), .width = 9, .height = 9};
        const auto cast = castMatter(*volume, coloured(), view);
        const auto truth = scenes::denseCast(*volume, coloured(), {}, view.camera.positionMm,
                                             scenes::eyeRay(view, 4.5, 4.5));
        EXPECT_GT(truth.matter.a, 0.05);
        EXPECT_LT(glm::length(cast[40] - truth.matter), 1e-5);
        std::vector<bool> met;
        for (const auto projection : {Projection::maximum, Projection::minimum, Projection::mean}) {
            EXPECT_NEAR(project(*volume, projection, view, {}, met)[40], 700.0, 0.01);
            EXPECT_TRUE(met[40]);
            EXPECT_FALSE(met[0]);
        }
        TransferFunction unseen = coloured();
        unseen.opacity = {{0, 0.0}};
        for (const glm::dvec4& pixel : castMatter(*volume, unseen, view)) EXPECT_EQ(pixel, glm::dvec4(0.0));
    }
}

// Padding is no value: neither a minimum, nor part of a mean, nor of a picture.
TEST(Cast, PaddingIsNotCounted) {
    std::vector<std::uint16_t> voxels(16 * 16 * 16);
    for (int i = 0; i < 16 * 16 * 16; ++i) voxels[std::size_t(i)] = i % 16 < 8 ? 0 : 300;
    auto made = Volume::create({.size = {16, 16, 16},
                                .worldFromVoxel = affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}),
                                .unitsFromStored = {.slope = 1.0, .intercept = 0.0},
                                .unit = Unit::raw,
                                .modality = "OT",
                                .padding = StoredRange{0, 0},
                                .provenance = {}},
                               std::move(voxels));
    const Volume volume = std::move(made).value();
    for (const auto direction : {ViewDirection::left, ViewDirection::anterior}) {
        const View view{.camera = frameBox(volume.worldBox(), direction, 5, 1.0), .width = 16, .height = 16};
        std::vector<bool> met;
        for (const auto projection : {Projection::maximum, Projection::minimum, Projection::mean}) {
            const auto values = project(volume, projection, view, {}, met);
            int seen = 0;
            for (std::size_t i = 0; i < values.size(); ++i) {
                if (!met[i]) continue;
                ++seen;
                EXPECT_LT(values[i], 300.01) << i;
                // Beside padding a maximum is interpolated with it.
                const bool isInterpolated =
                    direction == ViewDirection::anterior && projection == Projection::maximum;
                EXPECT_GT(values[i], isInterpolated ? 99.0 : 299.0) << i;
            }
            EXPECT_GT(seen, direction == ViewDirection::left ? 100 : 40);
            EXPECT_LT(seen, direction == ViewDirection::left ? 257 : 130);
        }
    }
}

// Air in the trachea is -1000 HU exactly, as what padding is drawn as is: it is a minimum, and part of a
// mean, all the same.
TEST(Cast, AirInTheScanIsCountedBesidePadding) {
    std::vector<std::uint16_t> voxels(16 * 16 * 16);
    for (int i = 0; i < 16 * 16 * 16; ++i) {
        const int x = i % 16;
        const int z = i / 256;
        voxels[std::size_t(i)] = x < 4 ? 0 : z < 8 ? 24 : 1124;  // padding; air; 100 HU
    }
    auto made = Volume::create({.size = {16, 16, 16},
                                .worldFromVoxel = affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}),
                                .unitsFromStored = {.slope = 1.0, .intercept = -1024.0},
                                .unit = Unit::hounsfield,
                                .modality = "CT",
                                .padding = StoredRange{0, 0},
                                .provenance = {}},
                               std::move(voxels));
    const Volume volume = std::move(made).value();
    // Along the axis that leads from air to what is 100 HU; across the padding there is nothing to see.
    const View view{
        .camera = frameBox(volume.worldBox(), ViewDirection::superior, 5, 1.0), .width = 16, .height = 16};
    std::vector<bool> met;
    for (const auto projection : {Projection::minimum, Projection::mean}) {
        const auto values = project(volume, projection, view, {}, met);
        EXPECT_TRUE(std::ranges::count(met, true) > 100);
        // In the middle of the picture; at its edges rays leave by the sides before they reach the air.
        for (std::size_t y = 5; y < 11; ++y) {
            for (std::size_t x = 7; x < 11; ++x) {
                ASSERT_TRUE(met[y * 16 + x]);
                EXPECT_NEAR(values[y * 16 + x], projection == Projection::minimum ? -1000.0 : -450.0, 60.0)
                    << x << ", " << y;
            }
        }
    }
    // Where there is nothing but air, that is what is seen.
    const View across{
        .camera = frameBox(volume.worldBox(), ViewDirection::left, 5, 1.0), .width = 16, .height = 16};
    const auto values = project(volume, Projection::mean, across, {}, met);
    int air = 0;
    for (std::size_t i = 0; i < values.size(); ++i) air += met[i] && values[i] < -999.0 ? 1 : 0;
    EXPECT_GT(air, 50);
}

// A ball whose value falls from its centre outward: the headlight lights the middle and leaves the rim to the
// ambient part.
TEST(Cast, HeadlightIsLambert) {
    const auto volume = scenes::volumeOf(
        {40, 40, 20}, affine({1, 0, 0}, {0, 1, 0}, {0, 0, 2}, {-19.5, -19.5, -19}), [](int i, int j, int k) {
            const glm::dvec3 p(i - 19.5, j - 19.5, 2.0 * k - 19.0);
            return std::uint16_t(std::max(0.0, 2000.0 - 100.0 * glm::length(p)));
        });
    TransferFunction function = scenes::homogeneous(1.0);
    function.opacity = {{500, 0.0}, {520, 0.999}};  // a sphere of 15 mm
    function.lighting.ambient = 0.2;
    function.lighting.diffuse = 0.7;
    function.unitDistanceMm = 0.05;
    const View view{.camera = {.positionMm = {0, -2000, 0}, .targetMm = {0, 0, 0}, .verticalFovDeg = 1.0},
                    .width = 35,
                    .height = 35};
    const auto cast = castMatter(*volume, function, view, {}, true, 16);
    const double mmPerPixel = 2.0 * 2000.0 * std::tan(glm::radians(0.5)) / 35.0;
    for (int y = 0; y < 35; ++y) {
        for (int x = 0; x < 35; ++x) {
            const double r = mmPerPixel * std::hypot(x - 17, y - 17) / 15.0;
            if (r > 0.9) continue;
            const glm::dvec4 pixel = cast[std::size_t(35 * y + x)];
            EXPECT_EQ(pixel.a, 1.0);
            EXPECT_NEAR(pixel.r, 0.2 + 0.7 * std::sqrt(1.0 - r * r), 0.03) << x << " " << y;
        }
    }
}

// Values and gradients by a spline: of smooth bumps, and of voxels that differ as much as they can.
template <class Spline>
void expectMatterOfADenseMarch(Filter filter) {
    const glm::dmat4 toWorld = affine({0.7, 0, 0}, {0, 1.1, 0}, {0, 0, 1.6}, {-4, -5, -6});
    const bool isSharp = filter == Filter::sharp;
    // Where the sharp spline is held to such voxels it has kinks, which no polynomial follows.
    const auto rough = scenes::volumeOf({12, 10, 9}, toWorld, [&](int i, int j, int k) {
        if (isSharp) return std::uint16_t(625 + 275 * std::sin(1.3 * i) * std::cos(1.1 * j - 0.9 * k));
        return std::uint16_t((i * 7 + j * 5 + k * 3) % 4 < 2 ? 350 : 900);
    });
    scenes::Chance chance(8);
    for (int trial = 0; trial < 8; ++trial) {
        const auto volume = trial % 2 == 0 ? bumps() : rough;
        const bool isLit = trial % 4 > 1;
        TransferFunction function = coloured();
        if (trial > 3) function.gradientOpacity = {{0, 0.2}, {100, 1.0}};
        const Clip clip = trial < 6 ? Clip{} : scenes::anyClip(chance, volume->worldBox());
        const View view = lookAt(*volume, 12);
        const auto cast = castMatter(*volume, function, view, clip, isLit, 8, filter);
        const auto plain =
            castMatter(*volume, function, view, clip, isLit, 8, isSharp ? Filter::smooth : Filter::trilinear);
        double error = 0.0;
        double other = 0.0;
        for (std::size_t i = 0; i < cast.size(); ++i) {
            glm::dvec4 truth(0.0);
            for (int s = 0; s < 16; ++s) {
                const double x = double(i % 12) + (s % 4 + 0.5) / 4.0;
                const double y = double(i / 12) + (s / 4 + 0.5) / 4.0;
                truth += scenes::denseCast<Spline>(*volume, function, clip, view.camera.positionMm,
                                                   scenes::eyeRay(view, x, y), 12, isLit)
                             .matter /
                         16.0;
            }
            error += glm::length(cast[i] - truth) / double(cast.size());
            other += glm::length(plain[i] - truth) / double(cast.size());
        }
        EXPECT_LT(error, 0.012) << trial;
        if (trial % 2 == 1) {
            EXPECT_GT(other, 3.0 * error) << trial << ": the test must tell them apart";
        }
    }
}

TEST(Cast, SmoothMatterIsThatOfADenseMarchOfTheSpline) {
    expectMatterOfADenseMarch<scenes::Spline>(Filter::smooth);
}

TEST(Cast, SharpMatterIsThatOfADenseMarchOfTheSpline) {
    expectMatterOfADenseMarch<scenes::SharpSpline>(Filter::sharp);
}

// One voxel, and values a million to one: nothing that is not a number, nothing beyond opaque.
TEST(Cast, ValuesOfSplinesOfOneVoxelAndOfExtremesAreFinite) {
    for (const int trial : {0, 1, 2, 3, 4, 5}) {
        const int edge = trial / 2 + 1;
        const Filter filter = trial % 2 == 0 ? Filter::smooth : Filter::sharp;
        const auto volume = scenes::volumeOf(
            {edge, edge, edge}, affine({1e-3, 0, 0}, {0, 1, 0}, {0, 0, 1e3}, {0, 0, 0}),
            [](int i, int j, int k) { return std::uint16_t((i + j + k) % 2 == 0 ? 65535 : 0); });
        TransferFunction function = coloured();
        function.opacity = {{0, 1.0}};
        for (const auto& pixel : castMatter(*volume, function, lookAt(*volume, 6), {}, true, 2, filter)) {
            for (int channel = 0; channel < 4; ++channel) {
                EXPECT_TRUE(pixel[channel] >= 0.0 && pixel[channel] <= 1.0) << edge;
            }
        }
    }
}

// Two pairs of curves, mixed by how steeply values change: by both kinds of values between voxels, lit and
// not, and under a gradient opacity too.
TEST(Cast, SteepMatterIsThatOfADenseMarch) {
    const auto volume = bumps();
    const View view = lookAt(*volume, 12);
    TransferFunction function = coloured();
    function.steep = {.opacity = {{200, 0.0}, {500, 0.5}, {900, 0.1}},
                      .colour = {{200, {0.1, 0.9, 0.2}}, {900, {0.9, 0.9, 0.1}}},
                      .gradientPerMm = 150.0};
    for (int trial = 0; trial < 6; ++trial) {
        const bool isSmooth = trial % 2 == 1;
        const bool isLit = trial > 1;
        TransferFunction drawn = function;
        if (trial > 3) drawn.gradientOpacity = {{0, 0.3}, {120, 1.0}};
        const auto filter = isSmooth ? Filter::smooth : Filter::trilinear;
        const auto cast = castMatter(*volume, drawn, view, {}, isLit, 8, filter);
        TransferFunction flat = drawn;
        flat.steep = {};
        const auto other = castMatter(*volume, flat, view, {}, isLit, 8, filter);
        double error = 0.0;
        double differs = 0.0;
        for (std::size_t i = 0; i < cast.size(); ++i) {
            glm::dvec4 truth(0.0);
            for (int s = 0; s < 16; ++s) {
                const glm::dvec3 ray = scenes::eyeRay(view, double(i % 12) + (s % 4 + 0.5) / 4.0,
                                                      double(i / 12) + (s / 4 + 0.5) / 4.0);
                const glm::dvec3& eye = view.camera.positionMm;
                truth +=
                    (isSmooth ? scenes::denseCast<scenes::Spline>(*volume, drawn, {}, eye, ray, 12, isLit)
                              : scenes::denseCast<>(*volume, drawn, {}, eye, ray, 12, isLit))
                        .matter /
                    16.0;
            }
            error += glm::length(cast[i] - truth) / double(cast.size());
            differs += glm::length(cast[i] - other[i]) / double(cast.size());
        }
        EXPECT_LT(error, 0.012) << trial;
        EXPECT_GT(differs, 5.0 * error) << trial << ": the test must tell curves apart";
    }
}

// As VTK: opacities multiply, gradients are per voxel of mean edge. A ramp has the same gradient everywhere.
TEST(Cast, GradientOpacity) {
    const auto volume =
        scenes::volumeOf({24, 20, 16}, affine({1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {-12, -20, -24}),
                         [](int, int j, int) { return std::uint16_t(1000 + 30 * j); });
    TransferFunction function = scenes::homogeneous(1.0);
    function.opacity = {{0, 0.02}};
    function.unitDistanceMm = 2.0;
    function.density = 1.0;
    function.gradientOpacity = {{0, 1.0}, {20, 0.0}, {40, 1.0}};
    // 30 per 2 mm, times the mean edge of 2 mm: 30 per voxel, where the curve is one half.
    const View view{.camera = {.positionMm = {0, -3000, 0}, .targetMm = {0, 0, 0}, .verticalFovDeg = 0.2},
                    .width = 2,
                    .height = 2};
    // At the first and last voxel the values end, and so do the gradients: there is matter with half of it or
    // none.
    const auto truth =
        scenes::denseCast(*volume, function, {}, view.camera.positionMm, scenes::eyeRay(view, 0.5, 0.5));
    const auto cast = castMatter(*volume, function, view);
    EXPECT_NEAR(truth.matter.a, 1.0 - std::pow(1.0 - 0.01, 20.0), 0.015);
    for (const glm::dvec4& pixel : cast) EXPECT_LT(glm::length(pixel - truth.matter), 0.002);

    // Light paths meet the same: ratio tracking through it is the transmittance.
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), function);
    const auto params = makeTraceParams(*volume, medium, kSky, view, {});
    const auto moments =
        ReferenceTracer(*volume, medium, kSky)
            .transmittance(*params, Filter::trilinear, Precision::twofold, glm::dvec3(params->originVoxel),
                           scenes::eyeRay(view, 1.0, 1.0), 40000);
    const double mean = moments.sum / 40000;
    const double deviation = std::sqrt((moments.sumOfSquares / 40000 - mean * mean) / 40000);
    EXPECT_NEAR(mean, 1.0 - truth.matter.a, 5.0 * deviation + 0.001);
}

}  // namespace
}  // namespace macula::trace
