// The values in a slice, or through a slab, in units.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "base/volume.h"
#include "slices/slice_plane.h"

namespace macula::slices {

enum class Projection { mean, maximum, minimum };
enum class Filter { nearest, linear };

struct Slab {
    double thicknessMm = 0.0;  // 0, or no number: the plane alone
    Projection projection = Projection::mean;

    bool operator==(const Slab&) const = default;
};

// Row by row, sizePx.x values each. NaN where there is no voxel within half a voxel, and where what is there
// is padding; a slab is over what of it is neither.
struct SampledSlice {
    glm::ivec2 sizePx{0};
    std::vector<float> values;
};

// 1 GiB of values.
inline constexpr double kMostSlicePixels = 268435456.0;

// Values between voxels are linear between the eight around them, padding left out of them and their weights;
// at the middle of a voxel the value is that voxel's, and beyond the outer middles that of the outermost
// ones. A slab takes steps of at most half the smallest side of a voxel, symmetric about the plane:
// slab_steps.h. Uses all cores. `cancelled` is asked by row, from several threads at a time; then the result
// is empty. A frame without pixels, or with more than kMostSlicePixels, gives an empty slice; one that is not
// usable (SliceFrame::isUsable) one that is all NaN. May throw std::bad_alloc.
SampledSlice sampleSlice(const Volume& volume, const SliceFrame& frame, const Slab& slab, Filter filter,
                         const std::function<bool()>& cancelled = {});

// What is at a point: the value of the nearest voxel, as the file has it. Nothing beyond half a voxel outside
// of the volume.
struct Probe {
    glm::ivec3 voxel{0};
    double value = 0.0;  // in units
    bool isPadding = false;
    bool isInterpolated = false;  // no image was taken in its slice
};
std::optional<Probe> probe(const Volume& volume, const glm::dvec3& mm);

}  // namespace macula::slices
