#include "dicom/frame_loader.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>
#include <utility>

#include "base/available_memory.h"
#include "base/exceptions.h"
#include "dicom/pixels/cell_alignment.h"
#include "dicom/pixels/frame_decoder.h"
#include "dicom/read/dataset.h"

namespace macula::dicom {

namespace {

Error asError(const Message& why) {
    return {ErrorCode::inputNotUsable, why.sentence, {}, why.action};
}

Result<void> check(const Instance& instance) {
    if (instance.samplesPerPixel != 1 || !instance.photometricInterpretation.starts_with("MONOCHROME"))
        return asError(message(key::kColourImage));
    if (!instance.format) return asError(message(key::kUnsupportedBits));
    if (std::min(instance.columns, instance.rows) < 1 ||
        std::max(instance.columns, instance.rows) > kMostRows) {
        return Error{ErrorCode::inputNotUsable,
                     Text("The image has no usable size."),
                     {},
                     Text("Choose another series.")};
    }
    return {};
}

// The intensity of the frame, with the padding that loadVolume would use.
SliceIntensity intensityOf(const Stack& stack, std::size_t frame) {
    std::vector<SliceIntensity> all;
    std::size_t own = 0;
    for (std::size_t f = 0; f < stack.frames.size(); ++f) {
        if (!stack.frames[f].instance->format) continue;
        if (f == frame) own = all.size();
        all.push_back(sliceIntensity(stack.frames[f]));
    }
    completePadding(all);
    return std::move(all[own]);
}

Result<LoadedFrame> decode(const Stack& stack, std::size_t frame, const CancelToken& cancel) {
    const Instance& instance = *stack.frames[frame].instance;
    MACULA_TRY_VOID(check(instance));
    const std::size_t count =
        static_cast<std::size_t>(instance.columns) * static_cast<std::size_t>(instance.rows);
    // The cells of the file, each at most as wide as a double, are in memory together with the values.
    const std::uint64_t bytes = std::uint64_t{count} * (sizeof(float) + sizeof(double));
    if (const auto available = availableMemory(); available && bytes > *available)
        return notEnoughMemory(bytes, *available);

    LoadedFrame loaded{.columns = instance.columns, .rows = instance.rows, .values = {}};
    loaded.values.resize(count);
    Stack alone;
    alone.frames.push_back(stack.frames[frame]);
    std::array intensities{intensityOf(stack, frame)};
    alignCells(alone, intensities, cancel);
    const std::array targets{FrameDecoder::Target{.stored = {}, .values = loaded.values}};
    const IntensityPlan plan{.format = VoxelFormat::float32};
    FrameDecoder decoder(alone, intensities, plan, targets);
    constexpr std::array<std::size_t, 1> kOrder{0};
    Progress progress({}, cancel);
    MACULA_TRY_VOID(decoder.run(kOrder, 0, {}, progress));
    if (auto failure = decoder.failure()) return *std::move(failure);
    return loaded;
}

}  // namespace

Result<LoadedFrame> loadFrame(const Stack& stack, std::size_t frame, const CancelToken& cancel) {
    MACULA_CHECK(frame < stack.frames.size());
    try {
        return decode(stack, frame, cancel);
    } catch (const std::exception& thrown) {
        return errorOf(thrown, Text("decode the image"));
    }
}

}  // namespace macula::dicom
