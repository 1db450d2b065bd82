// What denoising must and must not do, in double, on pictures with a known truth.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "trace/denoise_pictures.h"

namespace macula::trace {
namespace {

glm::dvec4 total(const std::vector<glm::dvec4>& pixels) {
    return std::accumulate(pixels.begin(), pixels.end(), glm::dvec4(0.0));
}

void expectFinite(const std::vector<glm::dvec4>& pixels) {
    for (const glm::dvec4& p : pixels) {
        ASSERT_TRUE(std::isfinite(p.x + p.y + p.z + p.w));
        ASSERT_GE(p.w, 0.0);
        ASSERT_LE(p.w, 1.0);
        ASSERT_GE(std::min({p.x, p.y, p.z}), 0.0);
    }
}

// Whatever flows from one pixel flows to another: the light of each picture is kept, not only that of their
// mean.
TEST(Denoise, KeepsTheLightOfEveryPicture) {
    const TruePicture picture = scenery(48);
    for (const std::uint32_t samples : {1u, 2u, 4u, 64u}) {
        const DenoiseFilm film = picture.film(samples, 10 + samples);
        const glm::dvec4 before = total(means(film));
        const glm::dvec4 after = total(denoised(picture, film));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(after[c] / before[c], 1.0, 1e-9) << samples;
        EXPECT_NEAR(after.w / before.w, 1.0, 0.003) << samples;  // alpha is clamped to 0 to 1
    }
}

// Where the guides do not tell one light from another, some flows over the edge between them. That bias stays
// small beside the noise of the plain picture at every number of samples: it has to fall as fast. At a fifth
// of the noise it adds 2 % to the error.
TEST(Denoise, BiasIsSmallBesideTheNoise) {
    constexpr int kSeeds = 32;
    const TruePicture picture = scenery(32);
    const std::size_t pixels = picture.pixels.size();
    for (const std::uint32_t samples : {4u, 32u, 256u}) {
        std::vector<glm::dvec4> sum(pixels), squares(pixels);
        double noise = 0.0;  // mean square of light and coverage
        for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
            const DenoiseFilm film = picture.film(samples, 1000 * samples + seed);
            const auto filtered = denoised(picture, film);
            for (std::size_t i = 0; i < pixels; ++i) {
                const glm::dvec4 off = filtered[i] - picture.truth(i);
                sum[i] += off;
                squares[i] += off * off;
            }
            noise += meanSquaredError(picture, means(film)) / kSeeds;
        }
        glm::dvec4 bias(0.0);
        for (std::size_t i = 0; i < pixels; ++i) {
            // The square of a mean of pictures has the variance of that mean in it.
            const glm::dvec4 mean = sum[i] / double(kSeeds);
            bias += mean * mean - (squares[i] / double(kSeeds) - mean * mean) / (kSeeds - 1.0);
        }
        const double ofAll = glm::dot(bias, glm::dvec4(1.0)) / double(pixels);
        EXPECT_LT(std::sqrt(std::max(ofAll, 0.0) / noise), 0.2) << samples;
    }
}

// What flows over the middle of a picture, in parts of the light on one side of it. The light differs by a
// fifth, which noise hides.
double flowOverTheMiddle(const std::function<void(TruePixel&)>& change, std::uint32_t samples) {
    const TruePicture picture(32, 32, [&](int x, int) {
        TruePixel p;
        p.light = glm::dvec3(x < 16 ? 1.0 : 0.8);
        if (x >= 16) change(p);
        return p;
    });
    constexpr int kSeeds = 16;
    double lost = 0.0;
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
        const DenoiseFilm film = picture.film(samples, seed);
        const auto plain = means(film);
        const auto filtered = denoised(picture, film);
        double before = 0.0;
        double after = 0.0;
        for (std::size_t i = 0; i < plain.size(); ++i) {
            if (i % 32 >= 16) continue;
            before += plain[i].y;
            after += filtered[i].y;
        }
        lost += (1.0 - after / before) / kSeeds;
    }
    return lost;
}

// Each guide tells lights apart that differ little. 100 mm away, where a pixel is 0.1 mm wide.
TEST(Denoise, LittleFlowsBetweenWhatTheGuidesTellApart) {
    for (const std::uint32_t samples : {1u, 4u}) {
        const double free = flowOverTheMiddle([](TruePixel&) {}, samples);
        const double depth = flowOverTheMiddle([](TruePixel& p) { p.depthMm = 107.0; }, samples);
        const double turned = flowOverTheMiddle([](TruePixel& p) { p.normal = {1, 0, 0}; }, samples);
        const double opposed = flowOverTheMiddle([](TruePixel& p) { p.normal = {0, 1, 0}; }, samples);
        const double thin = flowOverTheMiddle([](TruePixel& p) { p.coverage = 0.5; }, samples);
        const double thinner = flowOverTheMiddle([](TruePixel& p) { p.coverage = 0.2; }, samples);
        ASSERT_GT(free, 0.01) << samples;  // there is something to hold back
        EXPECT_LT(depth, 0.002 * free) << samples;
        EXPECT_LT(turned, 0.25 * free) << samples;
        EXPECT_LT(opposed, 0.04 * free) << samples;
        EXPECT_LT(thin, 0.25 * free) << samples;
        EXPECT_LT(thinner, 0.03 * free) << samples;
    }
}

TEST(Denoise, LeavesAUniformPictureAsItIs) {
    const TruePicture picture(24, 20, [](int, int) { return TruePixel{}; });
    DenoiseFilm film = picture.film(0, 1);
    for (std::size_t i = 0; i < film.sums.size(); ++i) {
        film.sums[i] = 4.0 * picture.truth(i);
        film.counts[i] = 4;
        film.squares[i] = 4.0;
    }
    for (const glm::dvec4& pixel : denoised(picture, film)) {
        for (int c = 0; c < 4; ++c) EXPECT_NEAR(pixel[c], picture.truth(0)[c], 1e-12);
    }
}

TEST(Denoise, LowersTheErrorOfLightAndOfAlphaAtEveryNumberOfSamples) {
    const TruePicture picture = scenery(48);
    double last = 1e9;
    for (const std::uint32_t samples : {1u, 4u, 16u, 64u, 256u, 1024u}) {
        const DenoiseFilm film = picture.film(samples, samples);
        const double plain = meanSquaredError(picture, means(film));
        const double filtered = meanSquaredError(picture, denoised(picture, film));
        EXPECT_LT(filtered, (samples <= 16 ? 0.5 : 1.0) * plain) << samples;
        EXPECT_LT(filtered, last) << samples;  // towards the truth
        last = filtered;
        const auto result = denoised(picture, film);
        double alphaPlain = 0.0;
        double alphaFiltered = 0.0;
        for (std::size_t i = 0; i < result.size(); ++i) {
            alphaPlain += std::pow(means(film)[i].w - picture.truth(i).w, 2.0);
            alphaFiltered += std::pow(result[i].w - picture.truth(i).w, 2.0);
        }
        EXPECT_LT(alphaFiltered, (samples <= 16 ? 0.5 : 1.0) * alphaPlain) << samples;
    }
}

TEST(Denoise, ManySamplesAreThePlainMeanWithinItsError) {
    const TruePicture picture = scenery(32);
    const DenoiseFilm film = picture.film(1u << 14, 3);
    const auto plain = means(film);
    const auto filtered = denoised(picture, film);
    // Of the mean of light that comes in one sample of so many, exponentially distributed.
    double squares = 0.0;
    double squaresOfAlpha = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        const TruePixel& p = picture.pixels[i];
        if (p.coverage <= 0.0) continue;
        const double perSample = p.coverage * (2.0 - p.coverage) / double(1u << 14);
        const double light = (filtered[i].x - plain[i].x) / (p.albedo.x * p.light.x * std::sqrt(perSample));
        EXPECT_LT(std::abs(light), 2.0) << i;
        squares += light * light;
        ++count;
        if (p.coverage == 1.0) {
            EXPECT_NEAR(filtered[i].w, plain[i].w, 1e-12);
        }
        const double alpha = (filtered[i].w - plain[i].w) / std::sqrt(0.16 / double(1u << 14));
        squaresOfAlpha += p.coverage < 1.0 ? alpha * alpha : 0.0;
    }
    EXPECT_LT(std::sqrt(squares / count), 0.15);
    EXPECT_LT(std::sqrt(squaresOfAlpha / count), 0.02);
}

TEST(Denoise, WhereNothingIsNothingComes) {
    const TruePicture picture = scenery(48);
    const auto filtered = denoised(picture, picture.film(1, 5));
    expectFinite(filtered);
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 6; ++x) {  // two pixels and more from the edge of coverage
            EXPECT_EQ(filtered[std::size_t(y * 48 + x)], glm::dvec4(0.0)) << x << ", " << y;
        }
    }
    const TruePicture nothing(9, 7, [](int, int) { return TruePixel{.coverage = 0.0}; });
    for (const glm::dvec4& pixel : denoised(nothing, nothing.film(4, 1))) EXPECT_EQ(pixel, glm::dvec4(0.0));
}

// A sample in matter so thin that hardly any meets it is a bright pixel among dark ones. Where it goes, all
// of its colours go: what stays must not glow in red.
TEST(Denoise, TheHueOfThinMatterStays) {
    const glm::dvec3 albedo(0.15, 0.3, 0.9);
    const TruePicture picture(64, 32, [&](int x, int) {
        TruePixel p;
        p.coverage = 0.02 * x / 64.0;
        p.albedo = albedo;
        return p;
    });
    const DenoiseFilm film = picture.film(8, 5);
    int spread = 0;
    const auto pixels = denoised(picture, film);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const glm::dvec3 light = glm::dvec3(pixels[i]) / albedo;
        EXPECT_NEAR(light.r, light.b, 1e-3 * light.b + 1e-9) << i;
        EXPECT_NEAR(light.g, light.b, 1e-3 * light.b + 1e-9) << i;
        spread += film.sums[i].w == 0.0 && pixels[i].b > 0.0 ? 1 : 0;
    }
    EXPECT_GT(spread, 200);
}

TEST(Denoise, TakesWhateverAFilmMayHold) {
    const TruePicture picture = scenery(24);
    for (const double value : {std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity(), 1e6, 1e38, -1.0}) {
        DenoiseFilm film = picture.film(4, 2);
        const std::size_t i = 12 * 24 + 10;
        film.sums[i] = glm::dvec4(value, value, value, 4.0);
        film.squares[i] = value * value;
        const auto filtered = denoised(picture, film);
        expectFinite(filtered);
    }
    // A firefly keeps its light, wherever it goes.
    DenoiseFilm film = picture.film(4, 2);
    film.sums[12 * 24 + 10] = glm::dvec4(4e6, 4e6, 4e6, 4.0);
    film.squares[12 * 24 + 10] = 1.6e13;
    EXPECT_NEAR(total(denoised(picture, film)).x / total(means(film)).x, 1.0, 1e-9);
    // No samples at all.
    expectFinite(denoised(picture, picture.film(0, 1)));
}

TEST(Denoise, TakesPicturesOfAnyShape) {
    for (const auto& [width, height] :
         {std::pair(1, 1), std::pair(1, 33), std::pair(70, 1), std::pair(3, 2)}) {
        const TruePicture picture(width, height, [](int, int) { return TruePixel{}; });
        const DenoiseFilm film = picture.film(4, 1);
        const auto filtered = denoised(picture, film);
        expectFinite(filtered);
        EXPECT_NEAR(total(filtered).y / total(means(film)).y, 1.0, 1e-9);
    }
}

// A series: the view before lay `shift` pixels to the right.
DenoiseRecord afterAShift(const TruePicture& picture, int shift, const DenoiseGuides& before,
                          float historySamples) {
    DenoiseGuides now = picture.guides();
    for (glm::dvec4& motion : now.motions) motion.x = shift;
    const DenoiseGuides still = picture.guides();
    const DenoiseRecord memory = denoiseGather(picture.push(), picture.film(16, 1), still, still, {});
    shared::DenoisePush push = picture.push();
    push.historySamples = historySamples;
    return denoiseGather(push, picture.film(4, 2), now, before, memory);
}

TEST(DenoiseHistory, CountsWhereTheSameWasSeenAndNowhereElse) {
    const TruePicture plane(32, 16, [](int, int) { return TruePixel{}; });
    const DenoiseRecord record = afterAShift(plane, 5, plane.guides(), 32);
    for (int x = 0; x < 32; ++x) {
        const double samples = record.moments[std::size_t(8 * 32 + x)].y;
        // 16 samples of the past, less since there are 4 new ones; nothing beyond the edge.
        EXPECT_NEAR(samples, x + 5 < 32 ? 4 + 16 * (1 - 4 / 128.0) : 4.0, 1e-9) << x;
    }
    // Other depth, other normal, other matter, other coverage: no history.
    const auto differs = [&](const std::function<void(TruePixel&)>& change) {
        const TruePicture other(32, 16, [&](int, int) {
            TruePixel p;
            change(p);
            return p;
        });
        return afterAShift(plane, 0, other.guides(), 32).moments[200].y == 4.0;
    };
    EXPECT_FALSE(differs([](TruePixel&) {}));
    // Four pixels are 0.4 mm wide there, and the spread of depth adds less than half of a tenth.
    EXPECT_FALSE(differs([](TruePixel& p) { p.depthMm = 100.3; }));
    EXPECT_TRUE(differs([](TruePixel& p) { p.depthMm = 100.5; }));
    EXPECT_TRUE(differs([](TruePixel& p) { p.depthMm = 99.5; }));
    EXPECT_TRUE(differs([](TruePixel& p) { p.depthMm = 110; }));
    EXPECT_TRUE(differs([](TruePixel& p) { p.normal = {1, 0, 0}; }));
    EXPECT_TRUE(differs([](TruePixel& p) { p.albedo = {0.1, 0.1, 0.9}; }));
    EXPECT_TRUE(differs([](TruePixel& p) { p.coverage = 0.6; }));
    EXPECT_EQ(afterAShift(plane, 0, plane.guides(), 0).moments[200].y, 4.0);
}

TEST(DenoiseHistory, LowersTheErrorAndFadesAsSamplesComeIn) {
    const TruePicture picture = scenery(48);
    const DenoiseGuides guides = picture.guides();
    const DenoiseRecord memory = denoiseGather(picture.push(), picture.film(16, 1), guides, guides, {});
    shared::DenoisePush push = picture.push();
    push.historySamples = 32;
    const auto error = [&](std::uint32_t samples, bool history) {
        push.historySamples = history ? 32.0f : 0.0f;
        return meanSquaredError(
            picture,
            denoised(push, denoiseGather(push, picture.film(samples, 9), guides, guides, memory), guides));
    };
    EXPECT_LT(error(1, true), 0.7 * error(1, false));
    const DenoiseFilm film = picture.film(256, 9);
    push.historySamples = 32.0f;
    EXPECT_EQ(denoiseGather(push, film, guides, guides, memory).means,
              denoiseGather(picture.push(), film, guides, guides, {}).means);
}

}  // namespace
}  // namespace macula::trace
