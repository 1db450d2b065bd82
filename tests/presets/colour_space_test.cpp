// Interpolation of colours: colours known from elsewhere, and what each space promises.
#include "pipeline/volume/colour_space.h"

#include <gtest/gtest.h>

#include <array>

#include "pipeline/volume/transfer_function.h"

namespace macula {
namespace {

constexpr std::array<ColourSpace, 5> kMixing{ColourSpace::rgb, ColourSpace::hsv, ColourSpace::hsvWrap,
                                             ColourSpace::lab, ColourSpace::diverging};

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "channel " << i;
}

TEST(ColourSpace, NamesGoBothWays) {
    for (const ColourSpace space : kMixing) EXPECT_EQ(colourSpaceNamed(colourSpaceName(space)), space);
    EXPECT_EQ(colourSpaceNamed("step"), ColourSpace::step);
    EXPECT_FALSE(colourSpaceNamed("cmyk").has_value());
}

// The L*a*b* of sRGB primaries under D65, as in every table of them.
TEST(ColourSpace, LabOfKnownColours) {
    expectNear(labFromSrgb({1, 1, 1}), {100.0, 0.0, 0.0}, 0.02);
    expectNear(labFromSrgb({0, 0, 0}), {0.0, 0.0, 0.0}, 1e-3);
    expectNear(labFromSrgb({1, 0, 0}), {53.24, 80.09, 67.20}, 0.05);
    expectNear(labFromSrgb({0, 1, 0}), {87.73, -86.18, 83.18}, 0.05);
    expectNear(labFromSrgb({0, 0, 1}), {32.30, 79.19, -107.86}, 0.05);
    for (double r = 0.0; r <= 1.0; r += 0.25) {
        for (double g = 0.0; g <= 1.0; g += 0.25) {
            for (double b = 0.0; b <= 1.0; b += 0.25)
                expectNear(srgbFromLab(labFromSrgb({r, g, b})), {r, g, b}, 2e-3);
        }
    }
    expectNear(srgbFromLab({50.0, 0.0, 0.0}), {0.4663, 0.4663, 0.4663}, 2e-3);
}

TEST(ColourSpace, EndsAreKeptAndNothingLeavesTheRange) {
    const glm::dvec3 a{0.23, 0.30, 0.75};
    const glm::dvec3 b{0.71, 0.02, 0.15};
    for (const ColourSpace space : kMixing) {
        expectNear(mixColours(space, a, b, 0.0), a, 3e-3);
        expectNear(mixColours(space, a, b, 1.0), b, 3e-3);
        for (double s = 0.0; s <= 1.0; s += 0.01) {
            const glm::dvec3 mixed = mixColours(space, a, b, s);
            for (int i = 0; i < 3; ++i) EXPECT_TRUE(mixed[i] >= 0.0 && mixed[i] <= 1.0) << s;
        }
    }
}

TEST(ColourSpace, HueGoesThroughGreenOrTheShorterWay) {
    const glm::dvec3 red{1, 0, 0};
    const glm::dvec3 blue{0, 0, 1};
    // Hues 0 and 2/3: half way is 1/3, green; the shorter way leads through 5/6, magenta.
    expectNear(mixColours(ColourSpace::hsv, red, blue, 0.5), {0, 1, 0}, 1e-12);
    expectNear(mixColours(ColourSpace::hsvWrap, red, blue, 0.5), {1, 0, 1}, 1e-12);
    expectNear(mixColours(ColourSpace::hsv, {1, 1, 1}, {0, 0, 0}, 0.5), {0.5, 0.5, 0.5}, 1e-12);
}

// Moreland's "cool to warm": its middle is a light grey, rgb 221 of 255, between these two ends.
TEST(ColourSpace, DivergingPassesThroughWhite) {
    const glm::dvec3 cool{0.23137254902, 0.298039215686, 0.752941176471};
    const glm::dvec3 warm{0.705882352941, 0.0156862745098, 0.149019607843};
    expectNear(mixColours(ColourSpace::diverging, cool, warm, 0.5), glm::dvec3(221.0 / 255.0), 0.004);
    // Published with the paper, at an eighth of the way: 98, 130, 234.
    expectNear(mixColours(ColourSpace::diverging, cool, warm, 0.125), glm::dvec3(98, 130, 234) / 255.0,
               0.006);
    expectNear(mixColours(ColourSpace::diverging, cool, warm, 0.875), glm::dvec3(222, 96, 77) / 255.0, 0.006);
}

TEST(ColourSpace, AStepHasTheColourItEndsAt) {
    TransferFunction f;
    f.opacity = {{0.0, 1.0}};
    f.colour = {{0.0, {1, 0, 0}}, {10.0, {0, 1, 0}}, {20.0, {0, 0, 1}}};
    f.colourSpace = ColourSpace::step;
    EXPECT_EQ(colourAt(f, -1.0), glm::dvec3(1, 0, 0));
    EXPECT_EQ(colourAt(f, 0.0), glm::dvec3(1, 0, 0));
    EXPECT_EQ(colourAt(f, 0.1), glm::dvec3(0, 1, 0));
    EXPECT_EQ(colourAt(f, 10.0), glm::dvec3(0, 1, 0));
    EXPECT_EQ(colourAt(f, 10.1), glm::dvec3(0, 0, 1));
    EXPECT_EQ(colourAt(f, 99.0), glm::dvec3(0, 0, 1));
}

}  // namespace
}  // namespace macula
