// How matter scatters (shaders/lib/scattering.glsl), without volume or GPU: energy, reciprocity, sampling,
// and the formulas written anew.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "base/glsl_in_cpp.h"
#include "pipeline/volume/coat.h"
#include "trace/dense_coat.h"

namespace macula::trace {
namespace {

#define OUT(type) type&
#define INOUT(type) type&
#define PI 3.14159265358979323846
template <class Real>
struct Coefficients {
    Real anisotropy = 0;
    Real surfaceAlpha = 1;
    Real surfaceReflectance = 0;
    std::array<Real, shared::kCoatPlaces> coatAlbedo{};
    Real coatMean = 0;
};
template <class Real>
Coefficients<Real> coefficientsOf(double anisotropy, const Surface& surface) {
    Coefficients<Real> c{Real(anisotropy), Real(alphaOf(surface)), Real(surface.reflectance)};
    const Coat coat = coatOf(surface);
    std::copy(coat.albedo.begin(), coat.albedo.end(), c.coatAlbedo.begin());
    c.coatMean = Real(coat.mean);
    return c;
}
struct Twofold : GlslInCpp<double> {
    static constexpr int kCoatSteps = shared::kCoatSteps;
    Coefficients<double> params;
#define float double
#include "lib/phase.glsl"
#include "lib/scattering.glsl"
#undef float
#undef GRAZING
};
struct Single : GlslInCpp<float> {
    static constexpr int kCoatSteps = shared::kCoatSteps;
    Coefficients<float> params;
#include "lib/phase.glsl"
#include "lib/scattering.glsl"
};
#undef GRAZING
#undef OUT
#undef INOUT
#undef PI

constexpr double kPi = std::numbers::pi;
const glm::dvec3 kNormal(0.0, 0.0, 1.0);

struct Case {
    double surface, roughness, reflectance, cosine, anisotropy;
};

std::vector<Case> cases() {
    std::vector<Case> all{{0.0, 0.4, 0.04, 0.6, 0.5}};
    for (const double surface : {0.4, 1.0}) {
        for (const double roughness : {0.1, 0.4, 1.0}) {
            for (const double reflectance : {0.0, 0.04, 0.8}) {
                for (const double cosine : {0.01, 0.2, 1.0})
                    all.push_back({surface, roughness, reflectance, cosine, surface < 1.0 ? 0.5 : 0.0});
            }
        }
    }
    return all;
}

Surface surfaceOf(const Case& c) {
    return {.weight = c.surface, .roughness = c.roughness, .reflectance = c.reflectance};
}
Twofold hostOf(const Case& c) {
    Twofold host;
    host.params = coefficientsOf<double>(c.anisotropy, surfaceOf(c));
    return host;
}
Twofold::Matter matterOf(const Case& c, double albedo = 1.0) {
    return {glm::dvec3(albedo), kNormal, c.surface};
}
// Along which a path falls on the surface.
glm::dvec3 fromOf(const Case& c) {
    return {std::sqrt(1.0 - c.cosine * c.cosine), 0.0, -c.cosine};
}

// Light, and means over the directions that are found: of all of them 1, and of three that do not lie alike.
struct Sums {
    double light = 0.0;
    std::array<double, 4> means{};

    void add(Twofold& host, const Case& c, const glm::dvec3& to, double perDirection, double perPdf) {
        const Twofold::Scattering there = host.scattering(matterOf(c), fromOf(c), to);
        light += there.perSr.x * (perDirection + perPdf / std::max(there.pdfPerSr, 1e-300));
        const double found = there.pdfPerSr * perDirection + perPdf;
        const auto cap = [&](const glm::dvec3& axis) {
            return std::pow(std::max(glm::dot(to, axis), 0.0), 3.0);
        };
        means[0] += found;
        means[1] += found * cap({1, 0, 0});
        means[2] += found * cap({0.6, 0.48, 0.64});
        means[3] += found * cap({0, 0, 1});
    }
};

Sums bySamples(const Case& c) {
    Twofold host = hostOf(c);
    constexpr int kSide = 48;
    constexpr int kChoices = 100;
    Sums sums;
    for (int k = 0; k < kChoices; ++k) {
        for (int j = 0; j < kSide; ++j) {
            for (int i = 0; i < kSide; ++i) {
                const glm::dvec3 to = host.scatteredDirection(
                    matterOf(c), fromOf(c), {(i + 0.5) / kSide, (j + 0.5) / kSide}, (k + 0.5) / kChoices);
                sums.add(host, c, to, 0.0, 1.0 / (kSide * kSide * kChoices));
            }
        }
    }
    return sums;
}

// Over the sphere, finest about where a smooth film reflects to, and about the plane of the path: at grazing
// angles the reflection is a narrow streak there.
Sums byIntegral(const Case& c) {
    Twofold host = hostOf(c);
    const glm::dvec3 from = fromOf(c);
    const glm::dvec3 mirror = glm::normalize(glm::dvec3(from.x, from.y, -from.z));
    const glm::dvec3 a = glm::normalize(glm::cross(mirror, glm::dvec3(0, 1, 0)));
    const glm::dvec3 b = glm::cross(mirror, a);
    constexpr int kRings = 1000;
    constexpr int kTurns = 400;
    Sums sums;
    for (int i = 0; i < kRings; ++i) {
        const double t = (i + 0.5) / kRings;
        const double theta = kPi * t * t * t;
        const double area = std::sin(theta) * 3.0 * kPi * t * t / kRings;
        for (int j = 0; j < kTurns; ++j) {
            const double u = (j + 0.5) / kTurns;
            const double turn = 2.0 * kPi * u - 0.49 * std::sin(4.0 * kPi * u);
            const double width = 2.0 * kPi * (1.0 - 0.98 * std::cos(4.0 * kPi * u)) / kTurns;
            sums.add(host, c,
                     mirror * std::cos(theta) + (a * std::cos(turn) + b * std::sin(turn)) * std::sin(theta),
                     area * width, 0.0);
        }
    }
    return sums;
}

TEST(Scattering, MakesNoLightAndFindsItsDirectionsAsItSays) {
    for (const Case& c : cases()) {
        SCOPED_TRACE(testing::Message()
                     << c.surface << " " << c.roughness << " " << c.reflectance << " " << c.cosine);
        const Sums there = byIntegral(c);
        EXPECT_LT(there.light, 1.003);
        EXPECT_GT(there.light, 0.99) << "and a white body keeps none";
        EXPECT_NEAR(there.means[0], 1.0, 4e-3);
        const Sums found = bySamples(c);
        EXPECT_NEAR(found.light, there.light, 1e-2);
        for (std::size_t i = 0; i < found.means.size(); ++i)
            EXPECT_NEAR(found.means[i], there.means[i], 6e-3) << i;
    }
}

TEST(Scattering, OfSurfacesIsTheSameThereAndBack) {
    std::mt19937_64 engine(5);
    const auto random = [&] { return double(engine() >> 11) * 0x1p-53; };
    for (int n = 0; n < 300; ++n) {
        Twofold host;
        const double roughness = 0.1 + 0.9 * random();
        host.params = coefficientsOf<double>(0.0, {.roughness = roughness, .reflectance = random()});
        const Twofold::Matter matter{glm::dvec3(random(), random(), random()), kNormal, 1.0};
        const auto upwards = [&] {
            const double z = 0.01 + 0.99 * random();
            const double turn = 2.0 * kPi * random();
            return glm::dvec3(std::sqrt(1.0 - z * z) * glm::dvec2(std::cos(turn), std::sin(turn)), z);
        };
        const glm::dvec3 a = upwards();
        const glm::dvec3 b = upwards();
        const glm::dvec3 there = host.scattering(matter, -a, b).perSr / b.z;
        const glm::dvec3 back = host.scattering(matter, -b, a).perSr / a.z;
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(there[channel], back[channel], 1e-9 * there[channel]);
    }
}

TEST(Scattering, IsThatOfThePapersInDoubleAndInFloat) {
    std::mt19937_64 engine(6);
    const auto random = [&] { return double(engine() >> 11) * 0x1p-53; };
    for (const Case& c : cases()) {
        Twofold host = hostOf(c);
        Single single;
        single.params = coefficientsOf<float>(c.anisotropy, surfaceOf(c));
        const scenes::DenseCoat coat(surfaceOf(c));
        const double g = c.anisotropy;
        for (int n = 0; n < 50; ++n) {
            const glm::dvec3 from = fromOf(c);
            // Half of them near the mirror's direction, where films differ most.
            glm::dvec3 to(2.0 * random() - 1.0, 2.0 * random() - 1.0, 2.0 * random() - 1.0);
            if (n % 2 == 0) to = glm::dvec3(from.x, from.y, -from.z) + 0.1 * to;
            to = glm::normalize(to);
            if (std::abs(to.z) < 2e-3) continue;  // grazing counts as less grazing
            const double cloud =
                0.7 * (1.0 - g * g) / (4.0 * kPi * std::pow(1.0 + g * g - 2.0 * g * glm::dot(from, to), 1.5));
            const double expected =
                (1.0 - c.surface) * cloud + c.surface * coat.perSr(kNormal, glm::dvec3(0.7), from, to).x;
            const auto twofold = host.scattering(matterOf(c, 0.7), from, to);
            // Each has its own table of the coat's albedo.
            EXPECT_NEAR(twofold.perSr.x, expected, 5e-3 * expected + 5e-3);
            const auto found = single.scattering({glm::vec3(0.7f), glm::vec3(kNormal), float(c.surface)},
                                                 glm::vec3(from), glm::vec3(to));
            EXPECT_NEAR(double(found.perSr.x), twofold.perSr.x, 2e-3 * expected + 1e-6);
            EXPECT_NEAR(double(found.pdfPerSr), twofold.pdfPerSr, 2e-3 * twofold.pdfPerSr + 1e-6);
        }
    }
}

TEST(Scattering, StaysANumberAtTheExtremes) {
    for (const double roughness : {0.1, 1.0}) {
        for (const double reflectance : {0.0, 1.0}) {
            Single host;
            host.params = coefficientsOf<float>(0.0, {.roughness = roughness, .reflectance = reflectance});
            for (const glm::vec3& from : {glm::vec3(0, 0, -1), glm::vec3(1, 0, 0), glm::vec3(1, 0, -1e-7f),
                                          glm::vec3(0, 1, -1e-30f)}) {
                const Single::Matter matter{glm::vec3(1.0f), glm::vec3(kNormal), 1.0f};
                for (const float u : {0.0f, 0.5f, 1.0f - 0x1p-24f}) {
                    for (const float v : {0.0f, 0.5f, 1.0f - 0x1p-24f}) {
                        for (const float choice : {0.0f, 0.5f, 1.0f - 0x1p-24f}) {
                            const glm::vec3 to = host.scatteredDirection(matter, from, {u, v}, choice);
                            EXPECT_NEAR(glm::length(to), 1.0f, 1e-5f);
                            const auto found = host.scattering(matter, from, to);
                            const float weight = found.perSr.x / std::max(found.pdfPerSr, 1e-20f);
                            EXPECT_TRUE(std::isfinite(found.perSr.x) && found.perSr.x >= 0.0f);
                            EXPECT_TRUE(std::isfinite(found.pdfPerSr) && found.pdfPerSr >= 0.0f);
                            EXPECT_LT(weight, 25.0f) << "no path gets much stronger at once";
                        }
                    }
                }
                for (const glm::vec3& to :
                     {from, -from, glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::vec3(0, -1, 0)}) {
                    const auto found = host.scattering(matter, from, to);
                    EXPECT_TRUE(std::isfinite(found.perSr.x) && found.perSr.x >= 0.0f);
                    EXPECT_TRUE(std::isfinite(found.pdfPerSr) && found.pdfPerSr >= 0.0f);
                }
            }
        }
    }
    // No surface, and no normal.
    const Single::Matter cloud{glm::vec3(0.5f), glm::vec3(0.0f), 0.0f};
    const auto found = Single().scattering(cloud, {0, 0, 1}, {0, 1, 0});
    EXPECT_NEAR(found.perSr.x, 0.5f / (4.0f * float(kPi)), 1e-6f);
}

}  // namespace
}  // namespace macula::trace
