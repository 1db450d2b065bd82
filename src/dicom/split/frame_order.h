// What orders the frames of a series: values of an attribute as numbers, and places along the normal.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "dicom/stack/instance.h"
#include "dicom/stack/split_rules.h"

namespace macula::dicom {

// The value of each frame as a number, in the order of the frames: numbers as they are, times in seconds. A
// frame without one has none. Times that all lie on one day, or that have no date, are taken to run across
// midnight where most of a day would lie between two of them otherwise. No frame has a value where some times
// have a date and others none: such times cannot be compared.
std::vector<std::optional<double>> orderValues(std::span<const Frame> frames, const SplitRules& rules,
                                               std::size_t attribute);
// The number of each image; none for frames of multi-frame files, which share one.
std::vector<std::optional<double>> instanceNumbers(std::span<const Frame> frames);

// Frames in groups at one position, ascending along the normal of the first frame.
struct Positions {
    std::vector<std::vector<std::size_t>> groups;  // of places in the frames given
    std::vector<double> alongMm;                   // of the first frame of each group
};

// Frames at most `toleranceMm` along the normal from the first of their group. Empty when a frame has no
// plane.
Positions positionsOf(std::span<const Frame> frames, double toleranceMm = kSamePositionMm);

// How far apart frames lie that were taken at one place: kSamePositionMm, or more where the table drifted
// between several acquisitions, so that frames lie in clusters that are far apart beside their extent.
double placeToleranceMm(std::span<const Frame> frames);

}  // namespace macula::dicom
