// Assigns images to phases: sets that were taken one after another at the same places.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "dicom/split/frame_order.h"
#include "dicom/split/partition.h"

namespace macula::dicom {

struct Phases {
    Partition parts;  // one for each phase, in the order of the value; without `values`
    // Frames in no part: their phase is unknown, or has another frame there.
    std::vector<std::size_t> unclear;
    std::vector<std::size_t> byNumber;  // frames in a part by their number, because the value does not decide
};

// Ranks the frames at each position by `values`, one for each frame, if the ranks agree along the stack.
// Image numbers in order decide where the value does not; a frame whose value and number disagree is unclear.
// Nothing when there are not two phases, too few positions agree, or the order at a position may be chance.
std::optional<Phases> phasesByRank(std::span<const Frame> frames,
                                   std::span<const std::optional<double>> values);

}  // namespace macula::dicom
