#include "dicom/split/changes_along_stack.h"

#include <algorithm>
#include <string>
#include <vector>

namespace macula::dicom {

namespace {

// Indices in stack.frames at which the value differs from that of the frame before.
std::vector<std::size_t> changesOf(const Stack& stack, const SplitRules& rules, std::size_t attribute) {
    std::vector<std::size_t> places;
    for (std::size_t f = 1; f < stack.frames.size(); ++f) {
        if (!sameValue(rules.attributes[attribute], stack.frames[f - 1].attributes[attribute],
                       stack.frames[f].attributes[attribute])) {
            places.push_back(f);
        }
    }
    return places;
}

// The number of the slice, counted from 1 as on screen.
std::int64_t sliceOf(const Stack& stack, std::size_t frame) {
    std::size_t slice = 0;
    while (slice + 1 < stack.slices.size() && stack.slices[slice].above < frame) ++slice;
    return static_cast<std::int64_t>(slice) + 1;
}

void tell(Stack& stack, const Text& attribute, const std::vector<std::size_t>& places) {
    Message told = message(key::kChangesAlongStack, {{"attribute", attribute},
                                                     {"slice", sliceOf(stack, places.front())},
                                                     {"changes", std::int64_t(places.size())}});
    stack.assumptions.push_back(told.sentence);
    stack.messages.push_back(std::move(told));
}

// Warns of a few places at which the rescale changes. In PET and some MR it changes from image to image;
// another message (kDeviatingRescale) names a few images with another rescale.
void tellRescaleChanges(Stack& stack) {
    const auto isTold = [](const Message& m) { return m.key == key::kDeviatingRescale; };
    if (std::ranges::any_of(stack.messages, isTold)) return;
    std::vector<std::size_t> places;
    bool ofSlope = false;
    bool ofIntercept = false;
    for (std::size_t f = 1; f < stack.frames.size(); ++f) {
        const Frame& before = stack.frames[f - 1];
        const Frame& here = stack.frames[f];
        if (before.slope == here.slope && before.intercept == here.intercept) continue;
        ofSlope = ofSlope || before.slope != here.slope;
        ofIntercept = ofIntercept || before.intercept != here.intercept;
        places.push_back(f);
    }
    constexpr std::size_t kFewOf = 8;
    if (places.empty() || kFewOf * places.size() > stack.frames.size()) return;
    tell(stack,
         ofSlope && ofIntercept ? Text("{} and {}", "RescaleSlope", "RescaleIntercept")
         : ofSlope              ? Text::verbatim("RescaleSlope")
                                : Text::verbatim("RescaleIntercept"),
         places);
}

}  // namespace

void tellChanges(Stack& stack, const SplitRules& rules) {
    if (!stack.canBeVolume()) return;
    using Step = SplitRules::Soft::Step;
    for (const SplitRules::Soft& rule : rules.soft) {
        if (rule.step == Step::silent) continue;
        if (!rule.modality.empty() && rule.modality != stack.modality) continue;
        const auto places = changesOf(stack, rules, rule.attribute);
        if (places.empty() || (rule.step == Step::once && places.size() != 1)) continue;
        tell(stack, Text::verbatim(rules.attributes[rule.attribute].name), places);
    }
    tellRescaleChanges(stack);
}

}  // namespace macula::dicom
