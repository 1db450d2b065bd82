// The tracers at the ends of what may come: coverage against a dense march in double, float against double,
// everything finite. The errors measured here stand in docs/numerical-limits.md.
#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/trace/reference_tracer.h"
#include "trace/dense_march.h"
#include "trace/extreme_scenes.h"

namespace macula::trace {
namespace {

class Extremes : public ::testing::TestWithParam<scenes::ExtremeScene> {};

// Mean coverage of the picture, by rays through points that fill it evenly without a grid (the R2 sequence):
// edges along rows or columns would meet a grid's lines.
struct Dense {
    double coverage = 0.0;
    double error = 0.0;  // what as many rays again changed
};
Dense denseCoverage(const scenes::ExtremeScene& scene) {
    const CameraBasis eye = *basis(scene.view.camera);
    const double half = std::tan(glm::radians(scene.view.camera.verticalFovDeg) / 2.0);
    constexpr int kRays = 40000;
    constexpr int kStepsPerVoxel = 8;
    double sum = 0.0;
    double sumOfHalf = 0.0;
    for (int n = 1; n <= kRays; ++n) {
        const double x = 2.0 * std::fmod(n * 0.7548776662466927, 1.0) - 1.0;
        const double y = 2.0 * std::fmod(n * 0.5698402909980532, 1.0) - 1.0;
        const glm::dvec3 direction =
            glm::normalize(eye.forward + eye.right * (x * half) + eye.up * (y * half));
        sum -= std::expm1(-scenes::opticalDepth(*scene.volume, scene.function, scene.view.camera.positionMm,
                                                direction, kStepsPerVoxel));
        if (n == kRays / 2) sumOfHalf = sum;
    }
    return {sum / kRays, std::abs(sum / kRays - 2.0 * sumOfHalf / kRays)};
}

glm::dvec4 meanOf(const scenes::ExtremeScene& scene, Precision precision, std::uint32_t samples) {
    const Medium medium = makeMedium(*scene.volume, makeBrickGrid(*scene.volume), scene.function);
    const ReferenceTracer tracer(*scene.volume, medium, scene.environment);
    const auto params = makeTraceParams(*scene.volume, medium, scene.environment, scene.view,
                                        {.bounces = 2, .seed = 77, .filter = Filter::trilinear});
    EXPECT_TRUE(params);
    glm::dvec4 sum(0.0);
    for (const glm::dvec4& pixel : tracer.trace(*params, Filter::trilinear, precision, 0, samples)) {
        for (int c = 0; c < 4; ++c) EXPECT_TRUE(std::isfinite(pixel[c]));
        sum += pixel;
    }
    return sum / (double(samples) * scene.view.width * scene.view.height);
}

TEST_P(Extremes, CoverageIsThatOfADenseMarch) {
    const scenes::ExtremeScene& scene = GetParam();
    const Dense exact = denseCoverage(scene);
    // Where little is seen, little is traced.
    const std::uint32_t samples = exact.coverage < 0.02 ? 8192 : 1024;
    // Of one coin for all pixels: as large as it can be. Each sample has a place of its own in its pixel.
    const double chance = std::sqrt(exact.coverage * (1.0 - exact.coverage) /
                                    (double(samples) * scene.view.width * scene.view.height));
    const glm::dvec4 rough = meanOf(scene, Precision::single, samples);
    const glm::dvec4 fine = meanOf(scene, Precision::twofold, samples);
    for (const glm::dvec4& mean : {rough, fine})
        EXPECT_NEAR(mean.a, exact.coverage, 4.5 * chance + exact.error);
    EXPECT_LE(exact.error, chance);
    if (exact.coverage > 1e-5) {
        EXPECT_LT(4.5 * chance, 0.12 * exact.coverage) << "too few samples to tell";
    }
    RecordProperty("coverage", std::to_string(exact.coverage));
    RecordProperty("errorMillionths", static_cast<int>(1e6 * (rough.a - exact.coverage)));
    RecordProperty("chanceMillionths", static_cast<int>(1e6 * chance));
    RecordProperty("floatMillionths", static_cast<int>(1e6 * (rough.a - fine.a)));
    // The same random numbers: a few paths go another way.
    const double onePath = 1.0 / (double(samples) * scene.view.width * scene.view.height);
    EXPECT_NEAR(rough.a, fine.a, 1e-4 * fine.a + 2.0 * onePath) << "float and double";
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(rough[c], fine[c], 5e-3 * fine[c]) << "float and double";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Extremes, ::testing::ValuesIn(scenes::extremeScenes()), [](const auto& p) {
    std::string name;
    for (const char c : p.param.name) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
});

// Light of what differs only in its unit of length, its place, or the unit of its values; of light that is a
// million times as strong; of none; and of matter so thin that all that it scatters gets out.
TEST(Extremes, LightKeepsItsUnits) {
    const std::vector<scenes::ExtremeScene> all = scenes::extremeScenes();
    const auto light = [&](const std::string& name) {
        const auto scene =
            std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.name == name; });
        EXPECT_NE(scene, all.end()) << name;
        return meanOf(*scene, Precision::single, name == "almost nothing" ? 1024 : 64);
    };
    const auto expectSame = [](const glm::dvec4& a, const glm::dvec4& b) {
        for (int c = 0; c < 4; ++c) EXPECT_NEAR(a[c], b[c], 1e-3 * b[c]);
    };
    const glm::dvec4 ball = light("a ball");
    EXPECT_GT(ball.g, 0.1);
    for (const char* same : {"voxels of 0.01 mm", "voxels of 50 mm", "100 m from the scanner's origin"}) {
        SCOPED_TRACE(same);
        expectSame(light(same), ball);
    }
    expectSame(light("slope of a million"), light("slope of a millionth"));
    glm::dvec4 spark = light("one texel of one");
    EXPECT_GT(spark.g, 0.0);
    expectSame(light("one texel of a million"), spark * glm::dvec4(1e6, 1e6, 1e6, 1.0));
    const glm::dvec4 dark = light("no light at all");
    EXPECT_EQ(glm::dvec3(dark), glm::dvec3(0.0));
    EXPECT_EQ(dark.a, ball.a);
    const glm::dvec4 thin = light("almost nothing");
    EXPECT_GT(thin.a, 0.0);
    EXPECT_NEAR(thin.g, thin.a, 0.01 * thin.a);  // hardly any is scattered twice
}

// How far float takes a ray off its way: where it meets the volume, at every distance and size of voxel.
TEST(Extremes, RaysMeetTheVolumeWhereTheyShould) {
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
TEST(Extremes, TablesFollowTheCurve) {
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
