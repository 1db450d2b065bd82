// Metrics against numbers worked out by hand, and against what a metric must be.
#include "image/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace macula::image {
namespace {

Image picture(int width, int height, const std::function<float(int, int, int)>& value) {
    Image image{.width = width, .height = height, .channels = 3, .encoding = Encoding::display, .pixels = {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) image.pixels.push_back(value(x, y, c));
    return image;
}
Image grey(float value, int width = 24, int height = 20) {
    return picture(width, height, [=](int, int, int) { return value; });
}

TEST(Psnr, IsThatOfTheMeanSquaredError) {
    EXPECT_NEAR(*psnr(grey(0.5f), grey(0.6f)), 20.0, 1e-5);
    EXPECT_NEAR(*psnr(grey(0.0f), grey(1.0f)), 0.0, 1e-12);
    EXPECT_EQ(*psnr(grey(0.3f), grey(0.3f)), std::numeric_limits<double>::infinity());
    // One channel of three off by 0.3: a mean of 0.03.
    const Image red = picture(24, 20, [](int, int, int c) { return c == 0 ? 0.8f : 0.5f; });
    EXPECT_NEAR(*psnr(grey(0.5f), red), -10.0 * std::log10(0.03), 1e-5);
}

TEST(Ssim, OfUniformPicturesIsTheLuminanceTerm) {
    const double a = 0.4f;
    const double b = 0.6f;
    EXPECT_NEAR(*ssim(grey(0.4f), grey(0.6f)), (2 * a * b + 1e-4) / (a * a + b * b + 1e-4), 1e-9);
    const Image noise =
        picture(24, 20, [](int x, int y, int c) { return float((x * 7 + y * 13 + c) % 10) / 10.0f; });
    EXPECT_NEAR(*ssim(noise, noise), 1.0, 1e-12);
}

// Negative correlation: x and 1 - x about the same mean give nearly -1 where the variance is far above C2.
TEST(Ssim, OfANegativeIsNegative) {
    const Image checks = picture(32, 32, [](int x, int y, int) { return (x + y) % 2 == 0 ? 0.1f : 0.9f; });
    const Image negative = picture(32, 32, [](int x, int y, int) { return (x + y) % 2 == 0 ? 0.9f : 0.1f; });
    EXPECT_LT(*ssim(checks, negative), -0.95);
}

// Uniform pictures have no features, and the filters keep them: what is left is the colour difference, by
// hand from CIELAB. Black and white: (100^0.7) over the knee at 0.4 of 203.16^0.7.
TEST(Flip, OfUniformPicturesIsTheColourDifference) {
    EXPECT_NEAR(flip(grey(0.0f), grey(1.0f))->mean, 0.9674, 2e-4);
    EXPECT_EQ(flip(grey(0.37f), grey(0.37f))->mean, 0.0);
    // Grey of lightness 50 against black: 50^0.7 / (0.4 * 203.16^0.7) * 0.95.
    const auto encodedOfLightness50 = float(1.055 * std::pow(std::pow(66.0 / 116.0, 3.0), 1 / 2.4) - 0.055);
    const double largest = std::pow(203.16, 0.7);
    EXPECT_NEAR(flip(grey(0.0f), grey(encodedOfLightness50))->mean,
                0.95 * std::pow(50.0, 0.7) / (0.4 * largest), 5e-4);
    // Green against blue are the farthest of all.
    const Image green = picture(24, 20, [](int, int, int c) { return c == 1 ? 1.0f : 0.0f; });
    const Image blue = picture(24, 20, [](int, int, int c) { return c == 2 ? 1.0f : 0.0f; });
    EXPECT_NEAR(flip(green, blue)->mean, 1.0, 1e-9);
}

TEST(Flip, IsSymmetricAndLocalAndGrowsWithTheDifference) {
    const auto spot = [](float value) {
        return picture(64, 64, [=](int x, int y, int) { return x == 32 && y == 32 ? value : 0.5f; });
    };
    const auto small = flip(grey(0.5f, 64, 64), spot(0.6f));
    const auto large = flip(grey(0.5f, 64, 64), spot(0.9f));
    EXPECT_GT(small->mean, 0.0);
    EXPECT_GT(large->mean, small->mean);
    EXPECT_NEAR(flip(spot(0.9f), grey(0.5f, 64, 64))->mean, large->mean, 1e-12);
    EXPECT_LT(large->perPixel[0], 1e-6f);  // farther than any filter reaches
    const auto most = std::max_element(large->perPixel.begin(), large->perPixel.end());
    EXPECT_EQ(most - large->perPixel.begin(), 32 * 64 + 32);
    // From afar a fine chequer looks like its mean, a coarse one does not.
    const auto checks = [](int size) {
        return picture(64, 64,
                       [=](int x, int y, int) { return (x / size + y / size) % 2 == 0 ? 0.45f : 0.55f; });
    };
    EXPECT_LT(flip(grey(0.5f, 64, 64), checks(1), {.pixelsPerDegree = 200})->mean,
              0.5 * flip(grey(0.5f, 64, 64), checks(16), {.pixelsPerDegree = 200})->mean);
}

// An edge and a line count for more than their colour: in the middle of an edge, which is no line, and in
// that of a line, which is no edge. Both are as wide as what an eye is drawn to.
TEST(Flip, AnEdgeAndALineCountForMoreThanTheirColour) {
    constexpr int kSide = 65;
    constexpr std::size_t kMiddle = 32 * kSide + 32;
    const Image dark = grey(0.4f, kSide, kSide);
    const float ofColour = flip(dark, grey(0.5f, kSide, kSide))->perPixel[kMiddle];
    const Image edge = picture(kSide, kSide, [](int x, int, int) {
        return 0.5f + 0.1f * float(std::tanh(0.5 * (x - 32)));  // 0.5 in the middle
    });
    EXPECT_GT(flip(dark, edge)->perPixel[kMiddle], 1.2f * ofColour);
    const Image line = picture(kSide, kSide, [](int x, int, int) {
        return 0.4f + 0.1f * float(std::exp(-std::pow((x - 32) / 3.0, 2.0)));  // and less around it
    });
    EXPECT_GT(flip(dark, line)->perPixel[kMiddle], 1.2f * ofColour);
}

TEST(Metrics, OfPicturesThatCannotBeComparedAreErrors) {
    Image linear = grey(0.5f);
    linear.encoding = Encoding::linear;
    Image broken = grey(0.5f);
    broken.pixels[7] = std::numeric_limits<float>::quiet_NaN();
    for (const Image& wrong : {Image{}, grey(0.5f, 3, 3), linear, broken}) {
        EXPECT_EQ(psnr(grey(0.5f), wrong).error().code, ErrorCode::usage);
        EXPECT_EQ(ssim(grey(0.5f), wrong).error().code, ErrorCode::usage);
        EXPECT_EQ(flip(grey(0.5f), wrong).error().code, ErrorCode::usage);
    }
    EXPECT_FALSE(flip(grey(0.5f), grey(0.4f), {.pixelsPerDegree = 0}).ok());
    // One pixel, and one line, are pictures too; what is out of range is clamped.
    EXPECT_NEAR(flip(grey(0.0f, 1, 1), grey(7.0f, 1, 1))->mean, 0.9674, 2e-4);
    EXPECT_NEAR(*ssim(grey(0.2f, 1, 40), grey(0.2f, 1, 40)), 1.0, 1e-12);
}

}  // namespace
}  // namespace macula::image
