#include "dicom/split/stack_maker.h"

#include <algorithm>
#include <utility>

#include "dicom/split/split_messages.h"
#include "dicom/stack/odd_images.h"

namespace macula::dicom {

Stack makeStack(std::vector<Frame> frames, std::vector<StackLabel> labels, const std::string& modality) {
    Stack stack;
    stack.frames = std::move(frames);
    stack.splitBy = std::move(labels);
    stack.modality = modality;
    assess(stack, modality);
    return stack;
}

std::vector<std::string> StackMaker::namesOf(const std::vector<std::size_t>& attributes) const {
    std::vector<std::string> names;
    for (const std::size_t attribute : attributes) names.push_back(rules_.attributes[attribute].name);
    return names;
}

std::vector<Stack> StackMaker::stacksOf(const Stack& whole, const Partition& partition,
                                        const std::vector<std::string>& names) const {
    std::vector<Stack> stacks;
    for (const Part& part : partition) {
        std::vector<Frame> frames;
        for (const std::size_t index : part.frames) frames.push_back(whole.frames[index]);
        std::vector<StackLabel> labels = whole.splitBy;
        for (std::size_t i = 0; i < names.size(); ++i) labels.push_back({names[i], part.values[i]});
        stacks.push_back(makeStack(std::move(frames), std::move(labels), modality_));
    }
    return stacks;
}

void StackMaker::addUnclear(const Stack& whole, std::vector<std::size_t> frames, std::vector<Stack>& stacks,
                            std::vector<Message>& messages) const {
    if (frames.empty()) return;
    std::ranges::sort(frames);
    const Text numbers = describeNumbers(whole, frames);
    tellAll(stacks, messages, message(key::kUnclearAcquisition, {{"numbers", numbers}}));
    Stack stack = std::move(stacksOf(whole, {{{"not clear"}, std::move(frames)}}, {"Acquisition"}).front());
    if (stack.canBeVolume()) {
        stack.messages.push_back(
            message(key::kUnclearAcquisition, Severity::blocksVolume, {{"numbers", numbers}}));
    }
    stacks.push_back(std::move(stack));
}

}  // namespace macula::dicom
