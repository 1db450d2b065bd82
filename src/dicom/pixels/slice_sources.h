// Makes the slices of a volume from the available frames: copied, or blended from two. Pure functions.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/volume.h"
#include "dicom/stack/geometry.h"

namespace macula::dicom {

struct UsableSlices {
    std::size_t first = 0;            // index of the first usable slice among those given
    std::vector<SliceSource> slices;  // none when no frame is usable
};

// The same slices without the frames that are not `usable`: interpolates the affected slices between the
// nearest two usable frames, and cuts them off at the ends. `places` are the frames' positions on the grid,
// in slices, ascending; slice k lies at k.
UsableSlices withoutFrames(std::span<const SliceSource> slices, std::span<const double> places,
                           const std::vector<bool>& usable);

std::vector<SliceRange> interpolatedRanges(std::span<const SliceSource> slices);

// "3, 5-7": counted from 1.
std::string describe(std::span<const SliceRange> ranges);

// result = (1 - weight) * below + weight * above; where either is padding, the value of the nearer one.
void blend(std::span<const std::uint16_t> below, std::span<const std::uint16_t> above, double weight,
           const std::optional<StoredRange>& padding, std::span<std::uint16_t> result);
void blend(std::span<const float> below, std::span<const float> above, double weight,
           std::span<float> result);

}  // namespace macula::dicom
