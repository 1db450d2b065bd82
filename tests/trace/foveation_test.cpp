// Foveated views of the reference tracer.
#include <gtest/gtest.h>

#include "pipeline/trace/reference_tracer.h"
#include "trace/clips.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

const Environment& sky() {
    static const Environment made = Environment::constant(glm::vec3(1.0f));
    return made;
}

std::shared_ptr<const Volume> whiteBall() {
    return scenes::volumeOf(
        {20, 20, 20}, affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-9.5, -9.5, -9.5}),
        [](int i, int j, int k) { return std::uint16_t(std::hypot(i - 9.5, j - 9.5, k - 9.5) < 8 ? 1 : 0); });
}

// White matter in a white sky stays white, however it is clipped and stored.
TEST(Foveation, WhiteFurnaceWithClips) {
    const auto volume = whiteBall();
    scenes::Chance chance(41);
    for (int trial = 0; trial < 6; ++trial) {
        Clip clip = scenes::anyClip(chance, volume->worldBox());
        const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), scenes::homogeneous(0.25), clip);
        View view{.camera = {.positionMm = {0, -40, 5}, .targetMm = {0, 0, 0}}, .width = 24, .height = 16};
        view.foveation = Foveation{.gaze = {chance.between(-1, 1), chance.between(-1, 1)},
                                   .fieldDeg = chance.between(2, 20),
                                   .magnification = chance.between(1, 6)};
        constexpr std::uint32_t kSamples = 256;
        double sum = 0.0;
        double squares = 0.0;
        constexpr int kBatches = 12;
        for (int batch = 0; batch < kBatches; ++batch) {
            const auto params = makeTraceParams(
                *volume, medium, sky(), view, {.bounces = 1024, .seed = unsigned(100 * trial + batch)}, clip);
            ASSERT_TRUE(params) << params.error().message;
            double mean = 0.0;
            for (const glm::dvec4& p :
                 ReferenceTracer(*volume, medium, sky())
                     .trace(*params, Filter::stochastic, Precision::single, 0, kSamples / kBatches))
                mean += (p.r + (kSamples / kBatches - p.a)) / (kSamples / kBatches) / (24 * 16);
            sum += mean / kBatches;
            squares += mean * mean / kBatches;
        }
        const double error = std::sqrt(std::max(squares - sum * sum, 0.0) / (kBatches - 1));
        EXPECT_NEAR(sum, 1.0, 5.0 * error + 1e-6) << trial;
        EXPECT_LT(error, 0.02);
    }
}

// Weighted with their solid angles, the pixels of both pictures show the same light.
TEST(Foveation, ShowsTheSameLight) {
    const auto volume = whiteBall();
    LightRig rig;
    rig.ambientHorizon = {0.2, 0.3, 0.4};
    rig.lights = {{.azimuthDeg = 50, .elevationDeg = 30, .angularRadiusDeg = 20, .radiance = 10}};
    const Environment lit = Environment::fromRig(rig);
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), scenes::homogeneous(1.0));
    const ReferenceTracer tracer(*volume, medium, lit);
    const View plain{.camera = {.positionMm = {5, -40, 0}, .targetMm = {0, 0, 0}, .verticalFovDeg = 60},
                     .width = 96,
                     .height = 64};
    constexpr std::uint32_t kSamples = 32;
    const auto light = [&](const View& view, std::uint32_t seed) {
        const auto params = makeTraceParams(*volume, medium, lit, view, {.bounces = 2, .seed = seed});
        const FoveaInPlane f = foveaInPlane(view);
        const auto sums = tracer.trace(*params, Filter::stochastic, Precision::single, 0, kSamples);
        glm::dvec4 all(0.0);
        for (int y = 0; y < view.height; ++y) {
            for (int x = 0; x < view.width; ++x) {
                const glm::dvec2 stored =
                    glm::dvec2((x + 0.5) / view.width * 2 - 1, 1 - (y + 0.5) / view.height * 2) * f.halfSize;
                all += sums[std::size_t(y * view.width + x)] / double(kSamples) *
                       tracer.seenSolidAngle(*params, stored) *
                       (4 * f.halfSize.x * f.halfSize.y / (view.width * view.height));
            }
        }
        return all;
    };
    View foveated = plain;
    foveated.foveation = Foveation{.gaze = {0.3, -0.1}, .fieldDeg = 10, .magnification = 3};
    constexpr int kBatches = 16;
    glm::dvec4 total(0.0);
    glm::dvec4 sum(0.0);
    glm::dvec4 squares(0.0);
    for (std::uint32_t seed = 0; seed < kBatches; ++seed) {
        const glm::dvec4 seen = light(plain, 1000 + seed);
        const glm::dvec4 difference = light(foveated, seed) - seen;
        total += seen / double(kBatches);
        sum += difference / double(kBatches);
        squares += difference * difference / double(kBatches);
    }
    for (int c = 0; c < 4; ++c) {
        const double error = std::sqrt(std::max(squares[c] - sum[c] * sum[c], 0.0) / (kBatches - 1));
        // Pixels are weighted with the solid angle of their centres, which costs a thousandth.
        EXPECT_NEAR(sum[c], 0.0, 5.0 * error + 1e-3 * total[c]) << c;
        EXPECT_LT(error, 5e-3 * total[c]) << c;
    }
}

TEST(Foveation, WindowLooksWhereTheGazeIs) {
    const View view{.camera = {.positionMm = {100, -500, 30}, .targetMm = {0, 0, 0}, .verticalFovDeg = 50},
                    .width = 800,
                    .height = 600};
    const CameraBasis eye = *basis(view.camera);
    for (const glm::dvec2 gaze : {glm::dvec2(0, 0), glm::dvec2(0.8, -0.5), glm::dvec2(-1, 1)}) {
        const auto window = fovealWindow(view, gaze);
        ASSERT_TRUE(window);
        EXPECT_EQ(window->width, 512);
        EXPECT_EQ(window->camera.verticalFovDeg, kFovealFieldDeg);
        EXPECT_EQ(window->camera.positionMm, view.camera.positionMm);
        const CameraBasis looks = *basis(window->camera);
        // Its middle is the point of the picture.
        const double half = std::tan(glm::radians(25.0));
        const glm::dvec2 at(
            glm::dot(looks.forward, eye.right) / glm::dot(looks.forward, eye.forward) / (half * 800 / 600),
            glm::dot(looks.forward, eye.up) / glm::dot(looks.forward, eye.forward) / half);
        EXPECT_NEAR(glm::length(at - gaze), 0.0, 1e-12);
        EXPECT_GT(glm::dot(looks.up, eye.up), 0.7);
    }
    View up = view;
    up.camera.verticalFovDeg = 400;
    EXPECT_FALSE(fovealWindow(up, {0, 0}));
}

TEST(Foveation, RefusesWhatIsNone) {
    const auto volume = whiteBall();
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), scenes::homogeneous(1.0));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Foveation& bad :
         {Foveation{.gaze = {1.5, 0}}, Foveation{.gaze = {nan, 0}}, Foveation{.fieldDeg = 0},
          Foveation{.fieldDeg = nan}, Foveation{.magnification = 0.5}, Foveation{.magnification = 17}}) {
        View view;
        view.foveation = bad;
        EXPECT_FALSE(makeTraceParams(*volume, medium, sky(), view, {}));
    }
    // A gaze on the very corner, and a fovea wider than the picture, are brought in.
    for (const Foveation& odd :
         {Foveation{.gaze = {1, -1}}, Foveation{.fieldDeg = 160, .magnification = 16}}) {
        View view;
        view.foveation = odd;
        const FoveaInPlane f = foveaInPlane(view);
        EXPECT_GE(f.radius, 0.0);
        EXPECT_LT(f.radius, std::min(f.halfSize.x - std::abs(f.gaze.x), f.halfSize.y - std::abs(f.gaze.y)));
        EXPECT_TRUE(makeTraceParams(*volume, medium, sky(), view, {}));
    }
}

}  // namespace
}  // namespace macula::trace
