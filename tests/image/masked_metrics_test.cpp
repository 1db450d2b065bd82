// Metrics over a mask against numbers worked out by hand.
#include "image/masked_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "image/metrics.h"

namespace macula::image {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

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
Mask leftHalf(int width = 24, int height = 20) {
    Mask mask;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) mask.push_back(x < width / 2 ? 1 : 0);
    return mask;
}
Mask onePixel(int at, int width = 24, int height = 20) {
    Mask mask(std::size_t(width * height), 0);
    mask[std::size_t(at)] = 1;
    return mask;
}

// Half of one 255th is the least that is not black.
TEST(Masks, AreOfWhatIsNotBlackInEightBits) {
    Image a = grey(0.0f, 3, 1);
    Image b = grey(0.0f, 3, 1);
    a.pixels[0] = 0.00195f;  // red of the first: too dark
    a.pixels[4] = 0.00197f;  // green of the second
    b.pixels[8] = 0.5f;      // blue of the third, in the other picture
    EXPECT_EQ(*litMask(a, b), (Mask{0, 1, 1}));
    EXPECT_EQ(*litMask(b, a), (Mask{0, 1, 1}));
    const std::vector<float> coverage{0.0f, 0.00195f, 0.00197f, 1.0f};
    EXPECT_EQ(coveredMask(coverage), (Mask{0, 0, 1, 1}));
    EXPECT_EQ(unionOf({0, 1, 0, 1}, {0, 0, 1, 1}), (Mask{0, 1, 1, 1}));
}

TEST(MaskedPsnr, CountsWhatIsInTheMask) {
    // Off by 0.1 in the left half only: 20 dB there, and half the squares over all.
    const Image reference = grey(0.5f);
    const Image test = picture(24, 20, [](int x, int, int) { return x < 12 ? 0.6f : 0.5f; });
    EXPECT_NEAR(**maskedPsnr(reference, test, leftHalf()), 20.0, 1e-5);
    EXPECT_NEAR(**maskedPsnr(reference, test, Mask(480, 1)), *psnr(reference, test), 1e-12);
    EXPECT_NEAR(*psnr(reference, test), 20.0 + 10.0 * std::log10(2.0), 1e-5);
    EXPECT_EQ(**maskedPsnr(reference, test, onePixel(23)), kInfinite);
    EXPECT_EQ(**maskedPsnr(reference, reference, leftHalf()), kInfinite);
    EXPECT_FALSE(maskedPsnr(reference, test, Mask(480, 0))->has_value());
}

// Far from the edge a uniform picture has the luminance term alone; in the corner a share of each window lies
// in the black beyond: w of its weight is left, the mean is w a, the mean of squares w a^2.
TEST(MaskedSsim, FillsWindowsUpWithBlack) {
    const double a = double(0.4f);
    const double b = double(0.6f);
    const Image reference = grey(0.4f);
    const Image test = grey(0.6f);
    const auto index = [](double w, double p, double q) {
        const double c1 = 1e-4;
        const double c2 = 9e-4;
        const double rest = w - w * w;
        return (2 * w * p * w * q + c1) * (2 * rest * p * q + c2) /
               ((w * w * (p * p + q * q) + c1) * (rest * (p * p + q * q) + c2));
    };
    EXPECT_NEAR(**maskedSsim(reference, test, onePixel(10 * 24 + 12)), index(1.0, a, b), 1e-9);
    double left = 0.0;
    double all = 0.0;
    for (int k = -5; k <= 5; ++k) {
        const double weight = std::exp(-k * k / 4.5);
        all += weight;
        if (k >= 0) left += weight;
    }
    const double share = left / all;
    EXPECT_NEAR(**maskedSsim(reference, test, onePixel(12)), index(share, a, b), 1e-9);
    EXPECT_NEAR(**maskedSsim(reference, test, onePixel(0)), index(share * share, a, b), 1e-9);
}

TEST(MaskedSsim, IsOneOfEqualsAndNothingOfNothing) {
    const Image noise =
        picture(24, 20, [](int x, int y, int c) { return float((x * 7 + y * 13 + c) % 10) / 10.0f; });
    EXPECT_NEAR(**maskedSsim(noise, noise, leftHalf()), 1.0, 1e-12);
    EXPECT_FALSE(maskedSsim(noise, noise, Mask(480, 0))->has_value());
    const Image black = grey(0.0f);
    EXPECT_NEAR(**maskedSsim(black, black, leftHalf()), 1.0, 1e-12);
}

TEST(CoverageError, IsTheMeanDifferenceInTheMask) {
    const std::vector<float> truth{0.0f, 0.5f, 1.0f, 1.0f};
    const std::vector<float> test{0.25f, 0.25f, 1.0f, 0.0f};
    EXPECT_NEAR(*coverageError(truth, test, {1, 1, 1, 0}), 0.5 / 3.0, 1e-12);
    EXPECT_NEAR(*coverageError(truth, truth, {1, 1, 1, 1}), 0.0, 1e-12);
    EXPECT_FALSE(coverageError(truth, test, {0, 0, 0, 0}).has_value());
}

TEST(MeanOf, IsOfWhatIsInTheMask) {
    const std::vector<float> values{1.0f, 2.0f, 4.0f, 8.0f};
    EXPECT_EQ(**meanOf(values, {1, 0, 255, 0}), 2.5);
    EXPECT_EQ(**meanOf(values, {1, 1, 1, 1}), 3.75);
    EXPECT_FALSE(meanOf(values, {0, 0, 0, 0})->has_value());
    EXPECT_FALSE(meanOf({}, {})->has_value());
    EXPECT_EQ(meanOf(values, {1, 1, 1}).error().code, ErrorCode::usage);
    EXPECT_EQ(meanOf(std::vector<float>{1.0f, std::nanf("")}, {1, 0}).error().code, ErrorCode::usage);
}

// As numpy.percentile gives them.
TEST(Percentile, IsLinearBetweenNeighbours) {
    EXPECT_NEAR(percentile({4, 1, 3, 2}, 0.1), 1.3, 1e-12);
    EXPECT_NEAR(percentile({4, 1, 3, 2}, 0.5), 2.5, 1e-12);
    EXPECT_NEAR(percentile({4, 1, 3, 2}, 0.9), 3.7, 1e-12);
    EXPECT_EQ(percentile({7}, 0.9), 7.0);
    EXPECT_EQ(percentile({3, 1, 2}, 0.0), 1.0);
    EXPECT_EQ(percentile({3, 1, 2}, 1.0), 3.0);
    EXPECT_EQ(percentile({1, kInfinite, kInfinite}, 0.0), 1.0);
    EXPECT_EQ(percentile({1, kInfinite, kInfinite}, 0.9), kInfinite);
}

TEST(MaskedMetrics, RefuseWhatCannotBeCompared) {
    EXPECT_FALSE(litMask(grey(0.5f), grey(0.5f, 23)).ok());
    EXPECT_FALSE(maskedPsnr(grey(0.5f), grey(std::nanf("")), leftHalf()).ok());
    Image linear = grey(0.5f);
    linear.encoding = Encoding::linear;
    EXPECT_FALSE(maskedSsim(grey(0.5f), linear, leftHalf()).ok());
}

}  // namespace
}  // namespace macula::image
