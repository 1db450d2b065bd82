// Small scenes with known answers.
#pragma once

#include <cmath>
#include <functional>
#include <memory>

#include "base/volume.h"
#include "pipeline/trace/environment.h"
#include "pipeline/trace/scene.h"
#include "pipeline/volume/medium.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::scenes {

inline std::shared_ptr<const Volume> volumeOf(glm::ivec3 size, const glm::dmat4& worldFromVoxel,
                                              const std::function<std::uint16_t(int, int, int)>& stored) {
    std::vector<std::uint16_t> voxels;
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) voxels.push_back(stored(i, j, k));
        }
    }
    auto made = Volume::create({.size = size,
                                .worldFromVoxel = worldFromVoxel,
                                .unitsFromStored = {.slope = 1.0, .intercept = 0.0},
                                .unit = Unit::raw,
                                .modality = "OT",
                                .padding = {},
                                .provenance = {}},
                               std::move(voxels));
    return std::make_shared<const Volume>(std::move(made).value());
}

// Extinction `perMm` wherever the value is above 0, white.
inline TransferFunction homogeneous(double perMm, double albedo = 1.0) {
    TransferFunction function;
    function.name = "homogeneous";
    function.unit = Unit::raw;
    function.opacity = {{0.5, 0.0}, {0.5, 0.5}};
    function.colour = {{0.0, {1, 1, 1}}};
    function.density = perMm / std::log(2.0);  // opacity 0.5 is ln 2 per unit distance
    function.albedo = albedo;
    return function;
}

// A slab `thicknessMm` along world y, 64 mm wide and high, centred on the origin; looked at from the front
// through a field of view so narrow that all rays are perpendicular to it.
struct Slab {
    std::shared_ptr<const Volume> volume;
    trace::View view;
};
inline Slab slab(double thicknessMm, int pixels) {
    const glm::ivec3 size{16, 20, 16};
    const double step = thicknessMm / size.y;
    const glm::dmat4 toWorld =
        affine({4, 0, 0}, {0, step, 0}, {0, 0, 4}, {-30, -0.5 * thicknessMm + 0.5 * step, -30});
    trace::View view{.camera = {.positionMm = {0.1, -3000, 0.2},
                                .targetMm = {0.1, 0, 0.2},
                                .up = {0, 0, 1},
                                .verticalFovDeg = 0.1},
                     .width = pixels,
                     .height = pixels};
    return {volumeOf(size, toWorld, [](int, int, int) { return 1; }), view};
}

}  // namespace macula::scenes
