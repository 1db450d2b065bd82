#include "pipeline/trace/environment.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <random>

#include "pipeline/trace/reference_tracer.h"
#include "shader/statistics.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

constexpr double kPi = std::numbers::pi;

double solidAngle(int row, int width, int height) {
    return (std::cos(kPi * row / height) - std::cos(kPi * (row + 1) / height)) * 2.0 * kPi / width;
}

// The integral of red radiance over the sphere.
double redPower(const Environment& sky) {
    double power = 0.0;
    for (int row = 0; row < sky.height(); ++row) {
        for (int x = 0; x < sky.width(); ++x) {
            power += double(sky.texels()[std::size_t(row * sky.width() + x)].radiance.r) *
                     solidAngle(row, sky.width(), sky.height());
        }
    }
    return power;
}

struct Sampled {
    std::vector<ReferenceTracer::Light> lights;
    Environment environment;
};

Sampled sample(const Environment& environment, std::uint32_t count) {
    const auto volume = scenes::volumeOf({1, 1, 1}, glm::dmat4(1.0), [](int, int, int) { return 1; });
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), scenes::homogeneous(1.0));
    const auto params = makeTraceParams(*volume, medium, environment, {}, {.seed = 11});
    return {ReferenceTracer(*volume, medium, environment).sampleEnvironment(*params, count), environment};
}

Environment noisySky(int width, int height) {
    std::mt19937 random(3);
    std::vector<glm::vec3> radiance(std::size_t(width) * std::size_t(height));
    for (glm::vec3& c : radiance) {
        const float u = std::uniform_real_distribution<float>(0, 1)(random);
        c = glm::vec3(u * u * u * 3, u, random() % 4 == 0 ? 0.0f : u);
    }
    radiance[std::size_t(width) * 3 + 5] = glm::vec3(400.0f);  // a sun
    for (int x = 0; x < width; ++x)
        radiance[std::size_t(width) * std::size_t(height - 1) + std::size_t(x)] = glm::vec3(0);
    return *Environment::fromImage(width, height, radiance);
}

TEST(Environment, PdfIntegratesToOne) {
    const Environment sky = noisySky(24, 12);
    double sum = 0.0;
    for (int row = 0; row < 12; ++row) {
        for (int column = 0; column < 24; ++column) {
            sum += double(sky.texels()[std::size_t(row * 24 + column)].pdfPerSr) * solidAngle(row, 24, 12);
        }
    }
    EXPECT_NEAR(sum, 1.0, 1e-6);
}

TEST(Environment, SamplesFollowThePdf) {
    constexpr std::uint32_t kSamples = 1000000;
    const auto [lights, sky] = sample(noisySky(24, 12), kSamples);
    std::vector<double> observed(24 * 12, 0.0);
    std::vector<double> expected(24 * 12, 0.0);
    for (const auto& light : lights) ++observed[std::size_t(light.texelAgain)];
    for (int row = 0; row < 12; ++row) {
        for (int column = 0; column < 24; ++column) {
            const auto i = std::size_t(row * 24 + column);
            expected[i] = double(sky.texels()[i].pdfPerSr) * solidAngle(row, 24, 12) * kSamples;
        }
    }
    EXPECT_LT(std::abs(statistics::chiSquareDeviate(observed, expected)), statistics::kDeviateLimit);
    for (int x = 0; x < 24; ++x) EXPECT_EQ(observed[std::size_t(11 * 24 + x)], 0.0);  // the black row
}

// Inside a texel directions are uniform in solid angle, not in angle: checked where it matters most, next to
// the pole.
TEST(Environment, DirectionsAreUniformInSolidAngleWithinATexel) {
    const auto [lights, sky] = sample(Environment::constant(glm::vec3(1.0f)), 500000);
    std::vector<double> observed(64, 0.0);
    for (const auto& light : lights) {
        ASSERT_NEAR(glm::length(light.direction), 1.0, 1e-6);
        ++observed[std::size_t(std::min(int((light.direction.y + 1.0) * 32.0), 63))];
    }
    const std::vector<double> expected(64, 500000.0 / 64.0);  // Archimedes: equal heights, equal areas
    EXPECT_LT(std::abs(statistics::chiSquareDeviate(observed, expected)), statistics::kDeviateLimit);
}

TEST(Environment, RadianceOverPdfIsAnUnbiasedEstimateOfTheIntegral) {
    const auto [lights, sky] = sample(noisySky(24, 12), 400000);
    double exact = 0.0;
    for (int row = 0; row < 12; ++row) {
        for (int x = 0; x < 24; ++x) {
            exact += double(sky.texels()[std::size_t(row * 24 + x)].radiance.g) * solidAngle(row, 24, 12);
        }
    }
    double sum = 0.0;
    double squares = 0.0;
    for (const auto& light : lights) {
        const double estimate = light.radiance.g / light.pdfPerSr;
        sum += estimate;
        squares += estimate * estimate;
    }
    const double n = double(lights.size());
    const double error = std::sqrt((squares / n - sum / n * (sum / n)) / n);
    EXPECT_NEAR(sum / n, exact, 4.5 * error);
    EXPECT_LT(error / exact, 0.002);
}

TEST(Environment, LargePicturesAreAveragedDownWithoutLosingPower) {
    constexpr int kWidth = 2048;
    constexpr int kHeight = 1024;
    std::vector<glm::vec3> radiance(std::size_t(kWidth) * kHeight, glm::vec3(0.5f));
    radiance[std::size_t(700) * kWidth + 333] = glm::vec3(1e6f);
    const auto sky = Environment::fromImage(kWidth, kHeight, radiance);
    ASSERT_TRUE(sky.ok());
    EXPECT_EQ(sky->width(), 1024);
    const double power = redPower(*sky);
    const double exact = 0.5 * 4.0 * kPi + (1e6 - 0.5) * solidAngle(700, kWidth, kHeight);
    EXPECT_NEAR(power / exact, 1.0, 1e-5);
}

TEST(Environment, NoPartOfAPictureOfAnySizeIsLost) {
    constexpr int kWidth = 2500;
    constexpr int kHeight = 1250;
    std::vector<glm::vec3> radiance(std::size_t(kWidth) * kHeight, glm::vec3(0.0f));
    radiance[std::size_t(600) * kWidth + 2499] = glm::vec3(1e4f);
    const auto sky = Environment::fromImage(kWidth, kHeight, radiance);
    ASSERT_TRUE(sky.ok());
    const double power = redPower(*sky);
    EXPECT_NEAR(power / (1e4 * solidAngle(600, kWidth, kHeight)), 1.0, 1e-4);
}

TEST(Environment, RefusesWhatIsNoLight) {
    const std::vector<glm::vec3> negative(2, glm::vec3(-1.0f, 0, 0));
    EXPECT_FALSE(Environment::fromImage(2, 1, negative).ok());
    const std::vector<glm::vec3> notFinite(2, glm::vec3(std::numeric_limits<float>::quiet_NaN(), 0, 0));
    EXPECT_FALSE(Environment::fromImage(2, 1, notFinite).ok());
    EXPECT_FALSE(Environment::fromImage(0, 0, {}).ok());
}

TEST(Environment, BlackSkyGivesNoLightAndNoNan) {
    const auto [lights, sky] = sample(Environment::constant(glm::vec3(0.0f)), 100);
    for (const auto& light : lights) EXPECT_EQ(light.pdfPerSr, 0.0);
}

TEST(Environment, ASoftLightShinesFromWhereTheRigSays) {
    LightRig rig;
    rig.lights = {
        {.azimuthDeg = 90, .elevationDeg = 0, .angularRadiusDeg = 10, .radiance = 5.0}};  // patient's left
    const auto [lights, sky] = sample(Environment::fromRig(rig), 1000);
    for (const auto& light : lights) EXPECT_GT(light.direction.x, std::cos(glm::radians(11.0)));
}

}  // namespace
}  // namespace macula::trace
