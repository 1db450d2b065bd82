// Separates acquisitions of one series that interleave or overlap, by their times, numbers or places.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "dicom/split/partition.h"

namespace macula::dicom {

// Divides the frames, sorted by their values, into `count` runs at the longest pauses. Parts have no
// `values`. Empty when a frame has no value, or there are too few pauses.
Partition partitionByRuns(std::span<const std::optional<double>> values, std::size_t count);

// Divides images into passes along the normal: in the order of their numbers, each pass moves in one
// direction, and the next one begins where they turn back. Parts have no `values`. Empty when there is one
// pass, or when a number is missing or repeated.
Partition partitionByWays(std::span<const Frame> frames);

// Divides frames into two to six lattices: each lies at multiples of one distance, the same for all, from its
// first frame. Empty when the frames lie otherwise, or all on one finer lattice with slices missing.
Partition separateLattices(std::span<const Frame> frames);

}  // namespace macula::dicom
