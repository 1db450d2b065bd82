// A thin lens where the answer is a formula: a small bright voxel out of focus is a disc. The device is held
// to the same maths in lens_device_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "pipeline/trace/guide_pixel.h"
#include "pipeline/trace/reference_tracer.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

const Environment kSky = Environment::constant(glm::vec3(1.0f));

constexpr int kSide = 48;           // pixels
constexpr double kHeightMm = 14.0;  // of the picture, where the voxel is
constexpr double kFarMm = 200.0;    // the voxel, from the camera
constexpr double kLensMm = 20.0;

// One voxel of 0.8 mm in air, opaque.
struct Speck {
    std::shared_ptr<const Volume> volume =
        scenes::volumeOf({9, 9, 9}, affine({0.8, 0, 0}, {0, 0.8, 0}, {0, 0, 0.8}, glm::dvec3(-3.2)),
                         [](int i, int j, int k) { return std::uint16_t(i == 4 && j == 4 && k == 4); });
    Medium medium = makeMedium(*volume, makeBrickGrid(*volume), scenes::homogeneous(15.0));
    ReferenceTracer tracer{*volume, medium, kSky};

    // Of each pixel, row by row.
    std::vector<double> coverage(const View& view, std::uint32_t samples) const {
        const auto params = makeTraceParams(*volume, medium, kSky, view, {.bounces = 1, .seed = 5});
        std::vector<double> covered;
        for (const glm::dvec4& sum : tracer.trace(*params, Filter::trilinear, Precision::twofold, 0, samples))
            covered.push_back(sum.w / double(samples));
        return covered;
    }
    std::vector<double> coverageOfGuides(const View& view) const {
        const auto params = makeTraceParams(*volume, medium, kSky, view, {});
        std::vector<double> covered;
        for (const auto& guide : tracer.guides(*params, *guidePush(view, view), Precision::twofold))
            covered.push_back(guide.coverage);
        return covered;
    }
};

const Speck& speck() {
    static const Speck only;
    return only;
}

View viewOf(bool isParallel, const Lens& lens) {
    Camera camera;
    camera.positionMm = {0, -kFarMm, 0};
    camera.targetMm = {0, 0, 0};
    camera.verticalFovDeg = 2.0 * glm::degrees(std::atan(0.5 * kHeightMm / kFarMm));
    if (isParallel) camera.parallelHeightMm = kHeightMm;
    return {.camera = camera, .width = kSide, .height = kSide, .lens = lens};
}

// Of a picture of coverage: its sum, and its variance about the middle along both axes, in pixels squared.
struct Spread {
    double sum = 0.0;
    double variance = 0.0;
};
Spread spreadOf(const std::vector<double>& covered) {
    Spread spread;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const double weight = covered[std::size_t(y * kSide + x)];
            const glm::dvec2 off(x + 0.5 - 0.5 * kSide, y + 0.5 - 0.5 * kSide);
            spread.sum += weight;
            spread.variance += 0.5 * weight * glm::dot(off, off);
        }
    }
    spread.variance /= spread.sum;
    return spread;
}

// A uniform disc of diameter c varies by c^2 / 16 along each axis, and what lies under it adds its own: so
// the circle of confusion is found without looking for its border.
double discPx(const Spread& blurred, const Spread& sharp) {
    return 4.0 * std::sqrt(std::max(blurred.variance - sharp.variance, 0.0));
}

// The circle of confusion of what is kFarMm away, in pixels; of a camera with an eye by similar triangles, of
// parallel rays without the division by its distance.
double expectedPx(bool isParallel, double focusMm) {
    const double atObjectMm = isParallel ? kLensMm * std::abs(1.0 - kFarMm / focusMm)
                                         : kLensMm * std::abs(kFarMm - focusMm) / focusMm;
    return atObjectMm * kSide / kHeightMm;
}

TEST(Lens, ASmallVoxelIsADiscOfTheFormula) {
    constexpr std::uint32_t kSamples = 160;
    for (const bool isParallel : {false, true}) {
        const Spread sharp = spreadOf(speck().coverage(viewOf(isParallel, {}), kSamples));
        for (const double focusMm : {150.0, 300.0, 180.0}) {
            SCOPED_TRACE(std::string(isParallel ? "parallel " : "eye ") + std::to_string(focusMm));
            const View view = viewOf(isParallel, {.diameterMm = kLensMm, .focusMm = focusMm});
            const double expected = expectedPx(isParallel, focusMm);
            const std::vector<double> covered = speck().coverage(view, kSamples);
            const Spread blurred = spreadOf(covered);
            EXPECT_NEAR(discPx(blurred, sharp), expected, 0.04 * expected);
            EXPECT_NEAR(blurred.sum, sharp.sum, 0.05 * sharp.sum) << "no light is lost";
            // Uniform: half of its radius has a quarter of it.
            double inner = 0.0;
            for (int y = 0; y < kSide; ++y)
                for (int x = 0; x < kSide; ++x)
                    inner += std::hypot(x + 0.5 - 0.5 * kSide, y + 0.5 - 0.5 * kSide) < 0.25 * expected
                                 ? covered[std::size_t(y * kSide + x)]
                                 : 0.0;
            EXPECT_NEAR(inner / blurred.sum, 0.25, 0.05);
        }
        // What is in focus is as sharp as without a lens.
        const View view = viewOf(isParallel, {.diameterMm = kLensMm, .focusMm = kFarMm});
        EXPECT_LT(discPx(spreadOf(speck().coverage(view, kSamples)), sharp), 0.7);
    }
}

// Else the filter would sharpen what the lens has blurred.
TEST(Lens, GuidesAreAsBlurredAsThePicture) {
    for (const bool isParallel : {false, true}) {
        const Spread sharp = spreadOf(speck().coverageOfGuides(viewOf(isParallel, {})));
        for (const double focusMm : {150.0, 300.0, 180.0}) {
            const View view = viewOf(isParallel, {.diameterMm = kLensMm, .focusMm = focusMm});
            const Spread blurred = spreadOf(speck().coverageOfGuides(view));
            const double expected = expectedPx(isParallel, focusMm);
            EXPECT_NEAR(discPx(blurred, sharp), expected, 0.06 * expected) << focusMm;
            EXPECT_NEAR(blurred.sum, sharp.sum, 0.1 * sharp.sum) << focusMm;
        }
    }
}

// A wall in focus has the depth, the normal and the colour that it has without a lens.
TEST(Lens, GuidesOfWhatIsInFocusAreThoseWithoutALens) {
    const auto [volume, narrow] = scenes::slab(10.0, 8);
    View view = narrow;
    view.camera.positionMm = {0.1, -205, 0.2};
    view.camera.verticalFovDeg = 4.0;
    TransferFunction wall = scenes::homogeneous(50.0, 0.7);
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), wall);
    const ReferenceTracer tracer(*volume, medium, kSky);
    const auto guidesOf = [&](const View& of) {
        return tracer.guides(*makeTraceParams(*volume, medium, kSky, of, {}), *guidePush(of, of),
                             Precision::twofold);
    };
    const auto sharp = guidesOf(view);
    view.lens = {.diameterMm = 10.0, .focusMm = 200.0};
    const auto seen = guidesOf(view);
    for (std::size_t i = 0; i < sharp.size(); ++i) {
        EXPECT_NEAR(seen[i].depthMm, sharp[i].depthMm, 0.1);
        EXPECT_NEAR(seen[i].coverage, sharp[i].coverage, 1e-4);
        EXPECT_NEAR(seen[i].albedo.x, 0.7, 1e-6);
        EXPECT_LT(glm::distance(seen[i].normal, sharp[i].normal), 1e-6);
        EXPECT_NEAR(seen[i].beforeMm, sharp[i].depthMm, 0.2);
    }
}

TEST(Lens, WithoutADiameterThereIsNone) {
    const View bare = viewOf(false, {});
    const View closed = viewOf(false, {.diameterMm = 0.0, .focusMm = 123.0});
    EXPECT_EQ(speck().coverage(bare, 4), speck().coverage(closed, 4));
    EXPECT_EQ(speck().coverageOfGuides(bare), speck().coverageOfGuides(closed));
}

TEST(Lens, OneThatIsNoneIsRefused) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const Lens& lens : {Lens{-1.0, 100.0}, Lens{kNan, 100.0}, Lens{kInfinity, 100.0}, Lens{1e5, 100.0},
                             Lens{5.0, 0.0}, Lens{5.0, -3.0}, Lens{5.0, kNan}, Lens{5.0, kInfinity}}) {
        const auto params = makeTraceParams(*speck().volume, speck().medium, kSky, viewOf(false, lens), {});
        ASSERT_FALSE(params.ok()) << lens.diameterMm << " " << lens.focusMm;
        EXPECT_EQ(params.error().code, ErrorCode::usage);
        EXPECT_FALSE(params.error().hint.empty());
    }
}

// The widest lens and the nearest focus still give numbers.
TEST(Lens, ExtremesAreFinite) {
    for (const Lens& lens : {Lens{kMostLensMm, 1e-3}, Lens{kMostLensMm, kMostFocusMm}, Lens{1e-6, 1e-3},
                             Lens{1e-6, kMostFocusMm}}) {
        for (const bool isParallel : {false, true}) {
            for (const double covered : speck().coverage(viewOf(isParallel, lens), 1))
                ASSERT_TRUE(covered >= 0.0 && covered <= 1.0);
            for (const double covered : speck().coverageOfGuides(viewOf(isParallel, lens)))
                ASSERT_TRUE(covered >= 0.0 && covered <= 1.0);
        }
    }
}

}  // namespace
}  // namespace macula::trace
