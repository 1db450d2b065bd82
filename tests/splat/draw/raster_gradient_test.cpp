// Derivatives against central differences of the double reference.
//
// Away from discontinuities: alpha is continuous (Blending::fringe); the order in depth has a step, so the
// scenes must have depths that are apart by much more than the differences; that a pixel is finished has a
// step of at most 1e-4, and none in scenes where no pixel comes near to it, which is tested as well. Kinks
// (fringe, maxAlpha, colours below 0, the clamp of the Jacobian) spoil a difference only where they lie
// within the step, 1e-5 of a parameter, of one pixel in hundreds.
#include <functional>

#include "base/worst.h"
#include "splat/draw/reference_scenes.h"

namespace macula::splat {
namespace {

constexpr double kStep = 1e-5;
constexpr double kWorst = 1e-3;  // relative, as issue 5 asks
// Of parallel rays: with a step of 1e-4 positions agree to 1e-3, and with one of 1e-6 to 3e-3 only. It is
// rounding.
constexpr double kWorstParallel = 2.5e-3;
constexpr double kFloor =
    1e-5;  // of the largest derivative of its kind: below that, differences are rounding

struct Kind {
    const char* name;
    int count;
    std::function<double&(ReferenceSplats&, std::size_t, int)> at;
};

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all{
        {"position", 3, [](ReferenceSplats& s, std::size_t i, int k) -> double& { return s.position[i][k]; }},
        {"logScale", 3, [](ReferenceSplats& s, std::size_t i, int k) -> double& { return s.logScale[i][k]; }},
        {"rotation", 4, [](ReferenceSplats& s, std::size_t i, int k) -> double& { return s.rotation[i][k]; }},
        {"opacityLogit", 1,
         [](ReferenceSplats& s, std::size_t i, int) -> double& { return s.opacityLogit[i]; }},
        {"dc", 3, [](ReferenceSplats& s, std::size_t i, int k) -> double& { return s.dc[i][k]; }},
        {"sh", 9, [](ReferenceSplats& s, std::size_t i, int k) -> double& {
             return s.sh[3 * i + static_cast<std::size_t>(k / 3)][k % 3];
         }}};
    return all;
}

// A loss with a derivative that differs from pixel to pixel, and is not linear. What shines through from
// behind is in its derivative by coverage.
struct Loss {
    glm::dvec3 background{0.0};
    double ofColour = 1.0;
    double ofCoverage = 1.0;
    double ofDepth = 0.01;

    // Of one pixel, and its derivative by colour over the background, by coverage, by depth.
    double operator()(std::size_t pixel, const glm::dvec4& rgba, double depth, glm::dvec3& byColour,
                      double& byCoverage, double& byDepth) const {
        const double n = static_cast<double>(pixel);
        const glm::dvec3 target(0.5 + 0.5 * std::sin(n), 0.5 + 0.5 * std::sin(1.3 * n),
                                0.5 + 0.5 * std::sin(2.1 * n));
        const glm::dvec3 error = glm::dvec3(rgba) + (1.0 - rgba.a) * background - target;
        byColour = 2.0 * ofColour * error;
        byCoverage = ofCoverage * std::cos(0.7 * n) * 2.0 * rgba.a;
        byDepth = ofDepth * std::cos(1.9 * n);
        return ofColour * glm::dot(error, error) + ofCoverage * std::cos(0.7 * n) * rgba.a * rgba.a +
               byDepth * depth;
    }

    double of(const RasterImage& image) const {
        double sum = 0.0;
        glm::dvec3 byColour;
        double byCoverage = 0.0;
        double byDepth = 0.0;
        for (std::size_t i = 0; i < image.rgba.size(); ++i)
            sum += (*this)(i, image.rgba[i], image.depth[i], byColour, byCoverage, byDepth);
        return sum;
    }

    RasterGradient gradientOf(const RasterImage& image) const {
        RasterGradient g;
        for (std::size_t i = 0; i < image.rgba.size(); ++i) {
            glm::dvec3 byColour;
            double byCoverage = 0.0;
            double byDepth = 0.0;
            (*this)(i, image.rgba[i], image.depth[i], byColour, byCoverage, byDepth);
            g.rgba.emplace_back(byColour, byCoverage - glm::dot(background, byColour));
            g.depth.push_back(byDepth);
        }
        return g;
    }
};

struct Worst {
    double relative = 0.0;
    double largest = 0.0;  // derivative
};

// Compares all derivatives; says the worst error of each kind relative to the difference or the floor.
void expectDerivatives(const ReferenceSplats& splats, const RasterView& view, const Blending& blending,
                       const Loss& loss, const char* what) {
    const RasterImage image = rasterize(splats, view, blending, Precision::twofold);
    ASSERT_GT(coverageSum(image), 5.0) << what << ": nothing to be seen";
    ReferenceSplats g =
        rasterizeBackward(splats, view, blending, image, loss.gradientOf(image), Precision::twofold);
    for (const Kind& kind : kinds()) {
        if (splats.shDegree == 0 && kind.count == 9) continue;
        std::vector<double> differences;
        std::vector<double> derivatives;
        Worst worst;
        for (std::size_t i = 0; i < splats.size(); ++i) {
            for (int k = 0; k < kind.count; ++k) {
                const auto lossAt = [&](double shift) {
                    ReferenceSplats moved = splats;
                    kind.at(moved, i, k) += shift;
                    return loss.of(rasterize(moved, view, blending, Precision::twofold));
                };
                differences.push_back((lossAt(kStep) - lossAt(-kStep)) / (2.0 * kStep));
                derivatives.push_back(kind.at(g, i, k));
                worst.largest = std::max(worst.largest, std::abs(differences.back()));
            }
        }
        for (std::size_t n = 0; n < differences.size(); ++n) {
            const double scale = std::max(std::abs(differences[n]), kFloor * worst.largest);
            worst.relative = test::worse(worst.relative, std::abs(derivatives[n] - differences[n]) / scale);
        }
        EXPECT_GT(worst.largest, 1e-3) << what << ", " << kind.name << ": no derivative to compare";
        EXPECT_LT(worst.relative, view.isParallel ? kWorstParallel : kWorst) << what << ", " << kind.name;
    }
}

// The steps in depth of a scene are far from the differences.
void expectDepthsApart(const ReferenceSplats& splats, const RasterView& view) {
    std::vector<double> depths;
    for (const auto& p : projectSplats(splats, view, {}, Precision::twofold)) depths.push_back(p.depthMm);
    std::sort(depths.begin(), depths.end());
    for (std::size_t i = 1; i < depths.size(); ++i)
        ASSERT_TRUE(depths[i] == 0.0 || depths[i] - depths[i - 1] > 1e-3);
}

TEST(RasterGradient, OfEachParameterOnRandomScenes) {
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        const ReferenceSplats splats = randomModel(seed, 9);
        expectDepthsApart(splats, frontView());
        expectDerivatives(splats, frontView(), {}, {.background = {0.3, 0.8, 0.1}}, "all");
    }
}

TEST(RasterGradient, OfEachOutputAlone) {
    const ReferenceSplats splats = randomModel(4, 7);
    expectDepthsApart(splats, frontView());
    const RasterImage image = rasterize(splats, frontView(), {}, Precision::twofold);
    const std::size_t count = image.rgba.size();
    // Each with the others 0: the derivative by what it should not touch must vanish, the rest agree with
    // differences.
    for (const int output : {0, 1, 2}) {
        const RasterGradient g{std::vector<glm::dvec4>(count, glm::dvec4(glm::dvec3(output == 0 ? 1.0 : 0.0),
                                                                         output == 1 ? 1.0 : 0.0)),
                               output == 2 ? std::vector<double>(count, 1.0) : std::vector<double>()};
        const auto sum = [&](const ReferenceSplats& model) {
            const RasterImage picture = rasterize(model, frontView(), {}, Precision::twofold);
            double total = 0.0;
            for (std::size_t i = 0; i < count; ++i) {
                const glm::dvec4& p = picture.rgba[i];
                total += output == 0 ? p.r + p.g + p.b : output == 1 ? p.a : picture.depth[i];
            }
            return total;
        };
        ReferenceSplats byAll = rasterizeBackward(splats, frontView(), {}, image, g, Precision::twofold);
        for (const Kind& kind : kinds()) {
            const bool ofColour = kind.count == 9 || std::string(kind.name) == "dc";
            for (std::size_t i = 0; i < splats.size(); ++i) {
                for (int k = 0; k < kind.count; ++k) {
                    const double derivative = kind.at(byAll, i, k);
                    if (ofColour && output != 0) {
                        EXPECT_EQ(derivative, 0.0);
                        continue;
                    }
                    ReferenceSplats more = splats;
                    ReferenceSplats less = splats;
                    kind.at(more, i, k) += kStep;
                    kind.at(less, i, k) -= kStep;
                    const double difference = (sum(more) - sum(less)) / (2.0 * kStep);
                    EXPECT_NEAR(derivative, difference,
                                1e-3 * std::abs(difference) + (output == 2 ? 1e-3 : 1e-5))
                        << kind.name << " by output " << output;
                }
            }
        }
    }
}

TEST(RasterGradient, OfClassicBlending) {
    // Hard edges: not a difference of the sum over pixels unless no pixel crosses; the seed is one where none
    // does.
    const ReferenceSplats splats = randomModel(5, 8);
    expectDepthsApart(splats, frontView());
    expectDerivatives(splats, frontView(), blendingOf(LowPass::classic), {.background = {0.3, 0.8, 0.1}},
                      "classic");
}

TEST(RasterGradient, OfAConstantLowPass) {
    const ReferenceSplats splats = randomModel(5, 8);
    expectDepthsApart(splats, frontView());
    expectDerivatives(splats, frontView(), blendingOf(LowPass::compensated), {.background = {0.3, 0.8, 0.1}},
                      "compensated");
}

TEST(RasterGradient, OfOpaqueSplatsAndFinishedPixels) {
    ReferenceSplats splats = randomModel(6, 14);
    for (std::size_t i = 0; i < splats.size(); ++i) {
        splats.position[i] *= 0.4;
        splats.logScale[i] += 1.2;
        splats.opacityLogit[i] += 4.0;
    }
    expectDepthsApart(splats, frontView());
    const RasterImage image = rasterize(splats, frontView(), {}, Precision::twofold);
    std::size_t finished = 0;
    for (const glm::dvec4& pixel : image.rgba) finished += pixel.a > 1.0 - 1e-4 ? 1 : 0;
    EXPECT_GT(finished, 20u);
    expectDerivatives(splats, frontView(), {}, {.background = {0.3, 0.8, 0.1}}, "opaque");
}

// Smaller than a pixel, needles, discs, and centres outside of the picture, where the Jacobian is clamped.
TEST(RasterGradient, OfUnusualSplats) {
    ReferenceSplats splats = randomModel(8, 8);
    for (std::size_t i = 0; i < 4; ++i) splats.opacityLogit[i] = 3.0;
    splats.logScale[0] = glm::dvec3(std::log(1.2));  // a quarter of a pixel
    splats.logScale[1] = {std::log(60.0), std::log(0.02), std::log(0.02)};
    splats.logScale[2] = {std::log(15.0), std::log(12.0), std::log(1e-3)};
    splats.position[3] = {110, 10, -20};
    splats.logScale[3] = glm::log(glm::dvec3(60, 40, 50));
    splats.position[4] = {-130, -15, 90};
    splats.logScale[4] = glm::log(glm::dvec3(90, 80, 60));
    const auto projected = projectSplats(splats, frontView(), {}, Precision::twofold);
    EXPECT_GT(projected[3].mean.x, 28 * 1.2) << "not beyond the clamp";
    EXPECT_LT(projected[4].mean.x, 28 * -0.2);
    EXPECT_LT(projected[4].mean.y, 24 * -0.2);
    expectDepthsApart(splats, frontView());
    expectDerivatives(splats, frontView(), {}, {.background = {0.3, 0.8, 0.1}}, "unusual");
}

TEST(RasterGradient, OfWideAngleViews) {
    const Camera camera{.positionMm = {10, -70, 5}, .verticalFovDeg = 80};
    const RasterView view = rasterView(camera, {28, 24}, {}).value();
    ReferenceSplats splats = randomModel(9, 8);
    for (auto& logScale : splats.logScale) logScale -= 0.5;
    expectDepthsApart(splats, view);
    expectDerivatives(splats, view, {}, {.background = {0.3, 0.8, 0.1}}, "wide");
}

TEST(RasterGradient, OfParallelRays) {
    for (const std::uint32_t seed : {1u, 2u}) {
        const ReferenceSplats splats = randomModel(seed, 9);
        const RasterView view = parallelFrontView();
        expectDepthsApart(splats, view);
        expectDerivatives(splats, view, {}, {.background = {0.3, 0.8, 0.1}}, "parallel");
    }
}

// In float, as kernels will: to within what sums over hundreds of pixels lose.
TEST(RasterGradient, OfFloatIsThatOfDouble) {
    const ReferenceSplats splats = randomModel(3, 40);
    const Loss loss{.background = {0.3, 0.8, 0.1}};
    const RasterImage image = rasterize(splats, frontView(), {}, Precision::twofold);
    const RasterGradient g = loss.gradientOf(image);
    ReferenceSplats a = rasterizeBackward(splats, frontView(), {}, image, g, Precision::twofold);
    ReferenceSplats b = rasterizeBackward(splats, frontView(), {}, image, g, Precision::single);
    for (const Kind& kind : kinds()) {
        double largest = 0.0;
        double worst = 0.0;
        for (std::size_t i = 0; i < splats.size(); ++i) {
            for (int k = 0; k < kind.count; ++k) {
                largest = std::max(largest, std::abs(kind.at(a, i, k)));
                worst = test::worse(worst, std::abs(kind.at(a, i, k) - kind.at(b, i, k)));
            }
        }
        EXPECT_LT(worst, 1e-4 * largest) << kind.name;
    }
}

}  // namespace
}  // namespace macula::splat
