// How much of a picture to submit to the device at once, for kernels that take about as long for every pixel.
//
// A graphics driver resets a device that is busy with one submission for too long: Windows does so after 2 s
// (timeout detection and recovery). With these limits a submission takes less than 0.2 s on a card that has a
// 150th of an H100's speed. That is an estimate; nobody has measured such a card.
#pragma once

#include <algorithm>
#include <cstdint>

namespace macula::trace {

// The rows to submit at once, in whole groups, of a picture whose centre rays are marched through matter. On
// a CPU device, where a pixel takes about a microsecond, they take short enough for a cancel.
constexpr int rowsToMarchAtOnce(bool isCpu, int width, int height) {
    const int pixels = isCpu ? 1 << 15 : 1 << 19;
    return std::clamp(pixels / width / 8 * 8, 8, height + 7);
}

// The portions of the denoiser, which processes the picture in several stages. A submission ends when its
// dispatches have processed `enoughPixels`, counted over all stages.
struct FilterPortion {
    int rowsAtOnce = 0;  // rows of one dispatch
    std::int64_t enoughPixels = 0;
};
constexpr FilterPortion filterPortion(bool isCpu, bool isInterruptible, int width, int height) {
    // A CPU takes up to 0.3 microseconds for a pixel of a stage, so some 40 ms for a dispatch. No driver
    // resets a CPU: only a cancel needs short dispatches.
    if (isCpu && isInterruptible) return {std::max((1 << 17) / width / 8 * 8, 8), 1};
    if (isCpu) return {height, INT64_MAX};
    // For a small picture waiting for each stage would take longer than the stages: a submission has several.
    constexpr int kPixels = 1 << 21;
    return {std::clamp(kPixels / width / 8 * 8, 8, height + 7), isInterruptible ? kPixels / 2 : kPixels};
}

}  // namespace macula::trace
