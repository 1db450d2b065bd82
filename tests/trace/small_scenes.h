// Eleven scenes so small that estimators can be held to the truth in them, and that lead through every branch
// of the estimators between them: soft and dense matter, roulette of shadow rays and of paths, scattering
// forward and back, even and single lights in the patient's and the camera's frame, clips and masks that cast
// shadow and that do not, gradient opacity, surfaces, steep matter, a turned grid of unequal spacing, a
// foveated view, an eye inside of matter.
#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <vector>

#include "trace/extreme_scenes.h"

namespace macula::scenes {

// A panorama of few texels, as Environment::fromImage takes it.
struct Sky {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> radiance;
    trace::LightFrame frame = trace::LightFrame::patient;
};

struct SmallScene {
    std::string name;
    std::shared_ptr<const Volume> volume;
    TransferFunction function;
    trace::View view;
    Sky sky;
    int bounces = 4;  // of the cinematic look
    Clip clip = {};
    double lightRotationDeg = 0.0;

    trace::Settings settings(trace::Look look, trace::Filter filter, std::uint32_t seed) const {
        trace::Settings settings{.bounces = bounces, .seed = seed, .filter = filter, .look = look};
        settings.lightRotationDeg = lightRotationDeg;
        return settings;
    }
    trace::Environment environment() const {
        return *trace::Environment::fromImage(sky.width, sky.height, sky.radiance, sky.frame);
    }
};

inline constexpr int kSmallPixels = 16;
inline constexpr glm::ivec3 kSmallSize{18, 16, 14};

inline Sky evenSky() {
    return {.width = 4, .height = 2, .radiance = std::vector<glm::vec3>(8, glm::vec3(1.0f, 0.9f, 0.7f))};
}
// One texel of `radiance` over faint light from everywhere.
inline Sky oneLight(int column, int row, const glm::vec3& radiance, float around = 0.05f) {
    Sky sky{.width = 16, .height = 8, .radiance = std::vector<glm::vec3>(128, glm::vec3(around))};
    sky.radiance[std::size_t(row * 16 + column)] = radiance;
    return sky;
}

// A lump with structure, values from 0 to 1000.
inline std::uint16_t lump(int i, int j, int k) {
    const glm::dvec3 p = (glm::dvec3(i, j, k) + 0.5) / glm::dvec3(kSmallSize) * 2.0 - 1.0;
    const double wave = 0.75 + 0.25 * std::sin(1.1 * i + 0.5 * j) * std::cos(0.9 * k);
    return static_cast<std::uint16_t>(1000.0 * wave * std::clamp(1.2 - glm::dot(p, p), 0.0, 1.0));
}

inline std::vector<SmallScene> smallScenes() {
    const auto straight = volumeOf(kSmallSize, grid(glm::dvec3(1.0), kSmallSize), lump);
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1, 2, -1))) *
                            grid({0.8, 1.0, 1.4}, kSmallSize);
    const auto turned = volumeOf(kSmallSize, turn, lump);
    // Flesh over bone: two densities, two colours.
    TransferFunction tissue = ramp(80, 900, 0.25, 1.0);
    tissue.opacity = {{80, 0.0}, {400, 0.1}, {900, 0.35}};
    tissue.colour = {{80, {0.95, 0.8, 0.7}}, {900, {0.8, 0.9, 1.0}}};
    tissue.albedo = 0.95;
    const auto look = [](const Volume& volume) { return lookAt(volume, 20.0, kSmallPixels); };

    std::vector<SmallScene> scenes;
    scenes.push_back({.name = "a soft lump under an even sky",
                      .volume = straight,
                      .function = tissue,
                      .view = look(*straight),
                      .sky = evenSky()});

    // Most of the light comes through more matter, or after more vertices, than roulette lets all of it pass.
    SmallScene deep{.name = "deep in dense matter",
                    .volume = straight,
                    .function = ramp(80, 900, 0.7, 1.0),
                    .view = look(*straight),
                    .sky = oneLight(9, 2, glm::vec3(60.0f, 50.0f, 40.0f), 1.0f),
                    .bounces = 40};
    deep.function.colour = {{80, {1.0, 0.97, 0.95}}};
    deep.function.albedo = 0.85;
    deep.view.camera.positionMm = {0.4, -0.7, -0.3};
    deep.view.camera.targetMm = {0, 5, 1};
    deep.view.camera.verticalFovDeg = 80;
    scenes.push_back(deep);

    TransferFunction forward = tissue;
    forward.anisotropy = 0.7;
    scenes.push_back({.name = "scattering forward, lit from behind",
                      .volume = straight,
                      .function = forward,
                      .view = look(*straight),
                      .sky = oneLight(1, 3, glm::vec3(20.0f, 25.0f, 30.0f), 0.3f),
                      .bounces = 6});

    SmallScene cut{.name = "a box and a corner cut out",
                   .volume = straight,
                   .function = tissue,
                   .view = look(*straight),
                   .sky = oneLight(10, 3, glm::vec3(30.0f), 0.2f)};
    cut.clip.box = OrientedBox{.centreMm = {3, -4, 2},
                               .axes = glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.5, glm::dvec3(0, 0, 1))),
                               .halfSizeMm = {3.1, 4.2, 2.7}};
    cut.clip.ofBox = Keep::outside;
    cut.clip.cut = Octant{.pointMm = {-1.2, 0.4, -0.6}, .towards = {-1, -1, -1}};
    scenes.push_back(cut);

    // Labels of half of the lump, beyond a slanted plane.
    std::vector<std::uint16_t> labels;
    for (int k = 0; k < kSmallSize.z; ++k) {
        for (int j = 0; j < kSmallSize.y; ++j) {
            for (int i = 0; i < kSmallSize.x; ++i) labels.push_back(i + j + 2 * k > 28 ? 3 : 1);
        }
    }
    const auto halves = [&](const glm::dmat4& toWorld) {
        const std::vector<Segment> segments{{.number = 1, .label = "a"}, {.number = 3, .label = "b"}};
        return std::make_shared<const LabelMap>(
            std::move(LabelMap::create(kSmallSize, toWorld, segments, labels)).value());
    };
    SmallScene shaded{.name = "what a plane, a ball and a mask remove still casts shadow",
                      .volume = straight,
                      .function = tissue,
                      .view = look(*straight),
                      .sky = oneLight(8, 2, glm::vec3(30.0f), 0.2f)};
    shaded.clip.planes = {{glm::normalize(glm::dvec3(0.3, 1, -0.2)), -3.0}};
    shaded.clip.ball = Ball{.centreMm = {2, 0, 3}, .radiusMm = 4.5};
    shaded.clip.ofBall = Keep::outside;
    shaded.clip.mask = Mask{halves(straight->worldFromVoxel()), {3}, Keep::outside};
    shaded.clip.removedCastsShadow = true;
    scenes.push_back(shaded);

    SmallScene masked{.name = "half of it masked, on a turned grid",
                      .volume = turned,
                      .function = forward,
                      .view = look(*turned),
                      .sky = oneLight(5, 2, glm::vec3(25.0f, 15.0f, 10.0f), 0.3f)};
    masked.function.anisotropy = 0.35;
    masked.clip.mask = Mask{halves(turn), {3}, Keep::inside};
    scenes.push_back(masked);

    SmallScene edges{.name = "gradient opacity, scattering back",
                     .volume = turned,
                     .function = tissue,
                     .view = look(*turned),
                     .sky = evenSky()};
    edges.function.anisotropy = -0.4;
    edges.function.gradientOpacity = {{40, 0.1}, {160, 1.0}, {400, 0.6}};
    edges.function.density = 2.0;
    scenes.push_back(edges);

    SmallScene foveated{.name = "foveated, the eye inside, lights on the camera and turned",
                        .volume = straight,
                        .function = tissue,
                        .view = look(*straight),
                        .sky = oneLight(12, 2, glm::vec3(10.0f, 20.0f, 30.0f), 0.4f),
                        .lightRotationDeg = 50.0};
    foveated.sky.frame = trace::LightFrame::camera;
    foveated.function.anisotropy = 0.2;
    foveated.view.camera.positionMm = {1.3, -6.2, 0.8};
    foveated.view.camera.targetMm = {0, 3, 0};
    foveated.view.camera.verticalFovDeg = 70;
    foveated.view.foveation = trace::Foveation{.gaze = {0.3, -0.2}, .fieldDeg = 12.0, .magnification = 3.0};
    scenes.push_back(foveated);

    SmallScene wet{.name = "wet surfaces on a turned grid",
                   .volume = turned,
                   .function = tissue,
                   .view = look(*turned),
                   .sky = oneLight(10, 2, glm::vec3(25.0f, 22.0f, 20.0f), 0.3f),
                   .bounces = 5};
    wet.function.surface = {.weight = 0.9, .gradientPerMm = 60.0, .roughness = 0.5, .reflectance = 0.15};
    wet.function.anisotropy = 0.3;
    scenes.push_back(wet);

    SmallScene steep{.name = "steep matter, denser and of another colour, with surfaces",
                     .volume = turned,
                     .function = tissue,
                     .view = look(*turned),
                     .sky = oneLight(9, 2, glm::vec3(22.0f, 20.0f, 18.0f), 0.4f)};
    steep.function.steep = {.opacity = {{150, 0.1}, {450, 0.75}, {900, 0.3}},
                            .colour = {{100, {0.3, 0.5, 1.0}}, {700, {0.9, 1.0, 0.4}}},
                            .gradientPerMm = 90.0};
    steep.function.surface = {.weight = 0.5, .gradientPerMm = 80.0, .roughness = 0.6, .reflectance = 0.1};
    scenes.push_back(steep);

    SmallScene tinted = edges;
    tinted.name = "steep matter of another colour alone, under a gradient opacity";
    tinted.function.steep = {.opacity = tissue.opacity,
                             .colour = {{0, {0.1, 0.9, 0.3}}, {1000, {0.2, 0.4, 1.0}}},
                             .gradientPerMm = 70.0};
    scenes.push_back(tinted);
    return scenes;
}

}  // namespace macula::scenes
