// The native kernels of the loss are the reference in double.
#include "pipeline/splat/native/native_loss.h"

#include <array>
#include <cmath>
#include <limits>

#include "shared/splat_loss_params.h"
#include "splat/native/native_pictures.h"
#include "splat/train/loss_pictures.h"

namespace macula::splat {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool isKnown(const glm::vec4& pixel) {
    return isFinite(glm::dvec4(pixel));
}

// As loss_windows.comp, in float: in the picture of one pixel variances are all rounding.
std::vector<float> windowsOf(int width, int height, const std::vector<glm::vec4>& target) {
    constexpr std::array<float, 6> kTaps{0.26601172486179436f, 0.2130055377112537f,   0.10936068950970002f,
                                         0.03600077212843083f, 0.007598758135239185f, 0.00102838008447911f};
    std::vector<float> windows(target.size());
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            float known = 0.0f;
            for (int u = std::max(0, x - 5); u < std::min(width, x + 6); ++u) {
                float column = 0.0f;
                for (int v = std::max(0, y - 5); v < std::min(height, y + 6); ++v)
                    if (isKnown(target[std::size_t(v * width + u)]))
                        column += kTaps[std::size_t(std::abs(v - y))];
                known += kTaps[std::size_t(std::abs(u - x))] * column;
            }
            const auto at = std::size_t(y * width + x);
            windows[at] = isKnown(target[at]) ? 1.0f / known : 0.0f;
        }
    }
    return windows;
}

struct NativeLoss {
    double loss = 0.0;
    double l1 = 0.0;
    double dssim = 0.0;
    double badRendered = 0.0;
    std::vector<glm::vec4> gradient;
};

// As Loss::record (loss.cpp).
NativeLoss run(int width, int height, const Pixels& render, const Pixels& target, const LossOptions& options,
               const LossStep& step) {
    std::vector<glm::vec4> rendered(render.begin(), render.end());
    std::vector<glm::vec4> targets(target.begin(), target.end());
    std::vector<float> windows = windowsOf(width, height, targets);
    const bool display = options.encode == LossEncoding::display;
    const bool squared = step.measure == LossMeasure::squared;
    const float weight = step.measure == LossMeasure::similar ? options.dssimWeight : 0.0f;
    const auto pixels = rendered.size();
    const float share = step.viewWeight / (4.0f * static_cast<float>(pixels));
    const auto columns = static_cast<std::uint32_t>((width + 15) / 16);
    const auto rows = static_cast<std::uint32_t>((height + 15) / 16);
    std::vector<shared::SplatLossParams> params{{.imageSize = {width, height},
                                                 .background = step.background,
                                                 .exposure = display ? options.exposure : 1.0f,
                                                 .l1Scale = squared ? 0.0f : share * (1.0f - weight),
                                                 .dssimScale = share * weight,
                                                 .squareScale = squared ? kSquaresWeight * share : 0.0f,
                                                 .partCount = columns * rows,
                                                 .coverageOnly = step.coverageOnly ? 1u : 0u}};
    std::vector<glm::vec4> pairs(2 * pixels), terms(3 * pixels + 1, glm::vec4(7.0f));
    std::vector<float> ssimParts(std::size_t(columns) * rows);
    std::vector<glm::vec4> parts(ssimParts.size());
    NativeLoss result;
    result.gradient.assign(pixels + 1, glm::vec4(7.0f));

    gpu::NativeDispatch compared({columns, rows, 1}, {});
    bindTo(compared, 0, params);
    bindTo(compared, 1, rendered);
    bindTo(compared, 2, targets);
    bindTo(compared, 3, windows);
    bindTo(compared, 4, pairs);
    bindTo(compared, 5, terms);
    bindTo(compared, 6, ssimParts);
    (weight > 0.0f ? nativeLossTerms(display) : nativeLossCompare(display))(compared);
    gpu::NativeDispatch differentiated({columns, rows, 1}, {});
    bindTo(differentiated, 0, params);
    bindTo(differentiated, 1, terms);
    bindTo(differentiated, 2, pairs);
    bindTo(differentiated, 3, windows);
    bindTo(differentiated, 4, rendered);
    bindTo(differentiated, 5, result.gradient);
    bindTo(differentiated, 6, parts);
    nativeLossGradient(display, weight > 0.0f)(differentiated);
    EXPECT_EQ(terms.back(), glm::vec4(7.0f));  // nothing behind them
    EXPECT_EQ(result.gradient.back(), glm::vec4(7.0f));
    result.gradient.pop_back();

    glm::dvec4 total(0.0);
    for (std::size_t i = 0; i < parts.size(); ++i)
        total += glm::dvec4(parts[i]) + glm::dvec4(0, 0, 0, double(ssimParts[i]));
    const double values = 4.0 * double(pixels);
    result.loss = double(params[0].l1Scale) * total.x + double(params[0].squareScale) * total.y +
                  double(params[0].dssimScale) * total.w;
    result.l1 = total.x / values;
    result.dssim = total.w / values;
    result.badRendered = total.z;
    return result;
}

// Values to 5e-5, gradients to 1e-4 of the largest one, as on the device; a few percent of the pixels may be
// at kinks, unless pictures are equal in parts.
void expectAsReference(int width, int height, const Pixels& render, const Pixels& target,
                       const LossOptions& options, const LossStep& step, double leastCompared = 0.98) {
    const ReferenceLoss expected = referenceLoss(width, height, render, target, options, step);
    const double rounding = roundingOfOnePixel(render, target, options, step);
    const double tolerance = (1e-4 + rounding) * largest(expected.gradient);
    onEachInstructionSet([&] {
        const NativeLoss found = run(width, height, render, target, options, step);
        EXPECT_NEAR(found.loss, expected.loss,
                    5e-5 * (1e-3 + expected.loss) + rounding * double(step.viewWeight));
        EXPECT_NEAR(found.l1, expected.l1, 5e-5 * (1e-3 + expected.l1));
        EXPECT_NEAR(found.dssim, expected.dssim, 5e-5 * (1e-2 + expected.dssim) + rounding);
        EXPECT_EQ(found.badRendered, double(expected.badRendered));
        std::size_t compared = 0;
        for (std::size_t i = 0; i < render.size(); ++i) {
            if (expected.gradient[i] != glm::dvec4(0.0) && atKink(render[i], target[i], options, step, 1e-5))
                continue;
            ++compared;
            for (int c = 0; c < 4; ++c)
                ASSERT_NEAR(found.gradient[i][c], expected.gradient[i][c], tolerance)
                    << "pixel " << i << " " << c;
        }
        EXPECT_GE(double(compared), double(render.size()) * leastCompared);
    });
}

TEST(NativeLoss, IsThatOfTheReference) {
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 37), std::pair(53, 1), std::pair(7, 5),
                                        std::pair(64, 32), std::pair(75, 41)}) {
        const Pixels render = randomPicture(width, height, 1);
        const Pixels target = randomPicture(width, height, 2);
        for (const LossEncoding encode : {LossEncoding::none, LossEncoding::display}) {
            for (const LossMeasure measure :
                 {LossMeasure::similar, LossMeasure::absolute, LossMeasure::squared}) {
                for (const bool coverageOnly : {false, true}) {
                    const LossOptions options{.dssimWeight = 0.3f, .encode = encode, .exposure = 0.8f};
                    expectAsReference(width, height, render, target, options,
                                      {.measure = measure,
                                       .background = randomBackground(3),
                                       .viewWeight = 0.7f,
                                       .coverageOnly = coverageOnly});
                }
            }
        }
    }
}

// Tiles in which both pictures are the same are left out, but not pixels beside ones that differ, and pixels
// that are not finite count.
TEST(NativeLoss, IsThatOfTheReferenceWhereMostIsEmpty) {
    constexpr int kWidth = 150;
    constexpr int kHeight = 90;
    Pixels render = filled(kWidth, kHeight, glm::dvec4(0.0));
    Pixels target = render;
    const auto fill = [](Pixels& pixels, const glm::ivec2& from, const glm::ivec2& to, std::uint32_t seed) {
        const Pixels random = randomPicture(kWidth, kHeight, seed);
        for (int y = from.y; y < to.y; ++y)
            for (int x = from.x; x < to.x; ++x)
                pixels[std::size_t(y * kWidth + x)] = random[std::size_t(y * kWidth + x)];
    };
    fill(render, {44, 20}, {49, 33}, 1);
    fill(target, {46, 22}, {52, 32}, 2);
    fill(render, {100, 60}, {140, 70}, 3);
    fill(target, {100, 60}, {140, 70}, 3);
    fill(target, {149, 89}, {150, 90}, 4);
    render[5 * kWidth + 120] = glm::dvec4(kNan);
    target[40 * kWidth + 7] = glm::dvec4(kInfinity);
    for (const LossEncoding encode : {LossEncoding::none, LossEncoding::display})
        for (const LossMeasure measure : {LossMeasure::similar, LossMeasure::absolute, LossMeasure::squared})
            expectAsReference(kWidth, kHeight, render, target, {.dssimWeight = 0.4f, .encode = encode},
                              {.measure = measure, .background = randomBackground(6)}, 0.7);
}

TEST(NativeLoss, EqualPicturesHaveNone) {
    const Pixels picture = randomPicture(40, 30, 5);
    for (const LossEncoding encode : {LossEncoding::none, LossEncoding::display}) {
        onEachInstructionSet([&] {
            const NativeLoss found =
                run(40, 30, picture, picture, {.dssimWeight = 0.5f, .encode = encode}, {});
            EXPECT_EQ(found.loss, 0.0);
            for (const glm::vec4& g : found.gradient) ASSERT_EQ(g, glm::vec4(0.0f));
        });
    }
}

TEST(NativeLoss, PixelsThatAreNotFiniteAndOfAnySize) {
    Pixels render = randomPicture(40, 30, 6);
    Pixels target = randomPicture(40, 30, 7);
    render[3].x = kNan;
    render[77].w = kInfinity;
    target[78].y = -kInfinity;
    target[400].z = kNan;
    render[600] = glm::dvec4(1e30, 0.0, 1e-40, 1.0);
    render[601] = glm::dvec4(-2.0, 0.5, 0.0, 0.5);
    target[602] = glm::dvec4(1e8, 1e8, 1e8, 1.0);
    for (const LossEncoding encode : {LossEncoding::none, LossEncoding::display}) {
        onEachInstructionSet([&] {
            const NativeLoss found = run(40, 30, render, target, {.encode = encode}, {});
            EXPECT_EQ(found.badRendered, 2.0);
            EXPECT_TRUE(std::isfinite(found.loss));
            for (const glm::vec4& g : found.gradient) ASSERT_TRUE(isKnown(g));
            for (const std::size_t i : {3, 77, 78, 400}) EXPECT_EQ(found.gradient[i], glm::vec4(0.0f));
        });
    }
    render[600] = render[601] = target[602] = glm::dvec4(0.3, 0.2, 0.1, 0.9);
    expectAsReference(40, 30, render, target, {.encode = LossEncoding::display}, {});
}

}  // namespace
}  // namespace macula::splat
