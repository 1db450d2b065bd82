// Orders the frames of a series by values of an attribute, as numbers, and by places along the normal.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "dicom/stack/instance.h"
#include "dicom/stack/split_rules.h"

namespace macula::dicom {

// The value of each frame, in the order of the frames: numbers as they are, times in seconds; nothing for a
// frame without one. Times of one day, or without a date, are taken to run across midnight if otherwise more
// than half a day would lie between two neighbours. If some times have a date and others none they cannot be
// compared, and no frame gets a value.
std::vector<std::optional<double>> orderValues(std::span<const Frame> frames, const SplitRules& rules,
                                               std::size_t attribute);
// The InstanceNumber of each frame; nothing for frames of multi-frame files, which share one.
std::vector<std::optional<double>> instanceNumbers(std::span<const Frame> frames);

// Frames in groups at one position, ascending along the normal of the first frame.
struct Positions {
    std::vector<std::vector<std::size_t>> groups;  // indices of frames
    std::vector<double> alongMm;                   // position of the first frame of each group
};

// Groups frames that lie at most `toleranceMm` along the normal from the first of their group. Empty when a
// frame has no plane.
Positions positionsOf(std::span<const Frame> frames, double toleranceMm = kSamePositionMm);

// The tolerance for frames that were taken at one place: kSamePositionMm, or more where the table drifted
// between acquisitions, so that frames lie in clusters whose distances are large compared with their extent.
double placeToleranceMm(std::span<const Frame> frames);

}  // namespace macula::dicom
