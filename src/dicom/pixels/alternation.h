// Detects volumes in which slices of two kinds alternate.
#pragma once

#include <span>

namespace macula::dicom {

// `slices` have the same number of values each, and follow each other at one distance. Compares the part of
// their second differences that changes its sign with every slice, at the same place in the plane, with the
// whole: noise and anatomy have no more of it than of others, two mixed acquisitions have little else. False
// for fewer than eight slices.
bool alternates(std::span<const std::span<const float>> slices);

// Detects alternating noise, as of a sharp and a soft kernel with equal values: the noise of every other
// slice, measured between neighbours in a row, is above that of the slices beside it. `slices` are of
// SliceSamples.
bool noiseAlternates(std::span<const std::span<const float>> slices);

}  // namespace macula::dicom
