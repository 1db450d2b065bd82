// Whether every other slice of a volume is of another kind than those between.
#pragma once

#include <span>

namespace macula::dicom {

// `slices` have the same number of values each, and follow each other at one distance. Looks at the part of
// their differences that changes its sign with every slice, at the same place in the plane: noise and anatomy
// have no more of it than of others, two acquisitions that were mixed have little else. False for fewer than
// eight slices.
bool alternates(std::span<const std::span<const float>> slices);

// The same of their noise, as of a sharp and a soft kernel, whose values are the same: that of each slice,
// between neighbours in a row, is above, or below, that of both slices beside it. `slices` are of
// SliceSamples.
bool noiseAlternates(std::span<const std::span<const float>> slices);

}  // namespace macula::dicom
