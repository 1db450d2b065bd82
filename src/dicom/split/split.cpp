#include "dicom/split/split.h"

#include <algorithm>
#include <map>

#include "dicom/split/changes_along_stack.h"
#include "dicom/split/hard_split.h"
#include "dicom/split/partition.h"
#include "dicom/split/splitter.h"
#include "dicom/split/stack_maker.h"
#include "dicom/stack/odd_images.h"

namespace macula::dicom {

namespace {

// A total order that depends on the images only, so that neither file names nor the file system matter.
void sortFrames(std::vector<Frame>& frames) {
    std::stable_sort(frames.begin(), frames.end(), [](const Frame& a, const Frame& b) {
        const auto key = [](const Frame& f) {
            return std::tuple(f.instance->instanceNumber.value_or(0),
                              std::string_view(f.instance->sopInstanceUid), f.number);
        };
        return key(a) < key(b);
    });
}

// The number of frames that share UID and frame number with another one of the part.
std::size_t countOfSharedUids(const Part& part, const std::vector<Frame>& frames) {
    std::map<std::pair<std::string_view, int>, std::size_t> counts;
    for (const std::size_t index : part.frames) {
        const std::string& uid = frames[index].instance->sopInstanceUid;
        if (!uid.empty()) ++counts[{uid, frames[index].number}];
    }
    std::size_t sharing = 0;
    for (const auto& [frame, count] : counts) sharing += count > 1 ? count : 0;
    return sharing;
}

std::string modalityOf(const std::vector<Frame>& frames, const std::string& ofSeries) {
    const std::string& own = frames.front().instance->modality;
    return own.empty() ? ofSeries : own;
}

// Removes files that share a UID and a position, but differ, as stacks of their own; the first of each stays.
std::vector<Stack> takeCopies(std::vector<Frame>& frames, const std::string& modality,
                              std::vector<Message>& messages) {
    const Partition partition = separateCopies(frames);
    std::vector<Stack> stacks;
    if (const std::size_t sharing = countOfSharedUids(partition.front(), frames); sharing > 0)
        messages.push_back(message(key::kSharedInstanceUid, {{"count", std::int64_t(sharing)}}));
    if (partition.size() < 2) return stacks;
    for (std::size_t copy = 1; copy < partition.size(); ++copy) {
        std::vector<Frame> taken;
        for (const std::size_t index : partition[copy].frames) taken.push_back(frames[index]);
        const std::string own = modalityOf(taken, modality);
        stacks.push_back(makeStack(std::move(taken), {{"Copy", partition[copy].values.front()}}, own));
    }
    messages.push_back(message(key::kDuplicateInstances,
                               {{"count", std::int64_t(frames.size() - partition.front().frames.size())}}));
    std::vector<Frame> kept;
    for (const std::size_t index : partition.front().frames) kept.push_back(std::move(frames[index]));
    frames = std::move(kept);
    return stacks;
}

}  // namespace

Split splitSeries(std::vector<Frame> frames, const std::string& modality, const SplitRules& rules,
                  const CancelToken& cancel) {
    Split split;
    if (frames.empty()) return split;
    sortFrames(frames);
    std::vector<Stack> copies = takeCopies(frames, modality, split.messages);
    const std::optional<Message> unplaced = imagesWithoutPosition(frames);
    const TryStacks tryStacks = [&](std::vector<Frame> tried) {
        std::vector<Message> unused;
        const std::string ofTried = modalityOf(tried, modality);
        return Splitter(ofTried, rules, cancel).split(std::move(tried), {}, unused);
    };
    std::vector<Stack> leftOut;
    for (HardPart& part : splitHard(std::move(frames), rules, tryStacks, split.messages)) {
        const std::string ofPart = modalityOf(part.frames, modality);
        if (unplaced && part.frames.front().positionMm) part.told.push_back(*unplaced);
        for (OddImages& odd : takeOddImages(part.frames, ofPart)) {
            std::vector<StackLabel> labels = part.labels;
            labels.push_back(odd.label);
            leftOut.push_back(makeStack(std::move(odd.frames), std::move(labels), ofPart));
            part.told.push_back(std::move(odd.message));
        }
        for (Stack& stack : Splitter(ofPart, rules, cancel)
                                .split(std::move(part.frames), std::move(part.labels), split.messages)) {
            for (const Message& told : part.told) {
                stack.messages.push_back(told);
                stack.assumptions.push_back(told.sentence);
            }
            split.stacks.push_back(std::move(stack));
        }
    }
    for (Stack& stack : leftOut) split.stacks.push_back(std::move(stack));
    for (Stack& stack : copies) split.stacks.push_back(std::move(stack));
    for (Stack& stack : split.stacks) {
        tellChanges(stack, rules);
        tellAcquiredApart(stack, rules);
    }
    return split;
}

}  // namespace macula::dicom
