// Ways to divide frames: by what they say, by where they lie.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "dicom/stack/instance.h"
#include "dicom/stack/split_rules.h"

namespace macula::dicom {

struct Part {
    std::vector<std::string> values;  // one per attribute, as the first of its frames has it
    std::vector<std::size_t> frames;  // ascending
};

// Every frame is in exactly one part; no part is empty.
using Partition = std::vector<Part>;

// Frames with the same value of every one of `attributes`, ascending by value (numbers as numbers).
Partition partitionByValue(std::span<const Frame> frames, const SplitRules& rules,
                           const std::vector<std::size_t>& attributes);

// How often the next frame along the normal is in another part than the one before.
std::size_t alternations(std::span<const Frame> frames, const Partition& partition);

// Separates the frames of the first, the second … file with the same SOP Instance UID that lie at one
// position: an identifier that was given to all slices tells nothing.
Partition separateCopies(std::span<const Frame> frames);

// The first frame at each position, and all others.
Partition separateRepetitions(std::span<const Frame> frames);

// Consecutive blocks between which many slices are missing. One part when there is no such gap.
Partition separateAtGaps(std::span<const Frame> frames);

}  // namespace macula::dicom
