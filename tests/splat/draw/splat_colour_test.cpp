// Spherical harmonics: what they must be by definition.
#include <cmath>

#include "pipeline/splat/draw/displayed.h"
#include "pipeline/splat/draw/reference_host.h"
#include "splat/draw/reference_scenes.h"
#include "splat/model_support.h"

namespace macula::splat {
namespace {

using Host = reference::HostTwofold;

// Of the k-th coefficient, 0 the constant one: what 1 of it adds to the colour.
double basisAt(Host& host, int k, const glm::dvec3& d) {
    std::array<glm::dvec3, 16> s{};
    s[static_cast<std::size_t>(k)] = glm::dvec3(1.0);
    const glm::dvec3 sum = host.colourOfBand0(s[0]) - 0.5 + host.colourOfBand1(d, s[1], s[2], s[3]) +
                           host.colourOfBand2(d, s[4], s[5], s[6], s[7], s[8]) +
                           host.colourOfBand3(d, s[9], s[10], s[11], s[12], s[13], s[14], s[15]);
    return sum.x;
}

TEST(SplatColour, HarmonicsAreOrthonormal) {
    Host host(frontView(), {});
    // Products are polynomials of degree 6: eight directions around are exact for them, and Simpson's rule of
    // 200 steps in z to better than 1e-7.
    for (int i = 0; i < 16; ++i) {
        for (int k = 0; k <= i; ++k) {
            double integral = 0.0;
            constexpr int kSteps = 200;
            for (int step = 0; step <= kSteps; ++step) {
                const double z = -1.0 + 2.0 * step / kSteps;
                const double radius = std::sqrt(std::max(0.0, 1.0 - z * z));
                const double weight = (step == 0 || step == kSteps ? 1.0
                                       : step % 2 == 1             ? 4.0
                                                                   : 2.0) *
                                      2.0 / kSteps / 3.0;
                for (int turn = 0; turn < 8; ++turn) {
                    const double angle = 3.14159265358979323846 * (turn + 0.3) / 4.0;
                    const glm::dvec3 d(radius * std::cos(angle), radius * std::sin(angle), z);
                    integral +=
                        weight * (3.14159265358979323846 / 4.0) * basisAt(host, i, d) * basisAt(host, k, d);
                }
            }
            EXPECT_NEAR(integral, i == k ? 1.0 : 0.0, 1e-6) << i << ", " << k;
        }
    }
}

// Order and signs as in 3DGS: those of m = -l to l, odd m negative where x, y and z are positive.
TEST(SplatColour, HarmonicsHaveTheOrderAndSignsOf3dgs) {
    Host host(frontView(), {});
    const glm::dvec3 d = glm::normalize(glm::dvec3(1, 2, 3));
    const std::array<int, 16> signs{1, -1, 1, -1, 1, -1, 1, -1, -1, 1, 1, -1, 1, -1, -1, 1};
    for (int k = 0; k < 16; ++k)
        EXPECT_GT(basisAt(host, k, d) * signs[static_cast<std::size_t>(k)], 0.0) << k;
    EXPECT_NEAR(basisAt(host, 1, {0, 1, 0}), -0.4886025, 1e-7);
    EXPECT_NEAR(basisAt(host, 2, {0, 0, 1}), 0.4886025, 1e-7);
    EXPECT_NEAR(basisAt(host, 3, {1, 0, 0}), -0.4886025, 1e-7);
    // Where each of a band's harmonics is largest, or one of them.
    EXPECT_NEAR(basisAt(host, 4, {std::sqrt(0.5), std::sqrt(0.5), 0}), 0.5462742, 1e-7);
    EXPECT_NEAR(basisAt(host, 6, {0, 0, 1}), 0.6307831, 1e-7);
    EXPECT_NEAR(basisAt(host, 8, {1, 0, 0}), 0.5462742, 1e-7);
    EXPECT_NEAR(basisAt(host, 12, {0, 0, 1}), 0.7463527, 1e-7);
    EXPECT_NEAR(basisAt(host, 15, {1, 0, 0}), -0.5900436, 1e-7);
}

// All bands are drawn, in the axes of the world and from the eye to the splat.
TEST(SplatColour, IsOfTheDirectionFromTheEye) {
    for (const int degree : {0, 1, 2, 3}) {
        ReferenceSplats splats = randomModel(2, 5, degree);
        const RasterView view = frontView();
        Host host(view, {});
        const auto projected = projectSplats(splats, view, {}, Precision::twofold);
        for (std::size_t i = 0; i < splats.size(); ++i) {
            ASSERT_GT(projected[i].opacity, 0.0);
            const glm::dvec3 d = glm::normalize(splats.position[i] - glm::dvec3(0, -500, 0));
            glm::dvec3 colour = 0.5 + 0.28209479177387814 * splats.dc[i];
            for (std::size_t k = 0; k < shCount(degree); ++k)
                colour += basisAt(host, static_cast<int>(k) + 1, d) * splats.sh[i * shCount(degree) + k];
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(projected[i].colour[c], std::max(0.0, colour[c]), 1e-12);
        }
    }
}

TEST(SplatColour, BelowZeroIsBlackAndHasNoDerivative) {
    ReferenceSplats splats = oneSplat(5);
    splats.dc[0] = {-5, 1, -1.8};
    const RasterImage image = rasterize(splats, frontView(), {}, Precision::twofold);
    EXPECT_EQ(at(image, 14, 12).r, 0.0);
    EXPECT_EQ(at(image, 14, 12).b, 0.0);
    const std::size_t count = image.rgba.size();
    const RasterGradient g{std::vector<glm::dvec4>(count, glm::dvec4(1.0)), {}};
    const ReferenceSplats by = rasterizeBackward(splats, frontView(), {}, image, g, Precision::twofold);
    EXPECT_EQ(by.dc[0].r, 0.0);
    EXPECT_GT(by.dc[0].g, 0.0);
    EXPECT_EQ(by.dc[0].b, 0.0);
}

// Each splat alone is then what the display shows of it, and nearly so from all sides.
TEST(SplatColour, AsDisplayedIsWhatTheDisplayShows) {
    Splats linear = testing::randomModel(200, 1, 3);
    for (glm::vec3& dc : linear.dc) dc = glm::clamp(dc, -1.5f, 6.0f);
    for (glm::vec3& sh : linear.sh) sh = 0.05f * glm::clamp(sh, -1.0f, 1.0f);
    linear.colourSpace = ColourSpace::linear;
    const Splats shown = asDisplayed(linear);
    EXPECT_EQ(shown.colourSpace, ColourSpace::display);
    EXPECT_TRUE(shown.position == linear.position);
    const auto colour = [](const Splats& s, std::size_t i, const glm::vec3& d) {
        const auto* sh = &s.sh[3 * i];
        return glm::vec4(
            glm::max(0.5f + 0.28209479f * s.dc[i] + 0.48860251f * (-d.y * sh[0] + d.z * sh[1] - d.x * sh[2]),
                     glm::vec3(0.0f)),
            1.0f);
    };
    double squares = 0.0;
    for (std::size_t i = 0; i < linear.size(); ++i) {
        for (const glm::vec3 d : {glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, -0.6f, 0.8f)}) {
            const glm::vec4 before = colour(linear, i, d);
            const glm::vec3 wanted = displayedExactly(std::span(&before, 1), ColourSpace::linear, {}).front();
            const glm::vec3 got = glm::vec3(colour(shown, i, d));
            if (d == glm::vec3(0)) {
                EXPECT_LT(glm::distance(got, wanted), 1e-5f) << i;
            }
            squares += double(glm::dot(got - wanted, got - wanted));
        }
    }
    EXPECT_LT(std::sqrt(squares / double(9 * linear.size())), 0.004);
    // What is displayed already stays.
    EXPECT_TRUE(testing::sameBits(asDisplayed(shown), shown));
}

}  // namespace
}  // namespace macula::splat
