#include "dicom/split/changes_along_stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "dicom/split/frame_order.h"

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

void tellChange(Stack& stack, const Text& attribute, const std::vector<std::size_t>& places) {
    tell(stack, message(key::kChangesAlongStack, {{"attribute", attribute},
                                                  {"slice", sliceOf(stack, places.front())},
                                                  {"changes", std::int64_t(places.size())}}));
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
    tellChange(stack,
               ofSlope && ofIntercept ? Text("{} and {}", "RescaleSlope", "RescaleIntercept")
               : ofSlope              ? Text::verbatim("RescaleSlope")
                                      : Text::verbatim("RescaleIntercept"),
               places);
}

constexpr double kLongS = 30.0;       // longer than a pause for breath between two parts of one acquisition
constexpr double kTimesUsual = 20.0;  // times the usual pause between neighbours
constexpr std::size_t kMostGaps = 4;  // more are normal for that scanner
constexpr double kSecondsOfMinute = 60.0;

// The acquisition times, if all frames have one. Not content times: images may be reconstructed at any time.
std::vector<double> acquisitionTimes(const Stack& stack, const SplitRules& rules) {
    for (const std::size_t attribute : rules.runs) {
        if (rules.attributes[attribute].name != "AcquisitionTime") continue;
        std::vector<double> times;
        for (const auto& time : orderValues(stack.frames, rules, attribute)) {
            if (time) times.push_back(*time);
        }
        if (times.size() == stack.frames.size()) return times;
    }
    return {};
}

// The number of the slice that a frame is, from 1 as on screen.
std::size_t numberOfSlice(const Stack& stack, std::size_t frame) {
    const auto found =
        std::ranges::find_if(stack.slices, [&](const SliceSource& slice) { return slice.above >= frame; });
    return static_cast<std::size_t>(found - stack.slices.begin()) + 1;
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
        tellChange(stack, Text::verbatim(rules.attributes[rule.attribute].name), places);
    }
    tellRescaleChanges(stack);
}

void tellAcquiredApart(Stack& stack, const SplitRules& rules) {
    // The beds of emission tomography follow each other after minutes.
    if (!stack.canBeVolume() || stack.modality == "PT" || stack.modality == "NM") return;
    const std::vector<double> times = acquisitionTimes(stack, rules);
    if (times.size() < 3) return;
    std::vector<double> pauses;
    for (std::size_t n = 1; n < times.size(); ++n) pauses.push_back(std::abs(times[n] - times[n - 1]));
    std::vector<double> sorted = pauses;
    std::ranges::sort(sorted);
    const double usual = sorted[sorted.size() / 2];
    std::vector<std::size_t> begins;  // the first frame of each part but the first
    double longest = 0.0;
    for (std::size_t n = 0; n < pauses.size(); ++n) {
        if (pauses[n] <= std::max(kLongS, kTimesUsual * usual)) continue;
        begins.push_back(n + 1);
        longest = std::max(longest, pauses[n]);
    }
    if (begins.empty() || begins.size() > kMostGaps) return;
    // Names the slices of a part in the middle, or those of the second of two parts.
    const std::size_t first = numberOfSlice(stack, begins.front());
    const std::size_t last = begins.size() > 1 ? numberOfSlice(stack, begins.back() - 1)
                                               : numberOfSlice(stack, stack.frames.size() - 1);
    tell(stack, message(key::kAcquiredApart, {{"slices", first == last ? fmt::format("{}", first)
                                                                       : fmt::format("{}-{}", first, last)},
                                              {"minutes", longest / kSecondsOfMinute}}));
}

}  // namespace macula::dicom
