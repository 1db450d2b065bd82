// From the frames of a series to its stacks, by the rules of split_rules.h.
#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "dicom/split_rules.h"
#include "dicom/stack.h"

namespace macula::dicom {

struct Split {
    std::vector<Stack> stacks;  // assessed; those of one volume's phases follow each other
    std::vector<Message> messages;
};

// Every frame is in exactly one stack. In this order:
//   - of files that share a SOP Instance UID the first stays, and the others are stacks of their own;
//   - hard attributes separate, and frames without a position from those with one; frames that are then alone
//     although they differ only in how they lie stay together as a stack that is no volume;
//   - images that cannot be what they say (odd_images.h) are stacks of their own, and gaps in the others;
//   - what is a volume is kept whole; a volume with gaps only gives way to parts that are whole and
//   interleave;
//   - soft attributes separate, one or two of them, when the parts are volumes;
//   - frames at the same positions are told apart as phases, by value or by rank;
//   - of a few repeated positions the frames with the lowest number make the volume, and the rest are a stack
//     of their own;
//   - far apart blocks are separated where the gap is;
//   - else the stack stays whole, is no volume, and its message asks.
// Deterministic: the order of `frames` does not matter. Once cancelled, nothing more is separated, and the
// result is to be thrown away.
Split splitSeries(std::vector<Frame> frames, const std::string& modality, const SplitRules& rules,
                  const CancelToken& cancel = {});

}  // namespace macula::dicom
