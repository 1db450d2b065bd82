// Finds slices whose values contradict those of their neighbours, and steps where the rescale changes, by
// samples. Pure functions.
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
    unlike,        // differs from its neighbours, which resemble each other; the cause is unknown
};

struct OddSlice {
    std::size_t slice = 0;
    SliceFault fault = SliceFault::unlike;

    bool operator==(const OddSlice&) const = default;
};

// The odd ones of `slices`: ascending indices along the stack, into `samples` and `intensities`. All faults
// but `unlike` are certain, whatever their number; `unlike` is given for a few slices or none. A blank slice
// at an end may be real, and is not reported. For stacks in which all slices are wrong see findFaultOfAll.
std::vector<OddSlice> findOddSlices(std::span<const std::size_t> slices, const SliceSamples& samples,
                                    std::span<const SliceIntensity> intensities);

// otherSign or swappedBytes when, read in that way, neighbours in a row differ far less.
std::optional<SliceFault> findFaultOfAll(std::span<const std::size_t> slices, const SliceSamples& samples,
                                         std::span<const SliceIntensity> intensities);

struct RescaleStep {
    std::size_t slice = 0;  // the first one with the new rescale
    double step = 0.0;      // how far values jump there; above 0
};

// Finds where rescale slope or intercept change from one slice to the next but stored values do not
// compensate: with the rescale of the slice before, values continue smoothly. A scanner that changes its
// rescale also changes what it stores. Empty where the rescale changes at more than half of the slices.
std::vector<RescaleStep> findRescaleSteps(std::span<const std::size_t> slices, const SliceSamples& samples,
                                          std::span<const SliceIntensity> intensities);

}  // namespace macula::dicom
