// MS-SSIM against a plain one of loops, and against numbers worked out by hand.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "image/metrics.h"

namespace macula::image {
namespace {

Image picture(int width, int height, int channels, const std::function<double(int, int, int)>& value) {
    Image image{
        .width = width, .height = height, .channels = channels, .encoding = Encoding::display, .pixels = {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < channels; ++c) image.pixels.push_back(static_cast<float>(value(x, y, c)));
    return image;
}
Image grey(float value, int width = 176, int height = 176) {
    return picture(width, height, 3, [=](int, int, int) { return value; });
}
// Waves of all lengths: every scale has something.
Image waves(int width, int height, int channels, double shift, double contrast) {
    return picture(width, height, channels, [=](int x, int y, int c) {
        const double wave = std::sin(0.9 * x + shift) + std::sin(0.11 * y - 0.05 * x + c + 2 * shift) +
                            std::sin(0.02 * (x + y) + shift);
        return 0.5 + contrast * wave / 6.0;
    });
}

using Rows = std::vector<std::vector<double>>;

struct Means {
    double whole = 0.0;
    double contrastStructure = 0.0;
};

// One window of 11 x 11 after the other, squares of differences from its mean.
Means meansByLoops(const Rows& a, const Rows& b) {
    const int height = static_cast<int>(a.size());
    const int width = static_cast<int>(a[0].size());
    double weights[11][11];
    double total = 0.0;
    for (int j = 0; j < 11; ++j)
        for (int i = 0; i < 11; ++i)
            total += weights[j][i] = std::exp(-((i - 5) * (i - 5) + (j - 5) * (j - 5)) / (2 * 1.5 * 1.5));
    Means sum;
    for (int y = 0; y + 11 <= height; ++y) {
        for (int x = 0; x + 11 <= width; ++x) {
            const auto mean = [&](const std::function<double(double, double)>& of) {
                double result = 0.0;
                for (int j = 0; j < 11; ++j)
                    for (int i = 0; i < 11; ++i)
                        result += weights[j][i] / total *
                                  of(a[std::size_t(y + j)][std::size_t(x + i)],
                                     b[std::size_t(y + j)][std::size_t(x + i)]);
                return result;
            };
            const double ma = mean([](double p, double) { return p; });
            const double mb = mean([](double, double q) { return q; });
            const double va = mean([=](double p, double) { return (p - ma) * (p - ma); });
            const double vb = mean([=](double, double q) { return (q - mb) * (q - mb); });
            const double vab = mean([=](double p, double q) { return (p - ma) * (q - mb); });
            const double cs = (2 * vab + 0.0009) / (va + vb + 0.0009);
            sum.contrastStructure += cs;
            sum.whole += cs * (2 * ma * mb + 0.0001) / (ma * ma + mb * mb + 0.0001);
        }
    }
    const double count = double(height - 10) * double(width - 10);
    return {sum.whole / count, sum.contrastStructure / count};
}

// Odd sides grow by a copy of the last row or column first.
Rows halvedByLoops(Rows rows) {
    if (rows.size() % 2 == 1) rows.push_back(rows.back());
    for (auto& row : rows)
        if (row.size() % 2 == 1) row.push_back(row.back());
    Rows half(rows.size() / 2, std::vector<double>(rows[0].size() / 2));
    for (std::size_t y = 0; y < rows.size(); ++y)
        for (std::size_t x = 0; x < rows[0].size(); ++x) half[y / 2][x / 2] += rows[y][x] / 4;
    return half;
}

double byLoops(const Image& reference, const Image& test) {
    const auto channel = [](const Image& image, int c) {
        Rows rows(std::size_t(image.height), std::vector<double>(std::size_t(image.width)));
        for (std::size_t y = 0; y < rows.size(); ++y)
            for (std::size_t x = 0; x < rows[0].size(); ++x)
                rows[y][x] = double(
                    image.pixels[(y * rows[0].size() + x) * std::size_t(image.channels) + std::size_t(c)]);
        return rows;
    };
    double sum = 0.0;
    for (int c = 0; c < reference.channels; ++c) {
        Rows a = channel(reference, c);
        Rows b = channel(test, c);
        double result = 1.0;
        for (const double weight : {0.0448, 0.2856, 0.3001, 0.2363}) {
            result *= std::pow(meansByLoops(a, b).contrastStructure, weight);
            a = halvedByLoops(a);
            b = halvedByLoops(b);
        }
        sum += result * std::pow(meansByLoops(a, b).whole, 0.1333);
    }
    return sum / reference.channels;
}

TEST(MsSsim, IsThatOfPlainLoops) {
    // 187 is odd at the first two scales, 180 at the third.
    const double grey = *msSsim(waves(187, 180, 1, 0.0, 1.0), waves(187, 180, 1, 0.4, 0.7));
    EXPECT_NEAR(grey, byLoops(waves(187, 180, 1, 0.0, 1.0), waves(187, 180, 1, 0.4, 0.7)), 1e-9);
    EXPECT_GT(grey, 0.05);
    EXPECT_LT(grey, 0.95);
    EXPECT_NEAR(*msSsim(waves(176, 176, 3, 0.0, 1.0), waves(176, 176, 3, 0.2, 0.6)),
                byLoops(waves(176, 176, 3, 0.0, 1.0), waves(176, 176, 3, 0.2, 0.6)), 1e-9);
}

TEST(MsSsim, OfEqualPicturesIsOne) {
    for (const int channels : {1, 3}) {
        const Image image = waves(200, 180, channels, 0.3, 1.0);
        EXPECT_NEAR(*msSsim(image, image), 1.0, 1e-12);
    }
    EXPECT_NEAR(*msSsim(grey(0.0f), grey(0.0f)), 1.0, 1e-12);
}

// Nothing but luminance differs, and that counts at the last scale only.
TEST(MsSsim, OfUniformPicturesIsTheLuminanceTerm) {
    const auto expected = [](double a, double b) {
        return std::pow((2 * a * b + 1e-4) / (a * a + b * b + 1e-4), 0.1333);
    };
    EXPECT_NEAR(*msSsim(grey(0.4f), grey(0.6f)), expected(double(0.4f), double(0.6f)), 1e-9);
    EXPECT_NEAR(*msSsim(grey(0.0f), grey(1.0f)), expected(0.0, 1.0), 1e-9);
    EXPECT_NEAR(*msSsim(grey(0.0f), grey(7.0f)), expected(0.0, 1.0), 1e-9);  // clamped
}

// One channel of three is a uniform other one: the mean of 1, 1 and its term.
TEST(MsSsim, IsTheMeanOverChannels) {
    const Image red = picture(176, 176, 3, [](int, int, int c) { return c == 0 ? 0.75 : 0.5; });
    const double term = std::pow((2 * 0.75 * 0.5 + 1e-4) / (0.75 * 0.75 + 0.25 + 1e-4), 0.1333);
    EXPECT_NEAR(*msSsim(grey(0.5f), red), (2.0 + term) / 3.0, 1e-9);
}

// Opposite structure at the finest scale, whose mean is uniform at the others: a power of a negative number
// would be none.
TEST(MsSsim, OfANegativeIsZero) {
    const auto checks = [](double even) {
        return picture(176, 176, 1, [=](int x, int y, int) { return (x + y) % 2 == 0 ? even : 1.0 - even; });
    };
    EXPECT_EQ(*msSsim(checks(0.1), checks(0.9)), 0.0);
}

TEST(MsSsim, TellsWhichSizeItNeeds) {
    EXPECT_TRUE(msSsim(grey(0.5f, 176, 176), grey(0.5f, 176, 176)).ok());
    for (const auto& [width, height] : {std::array{175, 300}, std::array{300, 175}, std::array{1, 1}}) {
        const auto small = msSsim(grey(0.5f, width, height), grey(0.5f, width, height));
        ASSERT_FALSE(small.ok());
        EXPECT_EQ(small.error().code, ErrorCode::usage);
        EXPECT_NE(small.error().hint.english().find("176"), std::string::npos);
    }
}

TEST(MsSsim, RefusesWhatCannotBeCompared) {
    Image linear = grey(0.5f);
    linear.encoding = Encoding::linear;
    Image broken = grey(0.5f);
    broken.pixels[7] = std::numeric_limits<float>::quiet_NaN();
    for (const Image& wrong : {Image{}, grey(0.5f, 177), waves(176, 176, 1, 0.0, 1.0), linear, broken}) {
        EXPECT_EQ(msSsim(grey(0.5f), wrong).error().code, ErrorCode::usage);
        EXPECT_EQ(msSsim(wrong, grey(0.5f)).error().code, ErrorCode::usage);
    }
}

}  // namespace
}  // namespace macula::image
