// The first step from frames to stacks: separates frames that never share a stack.
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

// Returns the stacks that the frames would become.
using TryStacks = std::function<std::vector<Stack>(std::vector<Frame>)>;

// Separates frames by the hard rules, and those without a position from those with one. Rejoins lone frames
// that differ only in orientation or spacing. Coordinate systems (FrameOfReferenceUID) that no two images
// share, or that some lack, separate nothing if volumes result: such parts get a message and no coordinate
// system. Warns when placement separates a few images from many.
std::vector<HardPart> splitHard(std::vector<Frame> frames, const SplitRules& rules,
                                const TryStacks& tryStacks, std::vector<Message>& messages);

}  // namespace macula::dicom
