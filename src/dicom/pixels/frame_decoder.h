// Decodes the frames of a stack on all cores, each into its target.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "dicom/pixels/slice_samples.h"
#include "dicom/stack/intensity.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

enum class FrameState : std::uint8_t {
    waiting,
    decoded,
    cutOff,      // the file ends before the frame does
    damaged,     // or changed since the scan
    unreadable,  // the file cannot be opened
};

class FrameDecoder {
  public:
    // The destination of a frame: `stored` or `values`, depending on plan.format. Both must outlive the
    // decoder.
    struct Target {
        std::span<std::uint16_t> stored;
        std::span<float> values;
    };

    // `samples`, unless null, receives the samples of each decoded frame, while its values are in the cache.
    FrameDecoder(const Stack& stack, std::span<const SliceIntensity> intensities, const IntensityPlan& plan,
                 std::span<const Target> targets, SliceSamples* samples = nullptr);

    // Decodes frames in this order; each thread opens a file with many frames once. A decoding thread calls
    // `onFirst` at most once, when the first `count` of `order` are done, decoded or not. Continues when
    // frames cannot be decoded; fails with outOfMemory or cancelled.
    Result<void> run(std::span<const std::size_t> order, std::size_t count,
                     const std::function<void()>& onFirst, Progress& progress);

    FrameState state(std::size_t frame) const { return states_[frame]; }
    // Counts of a decoded frame: see intensity.h.
    std::size_t cellsBeyondStoredBits(std::size_t frame) const { return beyondStoredBits_[frame]; }
    std::size_t notFinite(std::size_t frame) const { return notFinite_[frame]; }
    // The error of the first frame, in the order of the stack, that could not be decoded.
    std::optional<Error> failure() const;

  private:
    struct Worker;
    Error decode(std::size_t frame, Worker& worker,
                 const CancelToken& cancel);  // without a message on success

    const Stack& stack_;
    std::span<const SliceIntensity> intensities_;
    const IntensityPlan& plan_;
    std::span<const Target> targets_;
    SliceSamples* samples_;
    std::vector<FrameState> states_;  // each written by one thread, once
    std::vector<Error> errors_;
    std::vector<std::size_t> beyondStoredBits_;
    std::vector<std::size_t> notFinite_;
};

}  // namespace macula::dicom
