// Connected parts of a mask, their shapes, and what the mask encloses.
#pragma once

#include "base/result.h"
#include "segment/coarse_grid.h"

namespace macula::segment {

struct Part {
    std::size_t blocks = 0;
    glm::ivec3 low{0};           // lowest block indices
    glm::ivec3 high{0};          // highest block indices, inclusive
    float depthMm = 0.0f;        // the largest of any block: radius of the largest ball in it
    bool touches = false;        // it holds or adjoins a block of the patient; set in patient.cpp
    std::size_t persistent = 0;  // blocks of columns along c that the part fills to 80 % of its length
};

struct Parts {
    std::vector<std::uint32_t> labels;  // 0: none; otherwise 1 + its place among `parts`
    std::vector<Part> parts;
};

// Connected over faces, edges and corners when `corners`, otherwise over faces only. `depthMm` may be empty.
Result<Parts> partsOf(const Grid& grid, const Mask& mask, bool corners, const std::vector<float>& depthMm);

// Counts Part::persistent.
void countPersistent(const Grid& grid, Parts& parts);

// Fills lungs, bowel gas and everything else within the patient that is not solid: adds to the mask, slice by
// slice, the regions that it encloses. Up to a third of a region's border may be
// the edge of the field of view, which may cut through a hollow organ; with more, the region is the room.
Result<void> fillEnclosed(const Grid& grid, const Mask& outside, Mask& mask, const CancelToken& token);

}  // namespace macula::segment
