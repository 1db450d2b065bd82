// Maps the properties of a PLY's vertices to parameters of splats: by the convention of 3DGS and its
// variants.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "base/result.h"
#include "pipeline/splat/files/ply_header.h"
#include "pipeline/splat/model/splats.h"

namespace macula::splat {

struct PlyLayout {
    // The positions in a row of a splat's numbers. The bands of spherical harmonics come last, channel by
    // channel.
    enum Slot : std::size_t {
        kPosition = 0,
        kDc = 3,
        kOpacity = 6,
        kScale = 7,
        kRotation = 10,
        kFilter = 14,
        kRest = 15
    };

    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> slots;  // for each property; kNone for one without meaning here
    int shDegree = 0;
    bool hasColourBytes = false;  // red, green, blue of 0 to 255 instead of f_dc (Nerfstudio)
    bool isFlat = false;          // two scales (2DGS)
    // filter_3D (Mip-Splatting): the splat is drawn wider by this, in the unit of positions.
    bool hasFilter = false;

    std::size_t size() const { return kRest + 3 * shCount(shDegree); }
};

// Fails with inputNotUsable when the vertices are not splats; the error says what is missing, repeated, or
// too much.
Result<PlyLayout> plyLayoutOf(const PlyElement& vertex);

}  // namespace macula::splat
