#include "dicom/split/acquisition_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dicom/split/frame_order.h"

namespace macula::dicom {

namespace {

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
std::size_t sliceOf(const Stack& stack, std::size_t frame) {
    const auto found =
        std::ranges::find_if(stack.slices, [&](const SliceSource& slice) { return slice.above >= frame; });
    return static_cast<std::size_t>(found - stack.slices.begin()) + 1;
}

}  // namespace

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
    const std::size_t first = sliceOf(stack, begins.front());
    const std::size_t last =
        begins.size() > 1 ? sliceOf(stack, begins.back() - 1) : sliceOf(stack, stack.frames.size() - 1);
    Message told =
        message(key::kAcquiredApart,
                {{"slices", first == last ? fmt::format("{}", first) : fmt::format("{}-{}", first, last)},
                 {"minutes", longest / kSecondsOfMinute}});
    stack.assumptions.push_back(told.sentence);
    stack.messages.push_back(std::move(told));
}

}  // namespace macula::dicom
