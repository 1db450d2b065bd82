// How far traced light is trusted over splats: what that is worth, the device held to the same in double, and
// the extremes.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "gpu/shared_device.h"
#include "gpu/shared_layout.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/hybrid/frame/reference_reprojection.h"
#include "pipeline/hybrid/frame/texel_room.h"
#include "pipeline/hybrid/frame/trust.h"
#include "shaders/hybrid.h"
#include "shared/reproject_params.h"

namespace macula::hybrid {
namespace {

constexpr glm::ivec2 kSize{45, 38};
constexpr std::size_t kPixels = 45 * 38;

// Light with noise of a known variance over splats that are wrong in a part of the picture.
struct Pictures {
    std::vector<glm::dvec4> truth, traced, splats;
    std::vector<double> variances;

    Pictures(double noise, double wrong, unsigned seed = 3) {
        std::mt19937 random(seed);
        std::normal_distribution<double> normal;
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                const double light = 0.3 + 0.2 * std::sin(x / 5.0) * std::cos(y / 7.0);
                truth.emplace_back(glm::dvec3(light), 1.0);
                traced.emplace_back(glm::dvec3(light + noise * normal(random)), 1.0);
                splats.emplace_back(glm::dvec3(light + (x < kSize.x / 2 ? wrong : 0.0)), 1.0);
                variances.push_back(noise * noise);
            }
        }
    }
    std::vector<double> trusts(double gain = 1.0) const {
        return trustIn(kSize, traced, variances, splats, gain);
    }
    double squaredError(const std::vector<double>& weights) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < kPixels; ++i)
            sum += std::pow(glm::mix(splats[i].x, traced[i].x, weights[i]) - truth[i].x, 2.0);
        return sum;
    }
};

double meanOf(const std::vector<double>& values, int fromX, int toX) {
    double sum = 0.0;
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = fromX; x < toX; ++x) sum += values[std::size_t(y) * kSize.x + std::size_t(x)];
    }
    return sum / double((toX - fromX) * kSize.y);
}

TEST(TrustLayout, PushConstantsAgree) {
    using shared::TrustPush;
    for (const auto& code : {shaders::hybrid_trust_rows_comp, shaders::hybrid_trust_comp}) {
        const auto trust = gpu::reflectSpirv(code.words);
        ASSERT_TRUE(trust.ok());
        expectLayoutMatches<TrustPush>(*trust->pushConstants->block.find("trust"),
                                       {MACULA_FIELD(TrustPush, size), MACULA_FIELD(TrustPush, areMeans),
                                        MACULA_FIELD(TrustPush, splatGain)});
    }
}

// Mixed by it, both are nearer to the truth than either.
TEST(Trust, MixesWhatIsNoisyAndWhatIsWrongIntoWhatIsBetterThanBoth) {
    const std::vector<double> all(kPixels, 1.0);
    const std::vector<double> none(kPixels, 0.0);
    for (const double noise : {0.02, 0.05, 0.1}) {
        for (const double wrong : {0.02, 0.05, 0.1}) {
            const Pictures pictures(noise, wrong);
            const double mixed = pictures.squaredError(pictures.trusts());
            EXPECT_LT(mixed, pictures.squaredError(all)) << noise << " " << wrong;
            EXPECT_LT(mixed, 1.5 * pictures.squaredError(none)) << noise << " " << wrong;
            if (wrong >= noise) {
                EXPECT_LT(mixed, pictures.squaredError(none)) << noise << " " << wrong;
            }
        }
    }
    const std::vector<double> trusts = Pictures(0.03, 0.1).trusts();
    EXPECT_GT(meanOf(trusts, 0, kSize.x / 2 - 4), 0.85) << "where the splats are wrong";
    EXPECT_LT(meanOf(trusts, kSize.x / 2 + 4, kSize.x), 0.25) << "where they are right";
}

TEST(Trust, IsWholeWithoutNoiseAndNoneWithoutADifference) {
    for (const double trust : Pictures(0.0, 0.1).trusts()) EXPECT_EQ(trust, 1.0);
    for (const double trust : Pictures(0.0, 0.0).trusts()) EXPECT_EQ(trust, 1.0) << "both are right";
    Pictures same(0.05, 0.0);
    same.splats = same.traced;
    for (const double trust : same.trusts()) EXPECT_EQ(trust, 0.0);
    // With the gain that makes them equal.
    for (glm::dvec4& splats : same.splats) splats *= glm::dvec4(glm::dvec3(0.5), 1.0);
    for (const double trust : same.trusts(2.0)) EXPECT_NEAR(trust, 0.0, 1e-9);
    EXPECT_GT(meanOf(same.trusts(), 0, kSize.x), 0.5);
}

TEST(Trust, KnowsCoverageFromLight) {
    // Black matter is traced where splats show the background.
    Pictures dark(0.0, 0.0);
    for (std::size_t i = 0; i < kPixels; ++i) {
        dark.traced[i] = {0, 0, 0, 1};
        dark.splats[i] = glm::dvec4(0.0);
        dark.variances[i] = 1e-5;
    }
    EXPECT_GT(meanOf(dark.trusts(), 0, kSize.x), 0.99);
}

class TrustOnDevice : public gpu::SharedDeviceTest {
  protected:
    static std::vector<float> onDevice(const glm::ivec2& sizePx, const std::vector<glm::vec4>& traced,
                                       const std::vector<std::uint32_t>& counts, bool areMeans,
                                       const std::vector<float>& variances,
                                       const std::vector<glm::vec4>& splats, float gain) {
        const gpu::Buffer values =
            std::move(*gpu::Buffer::create(device(), {.bytes = traced.size() * sizeof(glm::vec4)}));
        const gpu::Buffer samples =
            std::move(*gpu::Buffer::create(device(), {.bytes = counts.size() * sizeof(std::uint32_t)}));
        const gpu::Buffer noises =
            std::move(*gpu::Buffer::create(device(), {.bytes = variances.size() * sizeof(float)}));
        EXPECT_TRUE(gpu::uploadTo<glm::vec4>(values, traced).ok());
        EXPECT_TRUE(gpu::uploadTo<std::uint32_t>(samples, counts).ok());
        EXPECT_TRUE(gpu::uploadTo<float>(noises, variances).ok());
        const auto drawn =
            std::move(*splat::DevicePicture::upload(device(), "splats", sizePx.x, sizePx.y, splats));
        const gpu::TexelBuffer trusts =
            std::move(*makeTexels(device(), "trusts", VK_FORMAT_R32_SFLOAT, traced.size()));
        Trust trust = std::move(*Trust::create(device()));
        EXPECT_TRUE(
            trust
                .weigh({.values = &values, .counts = &samples, .areMeans = areMeans, .variances = &noises},
                       drawn, gain, trusts)
                .ok());
        return *gpu::read<float>(trusts.buffer());
    }
};

TEST_F(TrustOnDevice, IsThatOfTheReference) {
    for (const double noise : {0.01, 0.1}) {
        const Pictures pictures(noise, 0.05);
        const std::vector<double> expected = pictures.trusts(0.9);
        const std::vector<glm::vec4> splats(pictures.splats.begin(), pictures.splats.end());
        const std::vector<float> variances(pictures.variances.begin(), pictures.variances.end());
        const std::vector<glm::vec4> means(pictures.traced.begin(), pictures.traced.end());
        std::vector<glm::vec4> sums = means;
        std::vector<std::uint32_t> counts(kPixels);
        for (std::size_t i = 0; i < kPixels; ++i) {
            counts[i] = std::uint32_t(i % 7);  // also of a pixel that has no sample yet
            sums[i] *= float(std::max(counts[i], 1u));
        }
        const auto ofMeans = onDevice(kSize, means, counts, true, variances, splats, 0.9f);
        const auto ofSums = onDevice(kSize, sums, counts, false, variances, splats, 0.9f);
        for (std::size_t i = 0; i < kPixels; ++i) {
            ASSERT_NEAR(ofMeans[i], expected[i], 1e-3) << i;
            ASSERT_NEAR(ofSums[i], expected[i], 1e-3) << i;
        }
    }
}

// Whatever it is told, it is from 0 to 1; and what is not a number is never trusted over what is.
TEST_F(TrustOnDevice, HoldsAtTheExtremes) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const float denormal = std::numeric_limits<float>::denorm_min();
    for (const glm::ivec2& sizePx : {glm::ivec2(1), glm::ivec2(1, 19), glm::ivec2(23, 1), glm::ivec2(9, 9)}) {
        const auto pixels = std::size_t(sizePx.x) * std::size_t(sizePx.y);
        const std::vector<std::uint32_t> counts(pixels, 1);
        const std::vector<glm::vec4> good(pixels, glm::vec4(0.2f, 0.3f, 0.1f, 0.5f));
        const std::vector<float> noises(pixels, 1e-4f);
        const auto trust = [&](const std::vector<glm::vec4>& traced, const std::vector<float>& variances,
                               const std::vector<glm::vec4>& splats) {
            const auto trusts = onDevice(sizePx, traced, counts, true, variances, splats, 1.0f);
            for (const float value : trusts) {
                EXPECT_GE(value, 0.0f);
                EXPECT_LE(value, 1.0f);
                EXPECT_EQ(value, trusts.front());
            }
            return trusts.front();
        };
        for (const float bad : {nan, infinity, -infinity})
            EXPECT_EQ(trust(good, noises, std::vector<glm::vec4>(pixels, glm::vec4(bad))), 1.0f) << bad;
        for (const float value : {denormal, -denormal, 1e12f, 1e-12f, -1.0f}) {
            trust(good, noises, std::vector<glm::vec4>(pixels, glm::vec4(value)));
            trust(std::vector<glm::vec4>(pixels, glm::vec4(value)), noises, good);
        }
        EXPECT_EQ(trust(good, std::vector<float>(pixels, 1e24f), good), 0.0f) << "nothing is known of it";
        EXPECT_EQ(trust(good, std::vector<float>(pixels, 0.0f), good), 1.0f);
        EXPECT_EQ(trust(std::vector<glm::vec4>(pixels, glm::vec4(0.0f)), std::vector<float>(pixels, 0.0f),
                        std::vector<glm::vec4>(pixels, glm::vec4(0.0f))),
                  1.0f);
    }
}

}  // namespace
}  // namespace macula::hybrid
