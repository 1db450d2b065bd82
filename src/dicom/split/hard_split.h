// The first step from frames to stacks: what is never in one stack.
#pragma once

#include <functional>
#include <vector>

#include "dicom/stack/split_rules.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

struct HardPart {
    std::vector<Frame> frames;
    std::vector<StackLabel> labels;
    std::vector<Message> told;  // messages for each of its stacks
};

// A function that says which stacks frames would become.
using TryStacks = std::function<std::vector<Stack>(std::vector<Frame>)>;

// Separates frames by the hard rules, and those without a position from those with one. Frames that are then
// alone although they differ only in how they lie stay together. Coordinate systems (FrameOfReferenceUID)
// that no two images share, or that some do not name, separate nothing when volumes come of that: those parts
// are told, and have none. A few images that are separated from many by where they lie are a warning.
std::vector<HardPart> splitHard(std::vector<Frame> frames, const SplitRules& rules,
                                const TryStacks& tryStacks, std::vector<Message>& messages);

}  // namespace macula::dicom
