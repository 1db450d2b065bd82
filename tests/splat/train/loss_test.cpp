// The loss in double: against closed forms, central differences, and what a gradient is for.
#include <gtest/gtest.h>

#include <limits>

#include "splat/train/loss_pictures.h"

namespace macula::splat {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double ssimOf(double mx, double my, double xx, double yy, double xy) {
    return (2 * mx * my + 1e-4) * (2 * xy + 9e-4) / ((mx * mx + my * my + 1e-4) * (xx + yy + 9e-4));
}

TEST(Loss, OfEvenPicturesIsThatOfTheirValues) {
    // Over the background: 0.2 + 0.5 b and 0.4 + 0.25 b, coverage 0.5 and 0.75.
    const LossStep step{.background = {0.0f, 0.5f, 1.0f}, .viewWeight = 2.0f};
    const auto result = referenceLoss(9, 13, filled(9, 13, {0.2, 0.2, 0.2, 0.5}),
                                      filled(9, 13, {0.4, 0.4, 0.4, 0.75}), {}, step);
    const double x[] = {0.2, 0.45, 0.7, 0.5};
    const double y[] = {0.4, 0.525, 0.65, 0.75};
    double l1 = 0.0;
    double dssim = 0.0;
    for (int c = 0; c < 4; ++c) {
        l1 += std::abs(x[c] - y[c]) / 4;
        dssim += (1.0 - ssimOf(x[c], y[c], 0, 0, 0)) / 4;
    }
    EXPECT_NEAR(result.l1, l1, 1e-12);
    EXPECT_NEAR(result.dssim, dssim, 1e-12);
    EXPECT_NEAR(result.loss, 2.0 * (0.8 * l1 + 0.2 * dssim), 1e-7);  // options are float
}

// Two pixels: the window around one has the weights p for itself and 1 - p for the other.
TEST(Loss, OfTwoPixelsHasTheSsimOfAWindowCutByTheBorder) {
    const double p = 1.0 / (1.0 + std::exp(-1.0 / (2.0 * 1.5 * 1.5)));
    const double x[] = {0.9, 0.2};
    const double y[] = {0.3, 0.4};
    const auto grey = [](double v) { return glm::dvec4(v, v, v, 0.25); };
    const auto result =
        referenceLoss(2, 1, Pixels{grey(x[0]), grey(x[1])}, Pixels{grey(y[0]), grey(y[1])}, {}, {});
    double ssim = 0.0;
    for (int i = 0; i < 2; ++i) {
        const double spread = p * (1 - p);
        ssim += 0.5 * ssimOf(p * x[i] + (1 - p) * x[1 - i], p * y[i] + (1 - p) * y[1 - i],
                             spread * (x[0] - x[1]) * (x[0] - x[1]), spread * (y[0] - y[1]) * (y[0] - y[1]),
                             spread * (x[0] - x[1]) * (y[0] - y[1]));
    }
    EXPECT_NEAR(result.dssim, 0.75 * (1.0 - ssim), 1e-12);  // the coverages are equal
    EXPECT_NEAR(result.l1, 0.75 * (0.6 + 0.2) / 2.0, 1e-12);
}

TEST(Loss, OfEqualPicturesIsNothingAndWantsNothing) {
    for (const LossEncoding encode : {LossEncoding::none, LossEncoding::display}) {
        const Pixels picture = randomPicture(17, 12, 3);
        const auto result =
            referenceLoss(17, 12, picture, picture, {.encode = encode}, {.background = {1, 0, 1}});
        EXPECT_EQ(result.l1, 0.0);
        EXPECT_NEAR(result.dssim, 0.0, 1e-15);
        EXPECT_LT(largest(result.gradient), 1e-15);
    }
}

TEST(Loss, GradientsAreThoseOfCentralDifferences) {
    for (const glm::ivec2 size : {glm::ivec2(1, 1), {1, 9}, {7, 5}, {14, 13}}) {
        const int width = size.x;
        const int height = size.y;
        for (const LossEncoding encode : {LossEncoding::none, LossEncoding::display}) {
            for (const float dssim : {0.0f, 0.2f, 1.0f}) {
                const auto seed = static_cast<std::uint32_t>(width * 8 + height);
                const LossOptions options{.dssimWeight = dssim, .encode = encode, .exposure = 1.3f};
                const LossStep step{.background = randomBackground(seed), .viewWeight = 1.7f};
                Pixels render = randomPicture(width, height, seed);
                const Pixels target = randomPicture(width, height, seed + 1);
                const auto loss = [&] {
                    return referenceLoss(width, height, render, target, options, step).loss;
                };
                const Pixels gradient = referenceLoss(width, height, render, target, options, step).gradient;
                const double scale = largest(gradient);
                ASSERT_GT(scale, 0.0);
                for (std::size_t i = 0; i < render.size(); ++i) {
                    if (atKink(render[i], target[i], options, step, 1e-5)) continue;
                    for (int c = 0; c < 4; ++c) {
                        const double value = render[i][c];
                        const double h = 1e-6;
                        render[i][c] = value + h;
                        const double above = loss();
                        render[i][c] = value - h;
                        const double below = loss();
                        render[i][c] = value;
                        EXPECT_NEAR((above - below) / (2 * h), gradient[i][c], 1e-3 * scale)
                            << width << " x " << height << " dssim " << dssim << " pixel " << i << " " << c;
                    }
                }
            }
        }
    }
}

// Of the colours that are compared by those over the background: by central differences.
glm::dmat3 derivativeAt(const glm::dvec3& over, const LossOptions& options) {
    const double h = 1e-6;
    glm::dmat3 derivative(0.0);
    for (int by = 0; by < 3; ++by) {
        const auto at = [&](double step) {
            glm::dvec4 moved(over, 1.0);
            moved[by] += step;
            return glm::dvec3(referenceCompared(moved, options, glm::dvec3(0.0)));
        };
        derivative[by] = (at(h) - at(-h)) / (2 * h);
    }
    return derivative;
}

TEST(Loss, OfSquaresHasTheGradientOfItsSquaresWhileTheDisplayStands) {
    for (const LossEncoding encode : {LossEncoding::none, LossEncoding::display}) {
        const LossOptions options{.encode = encode, .exposure = 1.0f};
        const LossStep step{
            .measure = LossMeasure::squared, .background = {0.3f, 0.8f, 0.5f}, .viewWeight = 1.7f};
        const glm::dvec3 background(step.background);
        const Pixels render = randomPicture(7, 5, 21);
        const Pixels target = randomPicture(7, 5, 22);
        const ReferenceLoss result = referenceLoss(7, 5, render, target, options, step);
        double sum = 0.0;
        for (std::size_t i = 0; i < render.size(); ++i) {
            const auto over = [&](const glm::dvec4& p) { return glm::dvec3(p) + (1.0 - p.w) * background; };
            const glm::dmat3 derivative = derivativeAt(over(render[i]), options);
            const auto squares = [&](const glm::dvec4& pixel) {
                const glm::dvec3 off = derivative * (over(pixel) - over(target[i]));
                const double coverage = pixel.w - target[i].w;
                return double(step.viewWeight) * 5.0 * (glm::dot(off, off) + coverage * coverage) /
                       (4.0 * 35.0);
            };
            sum += squares(render[i]);
            for (int c = 0; c < 4; ++c) {
                const double h = 1e-5;
                glm::dvec4 above = render[i];
                glm::dvec4 below = render[i];
                above[c] += h;
                below[c] -= h;
                EXPECT_NEAR((squares(above) - squares(below)) / (2 * h), result.gradient[i][c],
                            1e-5 * largest(result.gradient));
            }
        }
        EXPECT_NEAR(result.loss, sum, 1e-6 * sum);
        EXPECT_EQ(result.dssim, 0.0);
    }
}

// What single pictures say is noise; what all of them say together is the light there is. Absolute
// differences would rest at the median, which is far darker.
TEST(Loss, OfSquaresRestsAtTheMeanOfNoisyLight) {
    const LossOptions options{.encode = LossEncoding::display};
    Pixels noisy;
    glm::dvec4 mean(0.0);
    for (int i = 0; i < 64; ++i) {
        const double light = std::pow(i / 63.0, 6.0) * 3.0;
        noisy.emplace_back(light, 0.8 * light, 0.5 * light, 0.9);
        mean += noisy.back() / 64.0;
    }
    const auto pullOf = [&](LossMeasure measure) {
        glm::dvec4 sum(0.0);
        double most = 0.0;
        for (const glm::dvec4& pixel : noisy) {
            const auto result =
                referenceLoss(1, 1, Pixels{mean}, Pixels{pixel}, options, {.measure = measure});
            sum += result.gradient[0];
            most += std::abs(result.gradient[0].x);
        }
        return sum.x / most;
    };
    EXPECT_NEAR(pullOf(LossMeasure::squared), 0.0, 1e-12);
    EXPECT_GT(pullOf(LossMeasure::absolute), 0.2);
}

TEST(Loss, CoverageThatIsTooThinOverABrightBackgroundIsPushedUp) {
    for (const LossEncoding encode : {LossEncoding::none, LossEncoding::display}) {
        const LossStep bright{.background = {1, 1, 1}};
        // Dark matter, too thin: it would be lighter than it is, by what shines through.
        const auto thin = referenceLoss(12, 12, filled(12, 12, {0.02, 0.02, 0.02, 0.3}),
                                        filled(12, 12, {0.05, 0.05, 0.05, 1.0}), {.encode = encode}, bright);
        const auto thick = referenceLoss(12, 12, filled(12, 12, {0.05, 0.05, 0.05, 1.0}),
                                         filled(12, 12, {0.02, 0.02, 0.02, 0.3}), {.encode = encode}, bright);
        // The same where only the composite is looked at: coverage itself is right in these.
        const auto ofColour = referenceLoss(12, 12, filled(12, 12, {0.3, 0.3, 0.3, 0.5}),
                                            filled(12, 12, {0.1, 0.1, 0.1, 0.5}), {.encode = encode}, bright);
        for (std::size_t i = 0; i < thin.gradient.size(); ++i) {
            EXPECT_LT(thin.gradient[i].w, 0.0);
            EXPECT_GT(thick.gradient[i].w, 0.0);
            EXPECT_LT(ofColour.gradient[i].w, 0.0);
            EXPECT_GT(ofColour.gradient[i].x, 0.0);
        }
    }
}

TEST(Loss, TellsWhatIsTooBrightForTheDisplayHowBrightItIs) {
    const LossOptions options{.encode = LossEncoding::display};
    const Pixels target = filled(1, 1, {0.5, 0.5, 0.5, 1});
    double before = 0.0;
    for (const double bright : {0.8, 1.0, 3.0, 10.0, 1e3, 1e5, 1e8}) {
        const auto result =
            referenceLoss(1, 1, filled(1, 1, {bright, bright, bright, 1}), target, options, {});
        EXPECT_GT(result.gradient[0].x, 1e-3 / (bright + 1)) << bright;
        EXPECT_GE(result.loss, before) << bright;  // 1e8 is beyond the bound
        EXPECT_GT(result.gradient[0].x * bright, 0.0);
        before = result.loss;
    }
    // Black, where the tone map is flat, and below.
    for (const double dark : {0.0, -0.5}) {
        const auto result = referenceLoss(1, 1, filled(1, 1, {dark, dark, dark, 1}), target, options, {});
        EXPECT_LT(result.gradient[0].x, -1e-3) << dark;
        EXPECT_EQ(result.gradient[0].x, result.gradient[0].y);  // what is grey stays grey
        EXPECT_EQ(result.gradient[0].x, result.gradient[0].z);
    }
}

TEST(Loss, OfDisplayIsNearlyWhatADisplayShows) {
    // Grey 0.5, between toe and shoulder: tone-mapped 0.46, encoded by the formula of sRGB.
    const double shown = 1.055 * std::pow(0.46, 1.0 / 2.4) - 0.055;
    const glm::dvec4 value = referenceCompared({0.125, 0.125, 0.125, 1.0},
                                               {.encode = LossEncoding::display, .exposure = 4.0f}, {});
    EXPECT_NEAR(value.x, 0.95 * shown + 0.05 * std::log(1.5), 1e-9);
    EXPECT_EQ(value.w, 1.0);
}

TEST(Loss, UnknownPixelsOfTheTargetSayNothing) {
    const Pixels render = randomPicture(13, 9, 5);
    Pixels target = randomPicture(13, 9, 6);
    const std::size_t hole = 4 * 13 + 6;
    for (const double bad : {kNan, kInfinity, -kInfinity}) {
        target[hole] = {0.5, bad, 0.5, 1.0};
        const LossStep step{.background = {0.5f, 0.2f, 0.9f}};
        const auto result = referenceLoss(13, 9, render, target, {}, step);
        EXPECT_EQ(result.unknownPixels, 1u);
        EXPECT_TRUE(std::isfinite(result.loss));
        EXPECT_EQ(result.gradient[hole], glm::dvec4(0.0));
        EXPECT_GT(largest(result.gradient), 0.0);
        Pixels other = render;
        other[hole] = glm::dvec4(3.0);
        const auto same = referenceLoss(13, 9, other, target, {}, step);
        EXPECT_EQ(same.loss, result.loss);  // and no window sees it
        EXPECT_EQ(same.gradient, result.gradient);
    }
    const auto nothing = referenceLoss(13, 9, render, filled(13, 9, glm::dvec4(kNan)), {}, {});
    EXPECT_EQ(nothing.loss, 0.0);
    EXPECT_EQ(largest(nothing.gradient), 0.0);
}

TEST(Loss, ARenderThatIsNotFiniteIsCountedAndHarmsNoOther) {
    Pixels render = randomPicture(13, 9, 7);
    const Pixels target = randomPicture(13, 9, 8);
    render[50] = target[50];
    const auto right = referenceLoss(13, 9, render, target, {}, {});
    render[50] = glm::dvec4(0.1, 0.1, 0.1, kNan);
    auto bad = referenceLoss(13, 9, render, target, {}, {});
    EXPECT_EQ(right.badRendered, 0u);
    EXPECT_EQ(bad.badRendered, 1u);
    EXPECT_EQ(bad.loss, right.loss);
    EXPECT_EQ(bad.gradient[50], glm::dvec4(0.0));
    bad.gradient[50] = right.gradient[50];
    EXPECT_EQ(bad.gradient, right.gradient);
}

TEST(Downsample, KeepsTheMeanOfAnySize) {
    const glm::ivec2 sizes[][2] = {{{7, 5}, {4, 3}}, {{8, 6}, {4, 3}},  {{1, 1}, {1, 1}},
                                   {{1, 9}, {1, 5}}, {{10, 3}, {3, 3}}, {{31, 17}, {5, 16}}};
    for (const auto& [from, to] : sizes) {
        const Pixels picture = randomPicture(from.x, from.y, 11);
        const Pixels smaller = referenceDownsample(picture, from, to);
        ASSERT_EQ(smaller.size(), std::size_t(to.x * to.y));
        glm::dvec4 mean(0.0);
        for (const glm::dvec4& pixel : picture) mean += pixel / double(picture.size());
        for (const glm::dvec4& pixel : smaller) mean -= pixel / double(smaller.size());
        EXPECT_LT(largest({mean}), 1e-12) << from.x << " x " << from.y;
    }
}

TEST(Downsample, IsTheMeanOverThePixelsArea) {
    const auto grey = [](double v) { return glm::dvec4(v, v, v, 1.0); };
    const Pixels three = referenceDownsample(Pixels{grey(0), grey(3), grey(9)}, {3, 1}, {2, 1});
    EXPECT_NEAR(three[0].x, (0.0 + 0.5 * 3.0) / 1.5, 1e-12);
    EXPECT_NEAR(three[1].x, (0.5 * 3.0 + 9.0) / 1.5, 1e-12);
    const Pixels holed = referenceDownsample(Pixels{grey(1), grey(kNan), grey(3), grey(6)}, {2, 2}, {1, 1});
    EXPECT_NEAR(holed[0].x, 10.0 / 3.0, 1e-12);
    EXPECT_FALSE(
        std::isfinite(referenceDownsample(Pixels{grey(kNan), grey(kInfinity)}, {2, 1}, {1, 1})[0].x));
}

}  // namespace
}  // namespace macula::splat
