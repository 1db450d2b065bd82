// What counts as ripple, and the shapes that it is measured on.
#include "evaluate/ripple.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "evaluate/made_shapes.h"

namespace macula::evaluate {
namespace {

constexpr int kSize = 64;

LuminancePicture smoothPicture() {
    LuminancePicture picture{kSize, kSize, {}};
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const double u = (x - 31.5) / 32.0;
            const double v = (y - 31.5) / 32.0;
            picture.luminance.push_back(2.0 - u * u * v + 0.5 * std::pow(v, 6) - 0.3 * std::pow(u * v, 3));
        }
    }
    return picture;
}

std::vector<std::uint8_t> all() {
    return std::vector<std::uint8_t>(std::size_t(kSize * kSize), 1);
}

TEST(Ripple, ASmoothPictureHasNone) {
    const Ripple ripple = rippleOf(smoothPicture(), smoothPicture(), all());
    EXPECT_LT(ripple.relative, 1e-7);
    EXPECT_NEAR(ripple.mean, 2.0, 0.1);
}

TEST(Ripple, IsWhatBothPicturesShareBesideNoise) {
    LuminancePicture a = smoothPicture();
    LuminancePicture b = a;
    std::mt19937 engine(3);
    std::normal_distribution<double> noise(0.0, 0.03);
    double mean = 0.0;
    for (std::size_t i = 0; i < a.luminance.size(); ++i) {
        const double wave = 0.02 * std::sin(2.0 * 3.14159265 * double(i % kSize) / 7.0);
        mean += a.luminance[i] / double(a.luminance.size());
        a.luminance[i] += wave + noise(engine);
        b.luminance[i] += wave + noise(engine);
    }
    const Ripple ripple = rippleOf(a, b, all());
    EXPECT_NEAR(ripple.relative, 0.02 / std::sqrt(2.0) / mean, 0.1 * 0.0141 / mean);
    EXPECT_LT(ripple.least, ripple.relative);
    // Of noise alone no more is found than what is said to be the least.
    LuminancePicture c = smoothPicture();
    LuminancePicture d = c;
    for (std::size_t i = 0; i < c.luminance.size(); ++i) {
        c.luminance[i] += noise(engine);
        d.luminance[i] += noise(engine);
    }
    const Ripple none = rippleOf(c, d, all());
    EXPECT_LT(none.relative, 2.0 * none.least);
    EXPECT_LT(none.least, 0.2 * 0.03 / mean);
}

TEST(Ripple, OnlyPixelsThatCountDo) {
    LuminancePicture picture = smoothPicture();
    std::vector<std::uint8_t> counts = all();
    for (std::size_t i = 0; i < counts.size(); i += 5) {
        counts[i] = 0;
        picture.luminance[i] = 100.0;
    }
    EXPECT_LT(rippleOf(picture, picture, counts).relative, 1e-7);
    counts[5] = 1;
    EXPECT_GT(rippleOf(picture, picture, counts).relative, 0.1);
}

TEST(Ripple, OfABlackPictureIsNone) {
    const LuminancePicture black{kSize, kSize, std::vector<double>(std::size_t(kSize * kSize))};
    EXPECT_EQ(rippleOf(black, black, all()).relative, 0.0);
}

// Half way between air and water lies the surface, and nowhere else in the middle of the volume.
TEST(MadeShapes, HaveTheirSurfaceWhereTheySay) {
    for (const Shape shape : kShapes) {
        const Volume volume = make(shape);
        int inside = 0;
        for (int k = 8; k < 56; k += 3) {
            for (int j = 8; j < 56; ++j) {
                const glm::dvec3 at = transformPoint(volume.worldFromVoxel(), glm::dvec3(30, j, k));
                const double depth = depthIn(shape, at);
                const double value = volume.value(30, j, k);
                if (depth > 2.5) {
                    EXPECT_EQ(value, 40.0) << nameOf(shape);
                }
                if (depth < -2.5) {
                    EXPECT_EQ(value, -1000.0) << nameOf(shape);
                }
                inside += depth > 0.0 ? 1 : 0;
            }
        }
        EXPECT_GT(inside, 100) << nameOf(shape);
    }
}

TEST(MadeShapes, DetailsAreThinAndInTheMiddle) {
    const Volume vessel = make(Detail::vessel);
    EXPECT_GT(vessel.value(24, 5, 20), 400.0);
    EXPECT_NEAR(vessel.value(20, 5, 20), 100.0, 2.0);
    const Volume fissure = make(Detail::fissure);
    EXPECT_GT(fissure.value(24, 5, 20), 200.0);
    EXPECT_NEAR(fissure.value(20, 5, 20), 100.0, 2.0);
    const Volume lines = make(Detail::lines);
    double least = 1000.0;
    double most = 0.0;
    for (int i = 20; i < 24; ++i) {
        least = std::min(least, lines.value(i, 5, 20));
        most = std::max(most, lines.value(i, 5, 20));
    }
    EXPECT_LT(least, 250.0);
    EXPECT_GT(most, 750.0);
}

}  // namespace
}  // namespace macula::evaluate
