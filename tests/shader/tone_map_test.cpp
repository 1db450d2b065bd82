// The tone maps of shaders/lib/picture.glsl, and the measure by which one of them was chosen beside the
// neutral one (docs/measurements/tone-map.md).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "shader/shader_lib.h"

namespace macula {
namespace {

using vec3 = glm::dvec3;

// OKLab by its definition, from CIE XYZ under D65: other matrices than those of the shader, which has their
// product with that of sRGB.
vec3 oklabByXyz(const vec3& rgb) {
    const glm::dmat3 xyzFromRgb(0.4123907993, 0.2126390059, 0.0193308187, 0.3575843394, 0.7151686788,
                                0.1191947798, 0.1804807884, 0.0721923154, 0.9505321522);
    const glm::dmat3 lmsFromXyz(0.8189330101, 0.0329845436, 0.0482003018, 0.3618667424, 0.9293118715,
                                0.2643662691, -0.1288597137, 0.0361456387, 0.6338517070);
    const glm::dmat3 labFromRoots(0.2104542553, 1.9779984951, 0.0259040371, 0.7936177850, -2.4285922050,
                                  0.7827717662, -0.0040720468, 0.4505937099, -0.8086757660);
    const vec3 lms = lmsFromXyz * (xyzFromRgb * rgb);
    return labFromRoots * vec3(std::cbrt(lms.x), std::cbrt(lms.y), std::cbrt(lms.z));
}

// CIE 1976, D65.
vec3 cielab(const vec3& rgb) {
    const auto f = [](double t) {
        return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    };
    const double x = f(glm::dot(vec3(0.4123907993, 0.3575843394, 0.1804807884), rgb) / 0.95047);
    const double y = f(glm::dot(vec3(0.2126390059, 0.7151686788, 0.0721923154), rgb));
    const double z = f(glm::dot(vec3(0.0193308187, 0.1191947798, 0.9505321522), rgb) / 1.08883);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

double luminanceOf(const vec3& c) {
    return glm::dot(vec3(0.2126, 0.7152, 0.0722), c);
}

double encoded(double c) {
    return ShaderLibTwofold().encodeSrgb(c);
}

vec3 neutral(const vec3& c) {
    return ShaderLibTwofold().toneMapNeutral(c);
}
vec3 hue(const vec3& c) {
    return ShaderLibTwofold().toneMapHue(c);
}

// The two that were measured besides. Reinhard's curve on channels and on luminance, mixed by the former
// (Jodie).
vec3 reinhardJodie(const vec3& c) {
    const double light = luminanceOf(c);
    vec3 mapped;
    for (int k = 0; k < 3; ++k) {
        const double ofChannel = c[k] / (1.0 + c[k]);
        mapped[k] = glm::mix(c[k] / (1.0 + light), ofChannel, ofChannel);
    }
    return mapped;
}

// As AgX is built: primaries drawn in to white, a sigmoid of the logarithm of each, primaries drawn out
// again. The sigmoid has slope 2.4 at 18 % grey, from 10 stops below to white 4 stops above 1 / 16 of it.
vec3 likeAgx(const vec3& c) {
    constexpr double kIn = 0.18;
    constexpr double kStops = 14.026;
    constexpr double kPivot = 10.0 / kStops;
    constexpr double kSlope = 2.4;
    const auto sigmoid = [](double light) {
        const double x = std::clamp((std::log2(std::max(light, 1e-10) / 0.18) + 10.0) / kStops, 0.0, 1.0);
        const double side = x > kPivot ? 1.0 : -1.0;
        const double room = x > kPivot ? 1.0 - kPivot : kPivot;
        const double power = x > kPivot ? 3.25 : 3.0;
        const double full = kSlope * room;
        const double scale =
            std::pow(std::pow(full, -power) * (std::pow(full / 0.5, power) - 1.0), -1.0 / power);
        const double t = kSlope * std::abs(x - kPivot) / scale;
        return 0.5 + side * scale * t / std::pow(1.0 + std::pow(t, power), 1.0 / power);
    };
    const double white = (c.x + c.y + c.z) / 3.0;
    vec3 mapped;
    for (int k = 0; k < 3; ++k) mapped[k] = sigmoid(glm::mix(c[k], white, kIn));
    const double mean = (mapped.x + mapped.y + mapped.z) / 3.0;
    for (int k = 0; k < 3; ++k)
        mapped[k] = std::pow(std::clamp((mapped[k] - mean * kIn) / (1.0 - kIn), 0.0, 1.0), 2.2);
    return mapped;
}

// Bone, muscle, fat, skin, liver, lung, artery, vein, connective tissue, spleen.
const std::vector<vec3>& tissues() {
    static const std::vector<vec3> kAll{
        {0.95, 0.9, 0.8},  {0.6, 0.15, 0.12}, {0.9, 0.75, 0.4}, {0.85, 0.6, 0.48}, {0.45, 0.18, 0.13},
        {0.8, 0.55, 0.55}, {0.8, 0.1, 0.08},  {0.2, 0.3, 0.7},  {0.7, 0.35, 0.3},  {0.55, 0.1, 0.15}};
    return kAll;
}

// Red, yellow, green, cyan, blue and magenta in three saturations.
std::vector<vec3> saturated() {
    std::vector<vec3> all;
    for (const double saturation : {1.0, 0.8, 0.5})
        for (unsigned i = 1; i < 7; ++i)
            all.emplace_back((i & 1u) != 0 ? 1.0 : 1.0 - saturation, (i & 2u) != 0 ? 1.0 : 1.0 - saturation,
                             (i & 4u) != 0 ? 1.0 : 1.0 - saturation);
    return all;
}

double hueDegrees(const vec3& lab) {
    return glm::degrees(std::atan2(lab.z, lab.y));
}
double shiftDegrees(const vec3& from, const vec3& to) {
    return std::abs(std::remainder(hueDegrees(to) - hueDegrees(from), 360.0));
}

// Over some colours at one exposure. Hues count where the mapped colour has any: a chroma of 0.02 in OKLab.
struct Measured {
    double meanOklab = 0.0;  // degrees
    double mostOklab = 0.0;
    double meanCielab = 0.0;
    double mostCielab = 0.0;
    double contrast = 0.0;  // shown luminance that a fifth of the light makes, mean
    double outside = 0.0;   // how far a channel lies beyond 0 to 1, at most
};

Measured measured(const std::function<vec3(const vec3&)>& map, const std::vector<vec3>& colours,
                  double exposure) {
    constexpr double kColourful = 0.02;
    Measured m;
    double hues = 0.0;
    for (const vec3& colour : colours) {
        const vec3 light = exposure * colour;
        const vec3 shown = map(light);
        const vec3 lab = oklabByXyz(shown);
        m.contrast += encoded(luminanceOf(shown)) - encoded(luminanceOf(map(0.8 * light)));
        for (int k = 0; k < 3; ++k) m.outside = std::max({m.outside, shown[k] - 1.0, -shown[k]});
        if (std::hypot(lab.y, lab.z) < kColourful) continue;
        hues += 1.0;
        const double inOklab = shiftDegrees(oklabByXyz(light), lab);
        const double inCielab = shiftDegrees(cielab(light), cielab(shown));
        m.meanOklab += inOklab;
        m.meanCielab += inCielab;
        m.mostOklab = std::max(m.mostOklab, inOklab);
        m.mostCielab = std::max(m.mostCielab, inCielab);
    }
    m.meanOklab /= hues;
    m.meanCielab /= hues;
    m.contrast /= double(colours.size());
    return m;
}

// Prints the tables of docs/measurements/tone-map.md.
TEST(ToneMaps, TheOneOfHueTurnsTissueLeastByTwoMeasures) {
    const std::array<std::pair<const char*, std::function<vec3(const vec3&)>>, 4> maps{
        {{"neutral", neutral}, {"Reinhard-Jodie", reinhardJodie}, {"like AgX", likeAgx}, {"hue", hue}}};
    for (const bool isTissue : {true, false}) {
        const std::vector<vec3> colours = isTissue ? tissues() : saturated();
        fmt::print("{}\n", isTissue ? "tissue" : "saturated");
        for (const double exposure : {0.25, 1.0, 2.0, 4.0, 8.0}) {
            std::array<Measured, 4> m;
            for (std::size_t i = 0; i < maps.size(); ++i) {
                m[i] = measured(maps[i].second, colours, exposure);
                fmt::print("| {:g} | {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.3f} | {:.2f} |\n", exposure,
                           maps[i].first, m[i].meanOklab, m[i].mostOklab, m[i].meanCielab, m[i].mostCielab,
                           m[i].contrast, m[i].outside);
            }
            EXPECT_LT(m[3].mostOklab, 0.5) << exposure;
            EXPECT_LE(m[3].outside, 1e-12) << exposure;
            for (std::size_t other = 0; other < 3; ++other) {
                EXPECT_LE(m[3].meanOklab, m[other].meanOklab) << maps[other].first << exposure;
                if (isTissue) {
                    EXPECT_LE(m[3].meanCielab, m[other].meanCielab) << maps[other].first << exposure;
                }
            }
        }
    }
}

TEST(ToneMaps, TheOneOfHueLeavesWhatIsNotBrightAsItIs) {
    ShaderLibTwofold lib;
    // Grey of a lightness of 0.7 has 0.343 of light.
    for (const vec3& colour :
         {vec3(0.0), vec3(1e-6, 0.0, 0.0), vec3(0.3), vec3(0.5, 0.1, 0.05), vec3(0, 0, 1)})
        EXPECT_EQ(lib.toneMapHue(colour), colour);
    EXPECT_NEAR(lib.toneMapHue(vec3(8.0)).x, 1.0, 1e-9) << "white begins at eight times the light of white";
    EXPECT_LT(lib.toneMapHue(vec3(7.5)).x, 1.0 - 1e-4);
}

TEST(ToneMaps, TheOneOfHueKeepsTheOrderOfLightness) {
    ShaderLibTwofold lib;
    for (const std::vector<vec3>& colours : {tissues(), saturated()}) {
        for (const vec3& colour : colours) {
            double last = -1.0;
            for (double light = 1e-4; light < 1e4; light *= 1.02) {
                const double lightness = oklabByXyz(lib.toneMapHue(light * colour)).x;
                ASSERT_GE(lightness, last - 1e-4)
                    << light << " of " << colour.x << " " << colour.y << " " << colour.z;
                last = lightness;
            }
            ASSERT_NEAR(last, 1.0, 1e-3);
        }
    }
}

// Neither at the shoulder nor where a channel reaches 1 is there a step: a little more light is a little
// more.
TEST(ToneMaps, TheOneOfHueHasNoSteps) {
    ShaderLibTwofold lib;
    constexpr double kStep = 1e-4;
    for (const std::vector<vec3>& colours : {tissues(), saturated()}) {
        for (const vec3& colour : colours) {
            for (double light = 0.2; light < 12.0; light *= 1.0 + kStep) {
                const vec3 a = lib.toneMapHue(light * colour);
                const vec3 b = lib.toneMapHue(light * (1.0 + kStep) * colour);
                // Halvings are exact to 2^-16 of the chroma.
                ASSERT_LT(glm::length(b - a), 4.0 * kStep * light + 1e-4) << light;
            }
        }
    }
}

TEST(ToneMaps, TheOneOfHueStaysOnTheDisplayAtTheExtremes) {
    ShaderLibSingle lib;
    constexpr float kMost = std::numeric_limits<float>::max();
    constexpr float kLeast = std::numeric_limits<float>::denorm_min();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (const float r : {0.0f, kLeast, 1e-20f, 1.0f, 1e6f, kMost, kInfinity}) {
        for (const float g : {0.0f, kLeast, 1e-20f, 1.0f, 1e6f, kMost, kInfinity}) {
            for (const float b : {0.0f, kLeast, 1e-20f, 1.0f, 1e6f, kMost, kInfinity}) {
                const auto shown = lib.toneMapHue({r, g, b});
                for (int k = 0; k < 3; ++k) {
                    ASSERT_GE(shown[k], 0.0f) << r << " " << g << " " << b;
                    ASSERT_LE(shown[k], 1.0f) << r << " " << g << " " << b;
                }
                // What is that bright in any colour is white.
                if (std::max({r, g, b}) >= 1e6f) {
                    ASSERT_GT(std::min({shown.x, shown.y, shown.z}), 0.999f) << r << " " << g << " " << b;
                }
            }
        }
    }
}

TEST(ToneMaps, FloatsShowWhatDoublesShow) {
    ShaderLibSingle single;
    ShaderLibTwofold twofold;
    for (const std::vector<vec3>& colours : {tissues(), saturated()}) {
        for (const vec3& colour : colours) {
            for (double light = 1e-3; light < 100.0; light *= 1.1) {
                const vec3 exact = twofold.toneMapHue(light * colour);
                const auto shown = single.toneMapHue(ShaderLibSingle::vec3(light * colour));
                for (int k = 0; k < 3; ++k)
                    ASSERT_NEAR(encoded(double(shown[k])), encoded(exact[k]), 0.1 / 255.0) << light;
            }
        }
    }
}

// Grey faces and projections show what the window says, whichever tone map is used.
TEST(ToneMaps, GreyComesOutAsItWasMeant) {
    ShaderLibSingle single;
    ShaderLibTwofold twofold;
    for (int step = 0; step <= 1000; ++step) {
        const double grey = step / 1000.0;
        for (const bool keepsHue : {false, true}) {
            const double light = twofold.greyBeforeToneMap(grey, keepsHue);
            const double shown = encoded(twofold.toneMapped(vec3(light), keepsHue).x);
            // The neutral map has no light for white.
            EXPECT_NEAR(shown, grey, keepsHue || grey < 0.995 ? 1e-6 : 0.0025) << keepsHue;
            const float inFloat = single.greyBeforeToneMap(float(grey), keepsHue);
            const auto mapped = single.toneMapped(ShaderLibSingle::vec3(inFloat), keepsHue);
            EXPECT_NEAR(double(single.encodeSrgb(mapped.y)), shown, 0.05 / 255.0) << keepsHue << grey;
        }
        // What the estimate of noise takes for it, and what it is.
        const double light = 10.0 * grey * grey;
        EXPECT_NEAR(twofold.greyOfToneMapHue(light), twofold.toneMapHue(vec3(light)).x, 1e-6);
    }
}

}  // namespace
}  // namespace macula
