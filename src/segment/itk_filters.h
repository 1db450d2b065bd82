// Connected parts, by ITK. Only itk_filters.cpp includes it, and turns its exceptions into errors.
#pragma once

#include <cstdint>

#include "base/result.h"
#include "segment/coarse_grid.h"

namespace macula::segment {

struct Labels {
    std::vector<std::uint32_t> ofBlock;  // 0: none; otherwise from 1
    std::size_t count = 0;
};

// Labels of the connected parts of a mask: over faces, edges and corners when `corners`, otherwise over faces
// only.
Result<Labels> connectedParts(const Grid& grid, const Mask& mask, bool corners);

}  // namespace macula::segment
