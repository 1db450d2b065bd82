// Segments over the picture of a slice: filled, with a line along the border of their voxels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/volume.h"
#include "base/voxel_set.h"
#include "slices/slice_plane.h"

namespace macula::slices {

struct ShownSegment {
    std::shared_ptr<const VoxelSet> voxels;  // in the displayed volume's grid
    std::string label;                       // for the screen
    std::array<std::uint8_t, 3> rgb{};       // sRGB
    double opacity = 0.4;                    // of the fill, 0 to 1; the line is opaque
    // How these voxels were derived, for the remark beside the picture.
    bool isResampled = false;   // drawn on another grid: nearest voxels of it
    bool hasFractions = false;  // a fraction of a half or more counts

    bool operator==(const ShownSegment&) const = default;  // `voxels` compares pointers
};
using ShownSegments = std::vector<ShownSegment>;

// Row by row, sizePx.x pixels each: 0xAARRGGBB, sRGB, premultiplied. Empty if no segment is visible.
struct SegmentPicture {
    glm::ivec2 sizePx{0};
    std::vector<std::uint32_t> argb;
};

// A pixel belongs to the segments of the voxel nearest to its centre, as in sampleSlice with Filter::nearest,
// so borders follow voxels. Later segments lie over earlier ones, and lines over all fills; a line lies
// within its segment, is `linePx` wide, and is missing where a segment leaves the picture. A slab shows its
// middle plane. Uses all cores. Calls `cancelled` from several threads at a time; if it returns true, the
// result is empty. May throw std::bad_alloc.
SegmentPicture paintSegments(const Volume& volume, const SliceFrame& frame,
                             std::span<const ShownSegment> segments, int linePx,
                             const std::function<bool()>& cancelled = {});

// Indices into `segments` of those that contain the voxel nearest to a point.
std::vector<std::size_t> segmentsAt(const Volume& volume, const glm::dvec3& mm,
                                    std::span<const ShownSegment> segments);

}  // namespace macula::slices
