// Errors and light against references whose noise is known. Bounds are five standard errors, worked out here
// from the noise that is put in: 6e-7 would fail by chance with other seeds.
#include "image/noisy_reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

namespace macula::image {
namespace {

constexpr int kWidth = 120;
constexpr int kHeight = 100;
constexpr std::size_t kPixels = std::size_t(kWidth) * kHeight;
const Mask kAll(kPixels, 1);

using Curve = std::function<double(double)>;

Image picture(const std::function<double(std::size_t, std::size_t)>& value) {
    Image image{
        .width = kWidth, .height = kHeight, .channels = 3, .encoding = Encoding::display, .pixels = {}};
    for (std::size_t i = 0; i < kPixels; ++i)
        for (std::size_t c = 0; c < 3; ++c) image.pixels.push_back(static_cast<float>(value(i, c)));
    return image;
}

// Without noise and before the curve: different everywhere.
double light(std::size_t pixel, std::size_t channel) {
    return 0.35 + 0.1 * std::sin(0.01 * double(pixel) + double(channel));
}

// Gaussian noise of that standard deviation in each half, put on what the curve then bends.
NoisyReference noisy(double sigma, const Curve& curve, bool alikeInAllChannels = false) {
    std::mt19937 random(11);
    std::normal_distribution<double> normal(0.0, sigma);
    std::array<std::vector<double>, 2> halves;
    for (std::vector<double>& half : halves) {
        for (std::size_t i = 0; i < kPixels; ++i) {
            double noise = normal(random);
            for (std::size_t c = 0; c < 3; ++c) {
                if (c > 0 && !alikeInAllChannels) noise = normal(random);
                half.push_back(light(i, c) + noise);
            }
        }
    }
    const auto& [a, b] = halves;
    return {.first = picture([&, &h = a](std::size_t i, std::size_t c) { return curve(h[3 * i + c]); }),
            .second = picture([&, &h = b](std::size_t i, std::size_t c) { return curve(h[3 * i + c]); }),
            .whole = picture([&, &h = a, &k = b](std::size_t i, std::size_t c) {
                return curve(0.5 * (h[3 * i + c] + k[3 * i + c]));
            })};
}
double straight(double x) {
    return x;
}

// Off by 0.03 and by 0.05, in turn.
Image offBySome(const Curve& curve) {
    return picture(
        [&](std::size_t i, std::size_t c) { return curve(light(i, c)) + (i % 2 == 0 ? 0.03 : -0.05); });
}
constexpr double kSquare = (0.03 * 0.03 + 0.05 * 0.05) / 2;

// Of the mean over `count` values: products of two differences, each e + noise, have the variance
// 2 e^2 sigma^2 + sigma^4.
double standardError(double square, double sigma, std::size_t count) {
    return std::sqrt((2 * square * sigma * sigma + std::pow(sigma, 4)) / double(count));
}

TEST(SquareErrorLessNoise, IsThatOfWhatTheReferenceConvergesTo) {
    for (const double sigma : {0.0, 0.01, 0.06}) {
        const NoisyReference reference = noisy(sigma, straight);
        const auto error = squareErrorLessNoise(reference, offBySome(straight), kAll);
        ASSERT_TRUE(error.ok() && error->has_value());
        const double chance = standardError(kSquare, sigma, 3 * kPixels);
        EXPECT_NEAR((*error)->mean, kSquare, 5 * chance + 1e-8) << sigma;
        EXPECT_NEAR((*error)->standardError, chance, 0.1 * chance + 1e-12) << sigma;
        EXPECT_NEAR(psnrOf(**error).value_or(0.0), -10.0 * std::log10(kSquare), 0.3) << sigma;
        // What a plain PSNR says is worse by the noise that is left in the whole.
        const auto plain = maskedPsnr(reference.whole, offBySome(straight), kAll);
        EXPECT_NEAR(std::pow(10.0, -0.1 * **plain), kSquare + sigma * sigma / 2, 0.03 * kSquare) << sigma;
    }
}

// Red, green and blue of a pixel come from the same paths of light: three values tell no more than one.
TEST(SquareErrorLessNoise, KnowsThatChannelsHaveTheSameNoise) {
    const double sigma = 0.06;
    const auto error = squareErrorLessNoise(noisy(sigma, straight, true), offBySome(straight), kAll);
    const double chance = standardError(kSquare, sigma, kPixels);
    EXPECT_NEAR((*error)->mean, kSquare, 5 * chance);
    EXPECT_NEAR((*error)->standardError, chance, 0.1 * chance);
}

TEST(SquareErrorLessNoise, OfTheTruthItselfIsAboutNothing) {
    const double sigma = 0.06;
    const auto error = squareErrorLessNoise(
        noisy(sigma, straight), picture([](std::size_t i, std::size_t c) { return light(i, c); }), kAll);
    EXPECT_NEAR((*error)->mean, 0.0, 5 * standardError(0.0, sigma, 3 * kPixels));
    EXPECT_FALSE(psnrOf({.mean = -1e-6, .standardError = 1e-5}).has_value());
    EXPECT_FALSE(psnrErrorOf({.mean = 0.0, .standardError = 1e-5}).has_value());
    EXPECT_NEAR(*psnrOf({.mean = 1e-3, .standardError = 1e-5}), 30.0, 1e-9);
    // A hundredth of a square is 0.0434 dB.
    EXPECT_NEAR(*psnrErrorOf({.mean = 1e-3, .standardError = 1e-5}), 0.0434, 1e-4);
}

// The root has the slope and the bend of a display's curve. Noise of 0.08 lowers its mean by 0.0044 in a
// half: products of differences alone were wrong by 0.0044^2 and, as the model is too dark everywhere, twice
// 0.0044 of its error.
TEST(SquareErrorLessNoise, LeavesOutWhatACurveMakesOfNoise) {
    const double sigma = 0.08;
    const Curve root = [](double x) { return std::sqrt(std::max(x, 0.0)); };
    const NoisyReference reference = noisy(sigma, root);
    const Image dark = picture([&](std::size_t i, std::size_t c) { return root(light(i, c)) - 0.05; });
    const auto error = squareErrorLessNoise(reference, dark, kAll);
    double product = 0.0;
    for (std::size_t i = 0; i < dark.pixels.size(); ++i)
        product += double(dark.pixels[i] - reference.first.pixels[i]) *
                   double(dark.pixels[i] - reference.second.pixels[i]) / double(dark.pixels.size());
    const double chance = standardError(0.0025, sigma / (2.0 * std::sqrt(0.35)), 3 * kPixels);
    EXPECT_GT(std::abs(product - 0.0025), 8 * chance);
    EXPECT_NEAR((*error)->mean, 0.0025, 5 * chance);
}

TEST(SquareErrorLessNoise, CountsWhatIsInTheMask) {
    const NoisyReference reference = noisy(0.0, straight);
    Mask even(kPixels, 0);
    for (std::size_t i = 0; i < kPixels; i += 2) even[i] = 1;
    EXPECT_NEAR((*squareErrorLessNoise(reference, offBySome(straight), even))->mean, 0.0009, 1e-8);
    EXPECT_FALSE(squareErrorLessNoise(reference, offBySome(straight), Mask(kPixels, 0))->has_value());
}

// The toe of the tone map is a square there, 6.25 x^2 of x below 0.08: its mean over noise is more than that
// of the mean, and from halves it is exact.
TEST(LuminanceRatioLessNoise, IsNotMovedByNoiseInAToe) {
    const double sigma = 0.1;
    const auto encoded = [](double linear) {
        return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
    };
    const Curve toe = [&](double x) { return encoded(x * x); };
    const NoisyReference reference = noisy(sigma, toe);
    double sum = 0.0;
    for (std::size_t i = 0; i < kPixels; ++i) sum += std::pow(light(i, 1), 2) / double(kPixels);
    // Green alone, or the weights of the channels would be in the bounds.
    const auto greenOf = [](Image image) {
        for (std::size_t i = 0; i < image.pixels.size(); i += 3) image.pixels[i] = image.pixels[i + 2] = 0.0f;
        return image;
    };
    const NoisyReference green{greenOf(reference.first), greenOf(reference.second), greenOf(reference.whole)};
    const Image test = greenOf(picture([&](std::size_t i, std::size_t c) { return toe(light(i, c)); }));
    const auto ratio = luminanceRatioLessNoise(green, test, kAll);
    // The product of halves that it comes to: a b, of variance 2 x^2 sigma^2 + sigma^4.
    const double chance = standardError(sum, sigma, kPixels) / sum;
    EXPECT_NEAR(**ratio, 1.0, 5 * chance);
    const double plain = lightOf(test, kAll) / lightOf(green.whole, kAll);
    EXPECT_NEAR(plain, sum / (sum + sigma * sigma / 2), 5 * chance);
    EXPECT_LT(plain, 1.0 - 7 * chance);
}

// 0.5 decodes to 0.21404, 0.25 to 0.05088 (IEC 61966-2-1).
TEST(LuminanceRatioLessNoise, IsOfTheLightThatLeavesTheScreen) {
    const auto grey = [](float value) { return picture([=](std::size_t, std::size_t) { return value; }); };
    const auto sure = [](const Image& image) { return NoisyReference{image, image, image}; };
    const auto ratio = [&](const Image& reference, const Image& test, const Mask& mask) {
        return *luminanceRatioLessNoise(sure(reference), test, mask);
    };
    EXPECT_NEAR(*ratio(grey(0.5f), grey(0.25f), kAll), 0.050876 / 0.214041, 1e-5);
    EXPECT_NEAR(*ratio(grey(0.5f), grey(0.5f), kAll), 1.0, 1e-12);
    const Image green = picture([](std::size_t, std::size_t c) { return c == 1 ? 1.0 : 0.0; });
    EXPECT_NEAR(*ratio(grey(1.0f), green, kAll), 0.7152, 1e-9);
    // Outside of the mask nothing counts.
    const Image half = picture([](std::size_t i, std::size_t) { return i < kPixels / 2 ? 0.5 : 1.0; });
    Mask first(kPixels, 0);
    std::fill_n(first.begin(), kPixels / 2, std::uint8_t{1});
    EXPECT_NEAR(*ratio(grey(0.5f), half, first), 1.0, 1e-12);
    EXPECT_FALSE(ratio(grey(0.0f), grey(0.5f), kAll).has_value());
    EXPECT_FALSE(ratio(grey(0.5f), grey(0.5f), Mask(kPixels, 0)).has_value());
}

TEST(NoiseOf, IsThatOfTheWhole) {
    const double sigma = 0.06;
    // A standard deviation of n values is wrong by its (2n)^-1/2 th part.
    const double chance = sigma / std::sqrt(2.0) / std::sqrt(2.0 * 3 * double(kPixels));
    EXPECT_NEAR(*noiseOf(noisy(sigma, straight), kAll), sigma / std::sqrt(2.0), 5 * chance);
    EXPECT_EQ(*noiseOf(noisy(sigma, straight), Mask(kPixels, 0)), 0.0);
}

TEST(NoisyReference, RefusesWhatCannotBeCompared) {
    NoisyReference reference = noisy(0.01, straight);
    const Image test = offBySome(straight);
    reference.second.pixels[7] = std::nanf("");
    EXPECT_FALSE(squareErrorLessNoise(reference, test, kAll).ok());
    EXPECT_FALSE(luminanceRatioLessNoise(reference, test, kAll).ok());
    EXPECT_FALSE(noiseOf(reference, kAll).ok());
    Image linear = test;
    linear.encoding = Encoding::linear;
    EXPECT_FALSE(squareErrorLessNoise(noisy(0.01, straight), linear, kAll).ok());
}

}  // namespace
}  // namespace macula::image
