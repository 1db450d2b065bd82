// What the reference rasterizer draws, against what is known without it.
#include <algorithm>
#include <numeric>

#include "splat/draw/reference_scenes.h"

namespace macula::splat {
namespace {

// The share of a Gaussian that a ray goes through: the integral of exp(-r^T S^-1 r / 2) along it, in steps
// that are much finer than the Gaussian, over that of the ray through the centre.
double throughGaussian(const ReferenceSplats& splats, const RasterView& view, const glm::dvec2& pixel) {
    // Rodrigues' formula, so that the quaternion's convention is tested too.
    const glm::dvec4 q = splats.rotation[0] / glm::length(splats.rotation[0]);
    const double angle = 2.0 * std::acos(q.x);
    const glm::dvec3 k = glm::dvec3(q.y, q.z, q.w) / std::sin(angle / 2.0);
    const auto turnedBack = [&](const glm::dvec3& v) {
        return v * std::cos(angle) + glm::cross(-k, v) * std::sin(angle) +
               k * glm::dot(k, v) * (1.0 - std::cos(angle));
    };
    const glm::dvec3 deviation = glm::exp(splats.logScale[0]);
    const auto integral = [&](const glm::dvec2& p) {
        const glm::dvec2 slope = (p - view.principalPx) / view.focalPx;
        const glm::dmat3 worldFromCamera = glm::transpose(view.cameraFromWorld);
        const glm::dvec3 world = glm::normalize(
            worldFromCamera * (view.isParallel ? glm::dvec3(0, 0, 1) : glm::dvec3(slope, 1.0)));
        const glm::dvec3 eye =
            view.eyeMm + (view.isParallel ? worldFromCamera * glm::dvec3(slope, 0.0) : glm::dvec3(0.0));
        const glm::dvec3 along = turnedBack(world) / deviation;
        const glm::dvec3 begin = turnedBack(eye - splats.position[0]) / deviation;
        const double nearest = -glm::dot(begin, along) / glm::dot(along, along);
        const double step = 0.05 / glm::length(along);
        double sum = 0.0;
        for (int i = -200; i <= 200; ++i) {
            const glm::dvec3 at = begin + along * (nearest + i * step);
            sum += std::exp(-0.5 * glm::dot(at, at)) * step;
        }
        return sum;
    };
    const glm::dvec3 centre = view.cameraFromWorld * (splats.position[0] - view.eyeMm);
    const double depth = view.isParallel ? 1.0 : centre.z;
    const glm::dvec2 mean = view.focalPx * glm::dvec2(centre) / depth + view.principalPx;
    return integral(pixel) / integral(mean);
}

void expectLikeIntegral(const ReferenceSplats& splats, const RasterView& view, double tolerance) {
    const Blending blending{
        .compensated = false, .lowPassPx2 = 0.01, .lowPassLeastPx2 = 0.01, .minAlpha = 1e-6};
    const RasterImage image = rasterize(splats, view, blending, Precision::twofold);
    double greatest = 0.0;
    for (int row = 0; row < view.sizePx.y; ++row) {
        for (int column = 0; column < view.sizePx.x; ++column) {
            const double truth = 0.9 * throughGaussian(splats, view, glm::dvec2(column, row) + 0.5);
            EXPECT_NEAR(at(image, column, row).a, truth, tolerance) << column << ", " << row;
            greatest = std::max(greatest, truth);
        }
    }
    EXPECT_GT(greatest, 0.5) << "the splat is not in the picture";
}

// Seen from afar the perspective is affine over a splat, and EWA exact but for the low-pass of 0.01 px^2.
TEST(Raster, IsTheIntegralOfTheGaussianAlongRays) {
    ReferenceSplats splats = oneSplat(1);
    splats.position[0] = {1, 4, -2};
    splats.logScale[0] = {std::log(2.4), std::log(5.0), std::log(1.8)};
    splats.rotation[0] = {0.4, -0.7, 1.1, 0.5};
    const Camera camera{.positionMm = {0, -5000, 0}, .verticalFovDeg = 0.3};
    expectLikeIntegral(splats, rasterView(camera, {48, 40}, {}).value(), 1e-3);
}

// Far off the axis as well: a window on a picture of 2 000 pixels focal length, at a slope of 1 to the right,
// 0.6 down.
TEST(Raster, IsTheIntegralFarOffTheAxis) {
    RasterView view = frontView({48, 40});
    view.focalPx = glm::dvec2(2000);
    view.principalPx = {24.3 - 2000, 19.1 - 1200};
    ReferenceSplats splats = oneSplat(1);
    const glm::dvec3 inCamera(500, 300, 500);
    splats.position[0] = glm::transpose(view.cameraFromWorld) * inCamera + view.eyeMm;
    splats.logScale[0] = {std::log(0.9), std::log(2.0), std::log(0.6)};
    splats.rotation[0] = {0.9, 0.3, -0.2, 0.7};
    expectLikeIntegral(splats, view, 6e-3);
}

// With parallel rays EWA is exact wherever the splat is, near or far and off the axis, but for the low-pass.
TEST(Raster, IsTheIntegralAlongParallelRays) {
    for (const glm::dvec3& at : {glm::dvec3(0.0), glm::dvec3(3, -450, -2), glm::dvec3(-4, 9000, 5)}) {
        const Camera camera{.positionMm = {200, -500, 90},
                            .targetMm = {190, 20, 80},
                            .up = {0.1, 0, 1},
                            .parallelHeightMm = 16};
        RasterView view = rasterView(camera, {48, 40}, {}).value();
        const glm::dvec3 inCamera(at.x, at.z, at.y + 500);
        ReferenceSplats splats = oneSplat(1);
        splats.position[0] = glm::transpose(view.cameraFromWorld) * inCamera + view.eyeMm;
        splats.logScale[0] = {std::log(2.4), std::log(5.0), std::log(1.8)};
        splats.rotation[0] = {0.4, -0.7, 1.1, 0.5};
        expectLikeIntegral(splats, view, 1e-3);
    }
}

// The sum of a splat's alpha over the pixels, over what it should be: its opacity times the area of a
// Gaussian.
double sumRatio(double deviationPx, const glm::dvec2& shiftPx, const Blending& blending) {
    const RasterView view = frontView({33, 33}, 12.0);
    const double mmPerPx = 500.0 / view.focalPx.x;
    ReferenceSplats splats = oneSplat(deviationPx * mmPerPx);
    splats.position[0] = {shiftPx.x * mmPerPx, 0, shiftPx.y * mmPerPx};
    const double truth = 0.9 * 2.0 * 3.14159265358979 * deviationPx * deviationPx;
    return coverageSum(rasterize(splats, view, blending, Precision::twofold)) / truth;
}

TEST(Raster, SmallSplatsKeepTheirEnergy) {
    Dice dice(7);
    for (double deviationPx = 1.5; deviationPx > 0.005; deviationPx *= 0.7) {
        // A Gaussian of variance v sampled at the pixels' centres sums to within 2 exp(-2 pi^2 v) of its
        // integral along each axis: 0.0054 for the low-pass alone.
        const glm::dvec2 shift(dice.uniform(-0.5, 0.5), dice.uniform(-0.5, 0.5));
        EXPECT_NEAR(sumRatio(deviationPx, shift, {.minAlpha = 1e-9}), 1.0, 0.013) << deviationPx;
    }
    // What the least alpha takes away: all below it, a share t / o of the energy of a Gaussian of height o,
    // and in the fringe 2 t ln 2 - t more. Samples add some scatter.
    const double deviationPx = 0.4;
    const double height = 0.9 * 0.16 / (0.16 + 0.3);
    const double lost = 2.0 * std::log(2.0) / 255.0 / height;
    EXPECT_NEAR(sumRatio(deviationPx, {0.2, 0.1}, {}), 1.0 - lost, 0.015);
    // The classic low-pass makes them brighter than they are.
    const Blending classic{.compensated = false, .lowPassLeastPx2 = 0.3, .minAlpha = 1e-9};
    EXPECT_NEAR(sumRatio(0.1, {0.2, 0.1}, classic), 31.0, 0.5);
}

// How wide splats are in the picture: never narrower than the low-pass, the wider the wider they are, and
// what is as wide as a pixel only by the pixel's area.
TEST(Raster, LowPassEndsWhereItIsNotNeeded) {
    const RasterView view = frontView({33, 33}, 12.0);
    const double mmPerPx = 500.0 / view.focalPx.x;
    // Of a splat in the middle of a pixel, from its alpha there and in the next one.
    const auto varianceAt = [&](double deviationPx, const Blending& blending) {
        const auto picture =
            rasterize(oneSplat(deviationPx * mmPerPx), view, blending, Precision::twofold).rgba;
        return 0.5 / std::log(picture[16 * 33 + 16].a / picture[16 * 33 + 17].a);
    };
    const Blending ours{.minAlpha = 1e-9};
    Blending constant = blendingOf(LowPass::compensated);  // as elsewhere
    constant.minAlpha = 1e-9;
    Blending mip = blendingOf(LowPass::mip);
    mip.minAlpha = 1e-9;
    double before = 0.3;
    for (double variance = 0.01; variance < 4.0; variance *= 1.5) {
        const double drawn = varianceAt(std::sqrt(variance), ours);
        EXPECT_GT(drawn, before);
        EXPECT_LT(drawn, variance + 0.3);
        EXPECT_NEAR(varianceAt(std::sqrt(variance), constant), variance + 0.3, 1e-9);
        EXPECT_NEAR(varianceAt(std::sqrt(variance), mip), variance + 0.1, 1e-9);
        if (variance > 2.0 * (0.3 - 1.0 / 12.0)) {
            EXPECT_NEAR(drawn, variance + 1.0 / 12.0, 1e-9);
        }
        before = drawn;
    }
}

// A needle that is thin in the picture keeps its energy as well: a vessel does not fade with distance.
TEST(Raster, ThinNeedlesKeepTheirEnergy) {
    const RasterView view = frontView({48, 48}, 12.0);
    const double mmPerPx = 500.0 / view.focalPx.x;
    for (const double widthPx : {0.5, 0.1, 0.02}) {
        ReferenceSplats splats = oneSplat(1);
        splats.logScale[0] = glm::log(glm::dvec3(4.0, widthPx, widthPx) * mmPerPx);
        splats.rotation[0] = {std::cos(0.3), 0, std::sin(0.3), 0};  // about y, the line of sight
        const double truth = 0.9 * 2.0 * 3.14159265358979 * 4.0 * widthPx;
        EXPECT_NEAR(coverageSum(rasterize(splats, view, {.minAlpha = 1e-9}, Precision::twofold)) / truth, 1.0,
                    0.01)
            << widthPx;
    }
}

TEST(Raster, OrderOfSplatsDoesNotMatter) {
    const ReferenceSplats splats = randomModel(1, 30);
    std::vector<std::size_t> shuffled(30);
    std::iota(shuffled.begin(), shuffled.end(), 0u);
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(5));
    ReferenceSplats other(30, 1);
    for (std::size_t i = 0; i < 30; ++i) {
        const std::size_t from = shuffled[i];
        other.position[i] = splats.position[from];
        other.logScale[i] = splats.logScale[from];
        other.rotation[i] = splats.rotation[from];
        other.opacityLogit[i] = splats.opacityLogit[from];
        other.dc[i] = splats.dc[from];
        for (std::size_t k = 0; k < 3; ++k) other.sh[3 * i + k] = splats.sh[3 * from + k];
    }
    for (const Precision precision : {Precision::single, Precision::twofold}) {
        const RasterImage a = rasterize(splats, frontView(), {}, precision);
        const RasterImage b = rasterize(other, frontView(), {}, precision);
        EXPECT_EQ(a.rgba, b.rgba);
        EXPECT_EQ(a.depth, b.depth);
        EXPECT_GT(coverageSum(a), 100.0);
    }
}

// Splats so large that they have one alpha everywhere; the first of the arguments is the nearest, the last of
// the arrays.
ReferenceSplats curtains(const std::vector<double>& logits) {
    ReferenceSplats splats = emptyModel(logits.size());
    for (std::size_t i = 0; i < logits.size(); ++i) {
        const std::size_t last = logits.size() - 1 - i;
        splats.position[last].y = 100.0 * static_cast<double>(i);
        splats.logScale[last] = glm::dvec3(15.0, -2.0, 15.0);
        splats.opacityLogit[last] = logits[i];
        splats.dc[last] =
            glm::dvec3(i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0) / 0.28209479177387814 -
            glm::dvec3(0.5) / 0.28209479177387814;
    }
    return splats;
}

double opacity(double logit) {
    return 1.0 / (1.0 + std::exp(-logit));
}

TEST(Raster, BlendsFrontToBack) {
    const RasterImage image = rasterize(curtains({0.3, -1.0, 2.0}), frontView(), {}, Precision::twofold);
    const double a = opacity(0.3);
    const double b = opacity(-1.0);
    const double c = opacity(2.0);
    const std::size_t middle = 12 * 28 + 14;
    EXPECT_NEAR(image.rgba[middle].r, a, 1e-9);
    EXPECT_NEAR(image.rgba[middle].g, (1 - a) * b, 1e-9);
    EXPECT_NEAR(image.rgba[middle].b, (1 - a) * (1 - b) * c, 1e-9);
    EXPECT_NEAR(image.rgba[middle].a, 1.0 - (1 - a) * (1 - b) * (1 - c), 1e-9);
    EXPECT_NEAR(image.depth[middle], 500 * a + 600 * (1 - a) * b + 700 * (1 - a) * (1 - b) * c, 1e-6);
}

TEST(Raster, OpaqueSplatsHideWhatIsBehind) {
    const RasterImage image = rasterize(curtains({80, 80, 80, 80}), frontView(), {}, Precision::twofold);
    EXPECT_NEAR(at(image, 3, 3).r, 0.99, 1e-12);
    EXPECT_NEAR(at(image, 3, 3).g, 0.0099, 1e-12);
    EXPECT_NEAR(at(image, 3, 3).a, 1.0, 1.1e-4);
    // What is behind transmittance 1e-4 makes no difference: five are as six.
    const auto nearly = rasterize(curtains({3, 3, 3, 3, 3, 3}), frontView(), {}, Precision::twofold);
    const auto without = rasterize(curtains({3, 3, 3, 3}), frontView(), {}, Precision::twofold);
    EXPECT_EQ(at(nearly, 5, 5).a, at(without, 5, 5).a);
    EXPECT_NEAR(at(nearly, 5, 5).a, 1.0 - std::pow(1.0 - opacity(3), 4), 1e-9);
}

TEST(Raster, BlendsInAGivenOrder) {
    const ReferenceSplats splats = curtains({0.3, -1.0});
    const std::vector<std::uint32_t> backToFront{0, 1};
    const RasterImage image = rasterize(splats, frontView(), {}, Precision::twofold, backToFront);
    EXPECT_NEAR(at(image, 9, 9).g, opacity(-1.0), 1e-9);
    EXPECT_NEAR(at(image, 9, 9).r, (1 - opacity(-1.0)) * opacity(0.3), 1e-9);
}

// Ours fade out; those from elsewhere have the edge of 3DGS. All end at 1/255.
TEST(Raster, EdgesAreAtTheLeastAlpha) {
    const RasterView view = frontView({201, 3}, 3.0);
    for (const LowPass lowPass : kLowPasses) {
        const Blending blending = blendingOf(lowPass);
        const bool isHard = lowPass != LowPass::adaptive;
        ReferenceSplats splats = oneSplat(0.2 * 500 / view.focalPx.x * 100);
        const RasterImage image = rasterize(splats, view, blending, Precision::twofold);
        double least = 1.0;
        double step = 0.0;
        double before = at(image, 0, 1).a;
        for (int column = 1; column < 201; ++column) {
            const double alpha = at(image, column, 1).a;
            if (alpha > 0.0) least = std::min(least, alpha);
            if (std::min(alpha, before) == 0.0) step = std::max(step, std::max(alpha, before));
            before = alpha;
        }
        EXPECT_EQ(least >= 1.0 / 255.0, isHard);
        EXPECT_EQ(step > 1.0 / 256.0, isHard);
        EXPECT_EQ(at(image, 0, 1).a, 0.0);
    }
}

}  // namespace
}  // namespace macula::splat
