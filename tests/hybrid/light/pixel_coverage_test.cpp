#include "pipeline/hybrid/light/pixel_coverage.h"

#include <gtest/gtest.h>

#include <numeric>

namespace macula::hybrid {
namespace {

std::vector<trace::GuidePixel> covered(const std::vector<float>& centres) {
    std::vector<trace::GuidePixel> guides(centres.size());
    for (std::size_t i = 0; i < centres.size(); ++i) guides[i].coverage = centres[i];
    return guides;
}

TEST(PixelCoverage, OfEvenMatterIsThatOfItsRays) {
    for (const float coverage : {0.0f, 0.25f, 1.0f}) {
        for (const float pixel : pixelCoverage(covered(std::vector<float>(15, coverage)), {5, 3}))
            EXPECT_FLOAT_EQ(pixel, coverage);
    }
}

// By hand: the mean over a pixel of what is bilinear between the centres.
TEST(PixelCoverage, OfOneRayIsSharedWithItsNeighbours) {
    std::vector<float> centres(5 * 4, 0.0f);
    centres[1 * 5 + 2] = 1.0f;
    const auto pixels = pixelCoverage(covered(centres), {5, 4});
    EXPECT_FLOAT_EQ(pixels[1 * 5 + 2], 0.5625f);
    EXPECT_FLOAT_EQ(pixels[1 * 5 + 1], 0.09375f);
    EXPECT_FLOAT_EQ(pixels[2 * 5 + 2], 0.09375f);
    EXPECT_FLOAT_EQ(pixels[0 * 5 + 3], 0.015625f);
    EXPECT_FLOAT_EQ(pixels[1 * 5 + 4], 0.0f);
    EXPECT_FLOAT_EQ(std::accumulate(pixels.begin(), pixels.end(), 0.0f), 1.0f);
}

TEST(PixelCoverage, AtTheEdgeOfThePictureGoesOnAsItIs) {
    EXPECT_EQ(pixelCoverage(covered({0.5f}), {1, 1}), std::vector<float>{0.5f});
    EXPECT_EQ(pixelCoverage(covered({1.0f, 0.0f}), {2, 1}), (std::vector<float>{0.875f, 0.125f}));
    EXPECT_TRUE(pixelCoverage({}, {0, 0}).empty());
    EXPECT_EQ(pixelCoverageOf(std::vector{1.0f, 0.0f}, {2, 1}), (std::vector<float>{0.875f, 0.125f}));
    EXPECT_TRUE(pixelCoverageOf({}, {0, 0}).empty());
}

}  // namespace
}  // namespace macula::hybrid
