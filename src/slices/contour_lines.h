// Lines of equal value in the picture of a slice, such as isodoses: marching squares.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "slices/sampled_slice.h"

namespace macula::slices {

// In pixels of the picture, as SliceFrame counts them: the centre of the first pixel is (0.5, 0.5). A closed
// line ends at the point where it begins. No two neighbouring points are equal.
using ContourLine = std::vector<glm::dvec2>;

// The lines between values of at least `level` and lower ones, which are on the left of a line that is drawn
// with y downwards. Along a side between two neighbouring pixels the value is linear. Where a square of four
// pixels has high values in two opposite corners, the saddle of its bilinear surface says whether these are
// joined. A square with NaN in a corner has no line, so lines end where values end. None for a slice of one
// row or column, for a level that is not finite, or after `cancelled` returned true; it is called for each
// row. May throw std::bad_alloc.
std::vector<ContourLine> contourLines(const SampledSlice& slice, double level,
                                      const std::function<bool()>& cancelled = {});

}  // namespace macula::slices
