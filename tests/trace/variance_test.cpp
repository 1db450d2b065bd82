// How noisy a pixel is said to be, against how far pictures are from the truth.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "base/glsl_in_cpp.h"
#include "trace/denoise_pictures.h"

namespace macula::trace {
namespace {

#define OUT(type) type&
#define INOUT(type) type&
#define PRECISE
struct VarianceHost : GlslInCpp<double> {
#define float double
#include "lib/picture.glsl"
#include "lib/variance.glsl"
#undef float
    double of(double sum, unsigned count, double squares) {
        return varianceOfMean(vec4(sum, sum, sum, double(count)), count, squares);
    }
};
#undef OUT
#undef INOUT
#undef PRECISE

constexpr double kMost = 1e24;

// On average, of light as that of a path is, whose samples vary as much as they are bright.
TEST(Variance, IsHowFarMeansAreFromTheTruth) {
    VarianceHost host;
    for (const unsigned samples : {1u, 2u, 4u, 16u}) {
        std::mt19937 random(11);
        std::exponential_distribution<double> brightness(1.0 / 0.7);
        double said = 0.0;
        double truth = 0.0;
        constexpr int kPixels = 20000;
        for (int pixel = 0; pixel < kPixels; ++pixel) {
            double sum = 0.0;
            double squares = 0.0;
            for (unsigned s = 0; s < samples; ++s) {
                const double light = brightness(random);
                sum += light;
                squares += light * light;
            }
            said += host.of(sum, samples, squares);
            truth += std::pow(sum / samples - 0.7, 2.0);
        }
        EXPECT_NEAR(said / truth, 1.0, 0.05) << samples;
    }
}

TEST(Variance, HoldsAtTheExtremes) {
    VarianceHost host;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(host.of(0.0, 0, 0.0), kMost) << "nothing is known";
    EXPECT_EQ(host.of(0.0, 5, 0.0), 0.0) << "always black";
    EXPECT_NEAR(host.of(5.0, 5, 5.0), 0.0, 1e-15) << "always the same";
    EXPECT_EQ(host.of(5.0, 5, 5.0 - 1e-9), 0.0) << "rounded to less than that";
    for (const double bad : {nan, infinity, -infinity}) {
        EXPECT_EQ(host.of(bad, 4, 1.0), kMost) << bad;
        EXPECT_EQ(host.of(1.0, 4, bad), kMost) << bad;
        EXPECT_EQ(host.of(bad, 1, bad), kMost) << bad;
    }
    EXPECT_EQ(host.of(1e30, 2, 1e60), kMost);
    const double denormal = std::numeric_limits<double>::denorm_min();
    EXPECT_GE(host.of(denormal, 2, denormal), 0.0);
    EXPECT_EQ(host.of(0.0, 4000000000u, 0.0), 0.0);
}

// Over whole pictures; where the filter blurs edges it is more than what is said.
TEST(Variance, OfAFilteredPictureIsOfTheSizeOfItsError) {
    for (const TruePicture& picture : {scenery(48), softTissue(48)}) {
        const DenoiseGuides guides = picture.guides();
        double before = std::numeric_limits<double>::infinity();
        for (const std::uint32_t samples : {2u, 8u, 32u}) {
            double said = 0.0;
            double truth = 0.0;
            for (std::uint32_t seed = 1; seed <= 4; ++seed) {
                const DenoiseFilm film = picture.film(samples, seed);
                const DenoiseRecord record = denoiseGather(picture.push(), film, guides, guides, {});
                std::vector<glm::dvec4> masses;
                const DenoiseState state = filtered(picture.push(), record, guides, masses);
                const std::vector<double> variances =
                    denoiseVariances(picture.push(), record, state, guides, masses);
                const std::vector<glm::dvec4> shown = denoiseSpecks(picture.push(), state, guides, masses);
                for (std::size_t i = 0; i < shown.size(); ++i) {
                    ASSERT_GE(variances[i], 0.0);
                    said += variances[i];
                    const glm::dvec3 off = glm::dvec3(shown[i] - picture.truth(i));
                    truth += std::pow(glm::dot(off, glm::dvec3(0.2126, 0.7152, 0.0722)), 2.0);
                }
            }
            EXPECT_GT(said, 0.25 * truth) << samples << ": " << said / truth;
            EXPECT_LT(said, 4.0 * truth) << samples << ": " << said / truth;
            EXPECT_LT(said, before) << "more samples, less noise";
            before = said;
        }
    }
}

}  // namespace
}  // namespace macula::trace
