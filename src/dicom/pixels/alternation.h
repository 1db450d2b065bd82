// Detects volumes in which slices of two kinds alternate.
#pragma once

#include <span>

namespace macula::dicom {

// `slices` have the same number of values each, and follow each other at equal distances. Takes second
// differences along the slices at each place in the plane, and compares the part that changes its sign with
// every slice with the whole: in noise and anatomy it is no larger than other parts, in two mixed
// acquisitions it is nearly everything. False for fewer than eight slices.
bool alternates(std::span<const std::span<const float>> slices);

// Detects alternating noise, as of a sharp and a soft kernel with equal values: the noise of every other
// slice, measured between neighbours in a row, is above that of its neighbours. `slices` come from
// SliceSamples.
bool noiseAlternates(std::span<const std::span<const float>> slices);

}  // namespace macula::dicom
