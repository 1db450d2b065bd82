// Acquisitions of one series that lie between each other or overlap, found by when they were made or where
// they lie.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "dicom/split/partition.h"

namespace macula::dicom {

// `count` runs, each of which is over before the next one begins: the frames sorted by their values, cut
// where the longest pauses are. Parts have no `values`. Empty when a frame has no value, or there are fewer
// pauses.
Partition partitionByRuns(std::span<const std::optional<double>> values, std::size_t count);

// The ways of images that are numbered one after another: each goes along the normal in one direction, and
// the next one begins where the numbers turn back. Parts have no `values`. Empty when there is one way, or a
// number is missing or not the only one.
Partition partitionByWays(std::span<const Frame> frames);

// Up to six sets of frames, each at multiples of one distance from its first, which is the same for all.
// Empty when the frames lie otherwise, or on one lattice of a part of that distance with slices missing.
Partition separateLattices(std::span<const Frame> frames);

}  // namespace macula::dicom
