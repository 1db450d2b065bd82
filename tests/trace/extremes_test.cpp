// The tracers at the ends of what may come: coverage against a dense march in double, float against double,
// everything finite. The errors measured here stand in docs/numerical-limits.md.
#include <gtest/gtest.h>

#include "pipeline/trace/reference_tracer.h"
#include "trace/dense_march.h"
#include "trace/extreme_scenes.h"

namespace macula::trace {
namespace {

class Extremes : public ::testing::TestWithParam<scenes::ExtremeScene> {};

// Mean coverage of the picture, by rays through points that fill it evenly without a grid (the R2 sequence):
// edges along rows or columns would meet a grid's lines.
double denseCoverage(const scenes::ExtremeScene& scene) {
    const CameraBasis eye = *basis(scene.view.camera);
    const double half = std::tan(glm::radians(scene.view.camera.verticalFovDeg) / 2.0);
    constexpr int kRays = 20000;
    constexpr int kStepsPerVoxel = 8;
    double sum = 0.0;
    for (int n = 1; n <= kRays; ++n) {
        const double x = 2.0 * std::fmod(n * 0.7548776662466927, 1.0) - 1.0;
        const double y = 2.0 * std::fmod(n * 0.5698402909980532, 1.0) - 1.0;
        const glm::dvec3 direction =
            glm::normalize(eye.forward + eye.right * (x * half) + eye.up * (y * half));
        sum -= std::expm1(-scenes::opticalDepth(*scene.volume, scene.function, scene.view.camera.positionMm,
                                                direction, kStepsPerVoxel));
    }
    return sum / kRays;
}

TEST_P(Extremes, coverageIsThatOfADenseMarch) {
    const scenes::ExtremeScene& scene = GetParam();
    const Medium medium = makeMedium(*scene.volume, makeBrickGrid(*scene.volume), scene.function);
    const ReferenceTracer tracer(*scene.volume, medium, scene.environment);
    const double exact = denseCoverage(scene);
    constexpr std::uint32_t kSamples = 256;
    const double pixels = double(scene.view.width) * scene.view.height;
    glm::dvec4 means[2];
    for (const Precision precision : {Precision::single, Precision::twofold}) {
        const auto params = makeTraceParams(*scene.volume, medium, scene.environment, scene.view,
                                            {.bounces = 2, .seed = 77, .filter = Filter::trilinear});
        ASSERT_TRUE(params) << params.error().message;
        glm::dvec4 sum(0.0);
        double variance = 0.0;
        for (const glm::dvec4& pixel : tracer.trace(*params, Filter::trilinear, precision, 0, kSamples)) {
            for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(pixel[c]));
            const double p = pixel.a / kSamples;
            variance += p * (1.0 - p) / kSamples;
            sum += pixel / double(kSamples);
        }
        const glm::dvec4 mean = sum / pixels;
        means[precision == Precision::twofold ? 1 : 0] = mean;
        // Pixels are sampled at random points here and at nine there: that error falls with the number of
        // pixels.
        const double error = std::sqrt(variance) / pixels;
        EXPECT_NEAR(mean.a, exact, 5.0 * error + scene.tolerance + 2e-3 * exact)
            << "precision " << int(precision);
        if (precision == Precision::single) {
            RecordProperty("coverage", std::to_string(exact));
            RecordProperty("errorMillionths", static_cast<int>(1e6 * (mean.a - exact)));
            RecordProperty("chanceMillionths", static_cast<int>(1e6 * error));
        }
    }
    RecordProperty("floatMillionths", static_cast<int>(1e6 * (means[0].a - means[1].a)));
    EXPECT_NEAR(means[0].a, means[1].a, 5e-3 * means[1].a + 1e-6)
        << "float and double, the same random numbers";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Extremes, ::testing::ValuesIn(scenes::extremeScenes()), [](const auto& p) {
    std::string name;
    for (const char c : p.param.name) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
});

// How far float takes a ray off its way: where it meets the volume, at every distance and size of voxel.
TEST(Extremes, raysMeetTheVolumeWhereTheyShould) {
    const glm::ivec3 size(64, 64, 64);
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    for (const double voxelMm : {0.01, 0.1, 1.0, 50.0}) {
        const auto volume = scenes::volumeOf(size, scenes::grid(glm::dvec3(voxelMm), size, {1e5, 0, 0}),
                                             [](int, int, int) { return 1; });
        const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), scenes::homogeneous(1.0));
        const ReferenceTracer tracer(*volume, medium, sky);
        for (const double distanceMm : {1.0, 100.0, 1e4}) {
            double largest = 0.0;
            for (int n = 1; n <= 500; ++n) {
                const double azimuth = n * 2.399963;
                const double z = 1.0 - 2.0 * std::fmod(n * 0.618034, 1.0);
                const glm::dvec3 out(std::sqrt(1 - z * z) * std::cos(azimuth),
                                     std::sqrt(1 - z * z) * std::sin(azimuth), z);
                const trace::View view{
                    .camera = {.positionMm = glm::dvec3(1e5, 0, 0) + out * (distanceMm + 56.0 * voxelMm),
                               .targetMm = {1e5, 0, 0},
                               .up = {out.y, out.z, out.x}}};
                const auto params = makeTraceParams(*volume, medium, sky, view, {});
                if (!params) continue;
                const auto exact =
                    tracer.segments(*params, Precision::twofold, glm::dvec3(params->originVoxel), -out);
                const auto rough =
                    tracer.segments(*params, Precision::single, glm::dvec3(params->originVoxel), -out);
                ASSERT_FALSE(exact.empty());
                ASSERT_FALSE(rough.empty());
                largest = std::max(largest, std::abs(exact.front().beginMm - rough.front().beginMm));
                largest = std::max(largest, std::abs(exact.back().endMm - rough.back().endMm));
            }
            EXPECT_LT(largest, 5e-7 * (distanceMm + 112.0 * voxelMm))
                << voxelMm << " mm from " << distanceMm << " mm";
        }
    }
}

// The tables hold what the curve says at every value a voxel can have, up to float.
TEST(Extremes, tablesFollowTheCurve) {
    for (const scenes::ExtremeScene& scene : scenes::extremeScenes()) {
        const Medium medium = makeMedium(*scene.volume, makeBrickGrid(*scene.volume), scene.function);
        const EntryMap map = entryMapOf(*scene.volume);
        const UnitsFromStored units = scene.volume->unitsFromStored();
        for (int stored = map.low; stored <= map.high; ++stored) {
            const double exact = extinctionPerMm(scene.function, units(stored));
            ASSERT_NEAR(double(medium.extinctionPerMm[std::size_t(stored - map.low)]), exact,
                        1e-6 * exact + 1e-30)
                << scene.name;
        }
    }
}

}  // namespace
}  // namespace macula::trace
