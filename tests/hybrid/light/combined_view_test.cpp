// Two pictures of one view, combined.
#include "pipeline/hybrid/light/combined_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace macula::hybrid {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

TracedView view(const glm::ivec2& sizePx, const glm::vec4& pixel) {
    return {.sizePx = sizePx,
            .rgba = std::vector<glm::vec4>(std::size_t(sizePx.x) * std::size_t(sizePx.y), pixel),
            .samplesPerPixel = 4.0};
}

bool isFinite(const glm::vec4& p) {
    return std::isfinite(p.r) && std::isfinite(p.g) && std::isfinite(p.b) && std::isfinite(p.a);
}

// All pixels with all, in double.
std::vector<glm::dvec4> slowly(const TracedView& traced, const TracedView& lit, double share) {
    const glm::ivec2 size = lit.sizePx;
    const auto at = [&](int x, int y) { return std::size_t(y) * std::size_t(size.x) + std::size_t(x); };
    std::vector<glm::dvec4> pixels;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const glm::dvec4 own(traced.rgba[at(x, y)]);
            const glm::dvec4 here(lit.rgba[at(x, y)]);
            if (!isFinite(lit.rgba[at(x, y)])) {
                pixels.push_back(own);
                continue;
            }
            glm::dvec3 wanted(0.0);
            glm::dvec3 had(0.0);
            for (int v = 0; v < size.y; ++v) {
                for (int u = 0; u < size.x; ++u) {
                    const glm::vec4& t = traced.rgba[at(u, v)];
                    const glm::vec4& l = lit.rgba[at(u, v)];
                    if (!isFinite(t) || !isFinite(l)) continue;
                    if (std::abs(u - x) > 48 || std::abs(v - y) > 48) continue;
                    const double weight = std::exp(-double((u - x) * (u - x) + (v - y) * (v - y)) / 512.0);
                    wanted += weight * (glm::dvec3(t) + 1e-4);
                    had += weight * (glm::dvec3(l) + 1e-4);
                }
            }
            glm::dvec3 light(here);
            if (had.x > 0.0) light *= glm::clamp(wanted / had, 0.5, 2.0);
            if (isFinite(traced.rgba[at(x, y)])) light = glm::mix(light, glm::dvec3(own), share);
            pixels.emplace_back(light, here.a);
        }
    }
    return pixels;
}

TEST(CombinedView, IsThatOfTheSlowWay) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> even(0.0f, 1.0f);
    for (const glm::ivec2 sizePx :
         {glm::ivec2(70, 61), glm::ivec2(1, 1), glm::ivec2(130, 3), glm::ivec2(2, 140)}) {
        TracedView traced = view(sizePx, {});
        TracedView lit = traced;
        for (std::size_t i = 0; i < lit.rgba.size(); ++i) {
            const float alpha = even(random) < 0.2f ? 0.0f : even(random);
            lit.rgba[i] = {alpha * even(random), alpha * 0.3f * even(random), alpha * 8.0f * even(random),
                           alpha};
            traced.rgba[i] =
                lit.rgba[i] * glm::vec4(3.0f * even(random), 0.3f * even(random), 2.0f * even(random), 1);
            if (even(random) < 0.05f) lit.rgba[i] = glm::vec4(kNan);
            if (even(random) < 0.05f) traced.rgba[i].g = even(random) < 0.5f ? kNan : kInfinity;
        }
        const TracedView both = combined(traced, lit, 0.3);
        const std::vector<glm::dvec4> expected = slowly(traced, lit, 0.3);
        for (std::size_t i = 0; i < expected.size(); ++i) {
            for (int c = 0; c < 4; ++c) {
                const double e = expected[i][c];
                if (std::isfinite(e))
                    ASSERT_NEAR(double(both.rgba[i][c]), e, 2e-5 * (1.0 + std::abs(e))) << i << " " << c;
                else
                    ASSERT_FALSE(std::isfinite(both.rgba[i][c])) << i << " " << c;
            }
        }
    }
}

// Detail and coverage of what is lit, light of what is traced.
TEST(CombinedView, HasTheDetailOfOneAndTheLightOfTheOther) {
    const glm::ivec2 sizePx(128, 128);
    std::mt19937 random(5);
    std::exponential_distribution<float> noise(1.0f);
    TracedView lit = view(sizePx, {});
    TracedView traced = view(sizePx, {});
    for (std::size_t i = 0; i < lit.rgba.size(); ++i) {
        const float checks = (i % 128 / 2 + i / 256) % 2 == 0 ? 0.2f : 0.6f;
        lit.rgba[i] = {1.3f * checks, 0.8f * checks, checks, 0.9f};
        traced.rgba[i] = {checks * noise(random), checks * noise(random), checks * noise(random), 0.7f};
    }
    const TracedView both = combined(traced, lit, 0.0);
    EXPECT_EQ(both.samplesPerPixel, 4.0);
    for (std::size_t i = 0; i < lit.rgba.size(); ++i) {
        const float checks = lit.rgba[i].b;
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(both.rgba[i][c], checks, 0.15f * checks) << i;
        EXPECT_EQ(both.rgba[i].a, 0.9f);
    }
}

// Pixel after pixel in float, adding up in the same order.
std::vector<glm::vec4> pixelByPixel(const TracedView& traced, const TracedView& lit, double share) {
    const glm::ivec2 size = lit.sizePx;
    std::vector<glm::vec3> wanted(lit.rgba.size(), glm::vec3(0.0f));
    std::vector<glm::vec3> had = wanted;
    for (std::size_t i = 0; i < lit.rgba.size(); ++i) {
        if (!isFinite(traced.rgba[i]) || !isFinite(lit.rgba[i])) continue;
        wanted[i] = glm::vec3(traced.rgba[i]) + 1e-4f;
        had[i] = glm::vec3(lit.rgba[i]) + 1e-4f;
    }
    const auto blurredAlong = [&](const std::vector<glm::vec3>& from, const glm::ivec2& way) {
        std::vector<glm::vec3> to;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                glm::vec3 sum(0.0f);
                for (int n = -48; n <= 48; ++n) {
                    const glm::ivec2 at = glm::ivec2(x, y) + n * way;
                    if (at.x < 0 || at.y < 0 || at.x >= size.x || at.y >= size.y) continue;
                    const auto weight = static_cast<float>(std::exp(-double(n) * n / 512.0));
                    sum += weight * from[std::size_t(at.y) * std::size_t(size.x) + std::size_t(at.x)];
                }
                to.push_back(sum);
            }
        }
        return to;
    };
    wanted = blurredAlong(blurredAlong(wanted, {1, 0}), {0, 1});
    had = blurredAlong(blurredAlong(had, {1, 0}), {0, 1});
    std::vector<glm::vec4> pixels = traced.rgba;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (!isFinite(lit.rgba[i])) continue;
        glm::vec3 light(lit.rgba[i]);
        if (had[i].x > 0.0f) light *= glm::clamp(wanted[i] / had[i], 0.5f, 2.0f);
        if (isFinite(traced.rgba[i])) light = glm::mix(light, glm::vec3(traced.rgba[i]), float(share));
        pixels[i] = glm::vec4(light, lit.rgba[i].a);
    }
    return pixels;
}

// How many numbers are summed side by side changes none.
TEST(CombinedView, IsTheSameBitsInWhateverGroups) {
    std::mt19937 random(8);
    std::exponential_distribution<float> light(1.0f);
    for (const glm::ivec2 sizePx :
         {glm::ivec2(1, 1), glm::ivec2(1, 60), glm::ivec2(75, 1), glm::ivec2(32, 20), glm::ivec2(43, 51)}) {
        TracedView traced = view(sizePx, {});
        TracedView lit = traced;
        for (std::size_t i = 0; i < lit.rgba.size(); ++i) {
            lit.rgba[i] = {light(random), light(random), 0.0f, 0.5f};
            traced.rgba[i] = {light(random), 0.0f, light(random), 0.5f};
            if (i % 13 == 5) lit.rgba[i] = glm::vec4(kNan);
            if (i % 17 == 5) traced.rgba[i].g = kInfinity;
        }
        const std::vector<glm::vec4> expected = pixelByPixel(traced, lit, 0.2);
        const TracedView both = combined(traced, lit, 0.2);
        ASSERT_EQ(both.rgba.size(), expected.size());
        EXPECT_EQ(std::memcmp(both.rgba.data(), expected.data(), expected.size() * sizeof(glm::vec4)), 0)
            << sizePx.x << " x " << sizePx.y;
    }
}

TEST(CombinedView, DoesNotTrustWhatIsFarOff) {
    const TracedView both =
        combined(view({8, 8}, {5.0f, 0.0f, 0.5f, 1.0f}), view({8, 8}, {0.5f, 0.5f, 0.5f, 1.0f}), 0.0);
    for (const glm::vec4& pixel : both.rgba) {
        EXPECT_NEAR(pixel.r, 1.0f, 1e-6f);
        EXPECT_NEAR(pixel.g, 0.25f, 1e-6f);
        EXPECT_NEAR(pixel.b, 0.5f, 1e-6f);
    }
}

TEST(CombinedView, IsWhatIsKnownOfEither) {
    const glm::vec4 grey(0.25f, 0.25f, 0.25f, 0.5f);
    for (const float unknown : {kNan, kInfinity, -kInfinity}) {
        for (const glm::vec4& pixel :
             combined(view({4, 4}, grey), view({4, 4}, glm::vec4(unknown)), 0.5).rgba)
            EXPECT_EQ(pixel, grey);
        for (const glm::vec4& pixel :
             combined(view({4, 4}, glm::vec4(unknown)), view({4, 4}, grey), 0.5).rgba)
            EXPECT_EQ(pixel, grey);
    }
    const TracedView neither = combined(view({4, 4}, glm::vec4(kNan)), view({4, 4}, glm::vec4(kNan)), 0.5);
    for (const glm::vec4& pixel : neither.rgba) EXPECT_TRUE(std::isnan(pixel.r));
    const glm::vec4 nothing(0.0f);
    for (const glm::vec4& pixel : combined(view({4, 4}, nothing), view({4, 4}, nothing), 0.5).rgba)
        EXPECT_EQ(pixel, nothing);
    EXPECT_TRUE(combined(view({0, 0}, {}), view({0, 0}, {}), 0.5).rgba.empty());
}

// A float ends at 3.4e38; light at 10^6 (light_in_space.h), of which a pixel has 10^4 around it.
TEST(CombinedView, IsFiniteAtTheExtremes) {
    const float denormal = std::numeric_limits<float>::denorm_min();
    for (const float a : {1e6f, 1.0f, 1e-20f, denormal, 0.0f}) {
        for (const float b : {1e6f, 1.0f, 1e-20f, denormal, 0.0f}) {
            for (const float alpha : {1.0f, 1e-20f, denormal}) {
                const TracedView both =
                    combined(view({100, 100}, {a, a, a, alpha}), view({100, 100}, {b, b, b, alpha}), 0.25);
                for (const glm::vec4& pixel : both.rgba) {
                    ASSERT_TRUE(isFinite(pixel));
                    ASSERT_GE(pixel.r, std::min(a, 0.5f * b));
                    ASSERT_LE(pixel.r, std::max(a, 2.0f * b));
                }
            }
        }
    }
}

}  // namespace
}  // namespace macula::hybrid
