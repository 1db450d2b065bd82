// Scenes of more than one volume, and of coloured segments.
#pragma once

#include <glm/gtc/matrix_transform.hpp>

#include "base/phantom.h"
#include "pipeline/trace/reference_tracer.h"
#include "pipeline/volume/additions.h"
#include "trace/scenes.h"

namespace macula::scenes {

inline DrawnSecondVolume second(std::shared_ptr<const Volume> volume, TransferFunction function,
                                const glm::dmat4& secondFromVolumeMm = glm::dmat4(1.0)) {
    return {std::move(volume), std::make_shared<const TransferFunction>(std::move(function)),
            secondFromVolumeMm};
}

inline TransferFunction coloured(TransferFunction function, const glm::dvec3& srgb) {
    for (ColourPoint& point : function.colour) point.colour = srgb;
    return function;
}

// A cube of one value, turned about all axes, larger than a slab.
inline std::shared_ptr<const Volume> turnedCube() {
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1, 2, -1)));
    return volumeOf({5, 5, 5}, turn * affine({40, 0, 0}, {0, 40, 0}, {0, 0, 40}, {-80, -80, -80}),
                    [](int, int, int) { return std::uint16_t(1); });
}

// One colour for all voxels of a box.
inline SegmentTints tint(const Volume& volume, const glm::ivec3& low, const glm::ivec3& size,
                         const SegmentTints::Colour& colour) {
    auto box = std::make_shared<TintBox>();
    box->volumeSize = volume.size();
    box->low = low;
    box->size = size;
    box->voxels.assign(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), 1);
    return {box, {colour}};
}

struct MixedScene {
    std::shared_ptr<const Volume> volume;
    TransferFunction function;
    Additions additions;
    trace::View view;
};

// The phantom with bones, and over it, coarser, shifted and turned by a registration, its soft parts; part of
// the bones is a green segment.
inline MixedScene mixedPhantom(int pixels) {
    MixedScene scene;
    scene.volume =
        std::make_shared<const Volume>(phantom::make({.size = {64, 56, 40}, .spacingMm = {4.8, 4.8, 7.5}}));
    scene.function = homogeneous(1.0, 0.9);
    scene.function.opacity = {{150, 0.0}, {400, 0.4}};
    const auto coarse = std::make_shared<const Volume>(
        phantom::make({.size = {40, 44, 48}, .spacingMm = {7.0, 6.0, 6.5}, .tiltDeg = {-10.0, 5.0, 20.0}}));
    TransferFunction soft = homogeneous(1.0, 0.8);
    soft.opacity = {{-150, 0.0}, {0, 0.03}, {80, 0.03}, {200, 0.0}};
    soft.colour = {{-100, {1, 0.2, 0.1}}, {100, {0.9, 0.6, 0.2}}};
    glm::dmat4 registered = glm::rotate(glm::dmat4(1.0), 0.12, glm::dvec3(0, 0.6, 0.8));
    registered[3] = glm::dvec4(9, -5, 12, 1);
    scene.additions.second = second(coarse, soft, registered);
    scene.additions.tints =
        tint(*scene.volume, {10, 8, 3}, {22, 40, 31}, {.rgb = {0.1f, 0.9f, 0.2f}, .opacity = 0.5f});
    scene.view = {.camera = frameBox(scene.volume->worldBox(), ViewDirection::anterior, 30, 1.0),
                  .width = pixels,
                  .height = pixels};
    return scene;
}

inline Medium mediumOf(const MixedScene& scene) {
    const BrickGrid grid = makeBrickGrid(*scene.volume);
    return makeMedium(*scene.volume, grid, scene.function, {}, nullptr,
                      addedBounds(scene.additions, *scene.volume, grid));
}

}  // namespace macula::scenes
