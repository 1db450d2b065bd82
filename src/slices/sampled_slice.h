// The values in a slice, or through a slab, in units.
#pragma once

#include <functional>
#include <vector>

#include "base/volume.h"
#include "slices/slice_plane.h"

namespace macula::slices {

enum class Projection { mean, maximum, minimum };
enum class Filter { nearest, linear };

struct Slab {
    double thicknessMm = 0.0;  // 0: the plane alone
    Projection projection = Projection::mean;

    bool operator==(const Slab&) const = default;
};

// Row by row, sizePx.x values each. NaN where there is no voxel within half a voxel, and where what is there
// is padding; a slab is over what of it is neither.
struct SampledSlice {
    glm::ivec2 sizePx{0};
    std::vector<float> values;
};

// Values between voxels are linear between the eight around them, padding left out of them and their weights;
// at the middle of a voxel the value is that voxel's. A slab takes steps of at most half the smallest side of
// a voxel, symmetric about the plane. Uses all cores. `cancelled` is asked by row; then the result is empty.
// A frame without pixels gives an empty slice.
SampledSlice sampleSlice(const Volume& volume, const SliceFrame& frame, const Slab& slab, Filter filter,
                         const std::function<bool()>& cancelled = {});

// What is at a point: the value of the nearest voxel, as the file has it. Nothing beyond half a voxel outside
// of the volume.
struct Probe {
    glm::ivec3 voxel{0};
    double value = 0.0;  // in units
    bool isPadding = false;
};
std::optional<Probe> probe(const Volume& volume, const glm::dvec3& mm);

}  // namespace macula::slices
