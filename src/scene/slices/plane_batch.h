// Planes through a volume, one after the other or about a line.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "slices/sampled_slice.h"
#include "slices/slice_plane.h"

namespace macula::scene {

inline constexpr std::size_t kMostPlanes = 2000;
inline constexpr int kMostPlanePx = 4096;  // a side

struct PlaneBatch {
    slices::SliceFrame like;  // the planes show as much as this one, and parallel ones lie as it does
    // Parallel planes: distances from `like` along its normal. `stepMm` is not 0.
    double fromMm = 0.0;
    double toMm = 0.0;
    double stepMm = 1.0;
    // Radial planes: so many in half a turn about `axis`, a unit vector, through `throughMm`; each has the
    // axis from top to bottom in its middle. Nothing: parallel ones.
    struct Radial {
        int count = 12;
        glm::dvec3 throughMm{0.0};
        glm::dvec3 axis{0.0, 0.0, 1.0};
    };
    std::optional<Radial> radial;
    slices::Slab slab;

    bool operator==(const PlaneBatch&) const = default;
};

// The frames of all planes, in their order, with pixels of the side `mmPerPixel` over the area that `like`
// shows; none are left out where they miss the volume. Usage for numbers that are not finite or make no
// plane, for more than kMostPlanes, and for a plane of more than kMostPlanePx a side.
Result<std::vector<slices::SliceFrame>> framesOf(const PlaneBatch& batch, double mmPerPixel);

// The side of their pixels: the smallest side of a voxel, or more where a plane would else have more than
// kMostPlanePx.
double mmPerPixelOf(const PlaneBatch& batch, const Volume& volume);

}  // namespace macula::scene
