// Slices whose values cannot be right beside those of their neighbours, and steps where the rescale changes.
// By samples; pure functions.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "dicom/pixels/slice_samples.h"
#include "dicom/stack/intensity.h"

namespace macula::dicom {

enum class SliceFault {
    otherSign,     // read with the other sign, the values are those of the neighbours
    swappedBytes,  // with the bytes of each cell exchanged, the values are those of the neighbours
    blank,         // one value, in all of it or from some row on, where both neighbours have an image
    unlike,        // no slice between its neighbours, which resemble each other; nobody knows why
};

struct OddSlice {
    std::size_t slice = 0;
    SliceFault fault = SliceFault::unlike;

    bool operator==(const OddSlice&) const = default;
};

// Those of `slices`, which ascend along the stack and are in `samples` and `intensities` at these places. All
// but `unlike` are certain, however many they are; of these there are few or none. A blank slice at an end
// may be real, and is not told. Slices that are all read wrongly have no neighbours to tell: see
// findFaultOfAll.
std::vector<OddSlice> findOddSlices(std::span<const std::size_t> slices, const SliceSamples& samples,
                                    std::span<const SliceIntensity> intensities);

// otherSign or swappedBytes when neighbours in the planes differ far less when cells are read so.
std::optional<SliceFault> findFaultOfAll(std::span<const std::size_t> slices, const SliceSamples& samples,
                                         std::span<const SliceIntensity> intensities);

struct RescaleStep {
    std::size_t slice = 0;  // the first with the rescale of the other side
    double step = 0.0;      // how far values jump there; above 0
};

// Where rescale slope or intercept change from one slice to the next, and stored values do not make up for
// it: with the rescale of the slice before, values go on smoothly. A scanner that changes its rescale changes
// what it stores along with it. Nothing where it changes at more than half of the slices.
std::vector<RescaleStep> findRescaleSteps(std::span<const std::size_t> slices, const SliceSamples& samples,
                                          std::span<const SliceIntensity> intensities);

}  // namespace macula::dicom
