// Phases: images that were taken at the same places, one set after another, and which image is of which.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "dicom/split/frame_order.h"
#include "dicom/split/partition.h"

namespace macula::dicom {

struct Phases {
    Partition parts;                    // one for each phase, in the order of the value; without `values`
    std::vector<std::size_t> unclear;   // frames in no part: nothing tells their phase, or it is taken
    std::vector<std::size_t> byNumber;  // frames in a part by their number, which their value does not say
};

// Ranks the frames at each position by `values`, one for each frame, where the ranks agree along the stack.
// Image numbers that run in order decide where the value does not, and contradict it where they tell
// otherwise: an image that was reconstructed once more, later than all others, keeps its phase. Nothing when
// there are no two phases, too few positions agree, or the order at a position may be a matter of chance.
std::optional<Phases> phasesByRank(std::span<const Frame> frames,
                                   std::span<const std::optional<double>> values);

}  // namespace macula::dicom
