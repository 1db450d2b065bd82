// Volumes of a micro-CT: a scene that is smaller by a power of two, with as much more extinction, is the same
// picture to the last bit, because nothing but its unit is another.
#include <cmath>

#include "trace/extreme_scenes.h"
#include "trace/gpu_scene.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

using Scale = DeviceTest;

constexpr double kSmall = 1.0 / 1024.0;  // a voxel of about a micrometre

struct Scene {
    std::shared_ptr<const Volume> volume;
    TransferFunction function;
    View view;
    Clip clip;
};

// Bone in flesh in air: a ball in an ellipsoid, cut by a plane whose face shows grey values, and a second
// plane less than a voxel before the first slice, which cuts nothing.
Scene sceneOf(double scale) {
    const glm::ivec3 size(40, 36, 44);
    const glm::dvec3 spacing = scale * glm::dvec3(1.0, 1.25, 0.75);
    const glm::dvec3 first = -0.5 * spacing * (glm::dvec3(size) - 1.0);
    const glm::dmat4 toWorld = affine({spacing.x, 0, 0}, {0, spacing.y, 0}, {0, 0, spacing.z}, first);
    Scene scene;
    scene.volume = scenes::volumeOf(size, toWorld, [&](int i, int j, int k) {
        const glm::dvec3 p = (2.0 * glm::dvec3(i, j, k) + 1.0) / glm::dvec3(size) - 1.0;
        const double bone = glm::length(p - glm::dvec3(0.2, -0.1, 0.1)) < 0.4 ? 900.0 : 0.0;
        return static_cast<std::uint16_t>(bone + 300.0 * std::clamp(4.0 - 4.0 * glm::length(p), 0.0, 1.0));
    });
    scene.function = scenes::homogeneous(1.0 / scale, 0.9);
    scene.function.opacity = {{150, 0.0}, {300, 0.05}, {800, 0.1}, {1200, 0.6}};
    scene.function.colour = {{150, {1, 0.5, 0.4}}, {1200, {1, 1, 0.9}}};
    scene.view = {.camera = {.positionMm = scale * glm::dvec3(30, -120, 25),
                             .targetMm = scale * glm::dvec3(1, 2, 0.5),
                             .up = {0, 0, 1},
                             .verticalFovDeg = 24},
                  .width = 40,
                  .height = 36};
    const double front = -0.5 * spacing.y * size.y;  // the side of the volume
    scene.clip = {.planes = {{{0, 1, 0}, front - 0.5 * spacing.y}, {{-1, 0, 0}, -scale * 6.0}},
                  .greyFaces = DisplayWindow{.center = 500, .width = 1000, .function = "LINEAR_EXACT"}};
    return scene;
}

PathTracer tracerOf(const Scene& scene, const std::shared_ptr<gpu::Device>& device,
                    const Settings& settings) {
    PathTracer t = *PathTracer::create(device);
    EXPECT_TRUE(t.scene().setVolume(scene.volume).ok());
    EXPECT_TRUE(t.scene().setClip(scene.clip).ok());
    EXPECT_TRUE(t.scene().setTransferFunction(scene.function).ok());
    EXPECT_TRUE(t.scene().setEnvironment(Environment::constant(glm::vec3(1.0f))).ok());
    EXPECT_TRUE(t.setSettings(settings).ok());
    EXPECT_TRUE(t.setView(scene.view).ok());
    return t;
}

TEST_F(Scale, AMicroCtIsTheSamePictureAsABody) {
    const Scene body = sceneOf(1.0);
    const Scene micro = sceneOf(kSmall);
    for (const Look look : {Look::cinematic, Look::dvr, Look::mip}) {
        for (const Denoising denoising : {Denoising::off, Denoising::on}) {
            const Settings settings{.denoising = denoising, .look = look};
            PathTracer large = tracerOf(body, device(), settings);
            PathTracer small = tracerOf(micro, device(), settings);
            ASSERT_TRUE(*large.trace(4));
            ASSERT_TRUE(*small.trace(4));
            const auto expected = large.readback();
            const auto found = small.readback();
            ASSERT_TRUE(expected.ok() && found.ok());
            EXPECT_EQ(found->radiance, expected->radiance) << nameOf(look) << " " << int(denoising);
            int depths = 0;
            for (std::size_t i = 0; i < expected->depthMm.size(); ++i) {
                EXPECT_EQ(found->depthMm[i] * 1024.0f, expected->depthMm[i]) << nameOf(look) << " " << i;
                depths += std::isfinite(expected->depthMm[i]) ? 1 : 0;
            }
            EXPECT_TRUE(look == Look::mip || depths > 100) << depths;
        }
    }
}

TEST_F(Scale, PointsOnWhatCanBeSeenAreTheSame) {
    PathTracer large = tracerOf(sceneOf(1.0), device(), {});
    PathTracer small = tracerOf(sceneOf(kSmall), device(), {});
    const SurfacePointOptions options{.count = 200, .paths = 2};
    const auto expected = large.surfacePoints(options);
    const auto found = small.surfacePoints(options);
    ASSERT_TRUE(expected.ok() && found.ok());
    ASSERT_EQ(found->points.size(), expected->points.size());
    EXPECT_GT(expected->points.size(), 100u);
    for (std::size_t i = 0; i < expected->points.size(); ++i) {
        EXPECT_LT(glm::distance(glm::dvec3(found->points[i].positionMm) * 1024.0,
                                glm::dvec3(expected->points[i].positionMm)),
                  1e-3)
            << i;
    }
}

}  // namespace
}  // namespace macula::trace
