// Divides frames by their attributes and by where they lie.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "dicom/stack/instance.h"
#include "dicom/stack/split_rules.h"

namespace macula::dicom {

struct Part {
    std::vector<std::string> values;  // one per attribute, from the first of its frames
    std::vector<std::size_t> frames;  // ascending
};

// Every frame is in exactly one part; no part is empty.
using Partition = std::vector<Part>;

// Frames with the same value of every one of `attributes`, ascending by value (numbers as numbers).
Partition partitionByValue(std::span<const Frame> frames, const SplitRules& rules,
                           const std::vector<std::size_t>& attributes);

// The parts of `finer`, whose indices count within `coarse`, with indices of all frames.
Partition within(const Part& coarse, const Partition& finer);

// The number of positions along the normal whose part is not that of the position before.
std::size_t alternations(std::span<const Frame> frames, const Partition& partition);

// Separates the frames of the first, the second … file that share a SOP Instance UID and a position: files at
// other positions are not copies, because some writers give one UID to all slices.
Partition separateCopies(std::span<const Frame> frames);

// Separates the first frame at each position from all others.
Partition separateRepetitions(std::span<const Frame> frames);

// Divides frames at gaps of many slices: one part without a gap, none for fewer than three positions.
Partition separateAtGaps(std::span<const Frame> frames);

}  // namespace macula::dicom
