#include "dicom/pixels/image_checks.h"

#include <algorithm>
#include <map>

#include "dicom/pixels/odd_slices.h"
#include "dicom/stack/odd_images.h"

namespace macula::dicom {

namespace {

std::vector<std::size_t> indicesOf(const std::vector<bool>& usable) {
    std::vector<std::size_t> indices;
    for (std::size_t f = 0; f < usable.size(); ++f) {
        if (usable[f]) indices.push_back(f);
    }
    return indices;
}

// Bits outside of the stored ones are dropped. In an image that declares fewer bits than most of the stack,
// or in a few images of many, they belong to values that need them: then the truncated values are false, and
// the image is left out.
void leaveOutWhatNeedsMoreBits(const Stack& stack, std::span<const SliceIntensity> intensities,
                               const FrameDecoder& decoder, std::vector<bool>& usable,
                               std::vector<Message>& told) {
    std::vector<int> bits;
    std::vector<std::size_t> beyond;
    for (const std::size_t f : indicesOf(usable)) {
        bits.push_back(intensities[f].format.bitsStored);
        if (decoder.cellsBeyondStoredBits(f) > 0) beyond.push_back(f);
    }
    if (beyond.empty()) return;
    std::ranges::nth_element(bits, bits.begin() + static_cast<std::ptrdiff_t>(bits.size() / 2));
    const int usual = bits[bits.size() / 2];
    constexpr std::size_t kFewOf = 10;
    const bool few = kFewOf * beyond.size() <= bits.size();
    std::vector<std::size_t> leftOut;
    for (const std::size_t f : beyond) {
        if (!few && intensities[f].format.bitsStored >= usual) continue;
        usable[f] = false;
        leftOut.push_back(f);
    }
    if (!leftOut.empty()) {
        told.push_back(message(key::kBitsExceeded, {{"count", std::int64_t(leftOut.size())},
                                                    {"numbers", describeNumbers(stack, leftOut)}}));
    }
    if (leftOut.size() < beyond.size()) {
        told.push_back(message(key::kBitsDropped, {{"count", std::int64_t(beyond.size() - leftOut.size())},
                                                   {"total", std::int64_t(bits.size())}}));
    }
}

// The end of a sentence that begins with images: what is wrong with their pixels.
Text describe(SliceFault fault) {
    switch (fault) {
        case SliceFault::otherSign:
            return Text("have another sign than they say (PixelRepresentation)");
        case SliceFault::swappedBytes:
            return Text("have their bytes in the wrong order");
        case SliceFault::blank:
            return Text("have one value, in whole or from some row on, between images that go on there");
        case SliceFault::unlike:
            break;
    }
    return Text("do not fit");
}

Message oddValues(SliceFault fault, const Stack& stack, const std::vector<std::size_t>& odd,
                  std::size_t total, bool leftOut) {
    const TextArgument count{"count", std::int64_t(odd.size())};
    const TextArgument numbers{"numbers", describeNumbers(stack, odd)};
    if (fault == SliceFault::unlike) return message(key::kUnlikeNeighbours, {count, numbers});
    const TextArgument what{"fault", describe(fault)};
    if (leftOut) return message(key::kOddValues, {count, numbers, what});
    return message(key::kOddValuesKept, {count, what, {"total", std::int64_t(total)}});
}

void leaveOutOddValues(const Stack& stack, std::span<const SliceIntensity> intensities,
                       const SliceSamples& samples, std::vector<bool>& usable, std::vector<Message>& told) {
    const std::vector<std::size_t> frames = indicesOf(usable);
    std::map<SliceFault, std::vector<std::size_t>> faults;
    for (const OddSlice& odd : findOddSlices(frames, samples, intensities))
        faults[odd.fault].push_back(odd.slice);
    if (faults.empty()) {
        if (const auto fault = findFaultOfAll(frames, samples, intensities)) faults[*fault] = frames;
    }
    constexpr std::size_t kFewOf = 4;
    for (const auto& [fault, odd] : faults) {
        const bool leftOut = fault != SliceFault::unlike && kFewOf * odd.size() <= frames.size();
        told.push_back(oddValues(fault, stack, odd, frames.size(), leftOut));
        if (!leftOut) continue;
        for (const std::size_t f : odd) usable[f] = false;
    }
}

// The slice that begins at this frame, counted from 1.
std::int64_t sliceNumberOf(const Stack& stack, std::size_t frame) {
    const auto at =
        std::ranges::find_if(stack.slices, [&](const SliceSource& s) { return s.above >= frame; });
    return at - stack.slices.begin() + 1;
}

void tellRescaleSteps(const Stack& stack, std::span<const SliceIntensity> intensities,
                      const SliceSamples& samples, const std::vector<bool>& usable,
                      std::vector<Message>& told) {
    const std::vector<RescaleStep> steps = findRescaleSteps(indicesOf(usable), samples, intensities);
    if (steps.empty()) return;
    told.push_back(
        message(key::kRescaleStep, {{"count", std::int64_t(steps.size())},
                                    {"slice", sliceNumberOf(stack, steps.front().slice)},
                                    {"step", std::ranges::max(steps, {}, &RescaleStep::step).step}}));
}

}  // namespace

std::vector<Message> checkImages(const Stack& stack, std::span<const SliceIntensity> intensities,
                                 const FrameDecoder& decoder, const SliceSamples& samples,
                                 std::vector<bool>& usable) {
    std::vector<Message> told;
    leaveOutWhatNeedsMoreBits(stack, intensities, decoder, usable, told);
    leaveOutOddValues(stack, intensities, samples, usable, told);
    tellRescaleSteps(stack, intensities, samples, usable, told);
    return told;
}

}  // namespace macula::dicom
