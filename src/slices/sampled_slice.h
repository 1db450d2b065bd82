// Samples the values in a slice or through a slab, in the volume's unit.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "base/volume.h"
#include "slices/slice_plane.h"

namespace macula::slices {

enum class Projection { mean, maximum, minimum };
// Names of projections, as in files.
inline constexpr std::array kProjections{Projection::mean, Projection::maximum, Projection::minimum};

constexpr std::string_view nameOf(Projection projection) {
    switch (projection) {
        case Projection::mean:
            return "mean";
        case Projection::maximum:
            return "maximum";
        case Projection::minimum:
            return "minimum";
    }
    return {};
}

enum class Filter { nearest, linear };

struct Slab {
    double thicknessMm = 0.0;  // not above 0: the plane alone
    Projection projection = Projection::mean;

    bool operator==(const Slab&) const = default;
};

// Row by row, sizePx.x values each. NaN in padding, and more than half a voxel outside the outer voxel
// centres; a slab skips both.
struct SampledSlice {
    glm::ivec2 sizePx{0};
    std::vector<float> values;
};

// 1 GiB of values.
inline constexpr double kMostSlicePixels = 268435456.0;

// Filter::linear interpolates between the eight surrounding voxels, leaving out padding and its weights; at
// the centre of a voxel the value is that voxel's, and beyond the outer centres that of the outermost ones. A
// slab takes steps of at most half the smallest side of a voxel, symmetric about the plane: slab_steps.h.
// Uses all cores. Calls `cancelled` for each row, from several threads at a time; if it returns true, the
// result is empty. A frame without pixels, or with more than kMostSlicePixels, gives an empty slice; one that
// is not usable (SliceFrame::isUsable) gives all NaN. May throw std::bad_alloc.
SampledSlice sampleSlice(const Volume& volume, const SliceFrame& frame, const Slab& slab, Filter filter,
                         const std::function<bool()>& cancelled = {});

// The value of the voxel nearest to a point, as in the file. Nothing more than half a voxel outside the outer
// voxel centres.
struct Probe {
    glm::ivec3 voxel{0};
    double value = 0.0;  // in units
    bool isPadding = false;
    bool isInterpolated = false;  // no image was taken in its slice
};
std::optional<Probe> probe(const Volume& volume, const glm::dvec3& mm);

}  // namespace macula::slices
