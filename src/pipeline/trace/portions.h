// How much of a picture goes to the device at once, where each pixel takes about as long as any other.
//
// A graphics driver takes a device for dead that is busy with one submission for long: Windows does so after
// 2 s (timeout detection and recovery). With these limits a submission takes less than 0.2 s on a card that
// has a 150th of an H100's speed. That is an estimate; nobody has measured such a card.
#pragma once

#include <algorithm>
#include <cstdint>

namespace macula::trace {

// The rows that fit into one submission, in whole groups, of a picture whose centre rays are marched through
// matter. On a CPU device, where a pixel takes about a microsecond, it is short enough for a cancel.
constexpr int rowsToMarchAtOnce(bool isCpu, int width, int height) {
    const int pixels = isCpu ? 1 << 15 : 1 << 19;
    return std::clamp(pixels / width / 8 * 8, 8, height + 7);
}

// Of the denoiser, which goes over the picture in several stages. A submission ends when its dispatches have
// gone over `enoughPixels`, of all stages together.
struct FilterPortion {
    int rowsAtOnce = 0;  // of one dispatch
    std::int64_t enoughPixels = 0;
};
constexpr FilterPortion filterPortion(bool isCpu, bool isInterruptible, int width, int height) {
    // There a pixel of a stage takes up to 0.3 microseconds, a dispatch some 40 ms. Nobody takes a processor
    // for dead.
    if (isCpu && isInterruptible) return {std::max((1 << 17) / width / 8 * 8, 8), 1};
    if (isCpu) return {height, INT64_MAX};
    // A card is done with the stages of a small picture sooner than the host can wait for each by itself.
    constexpr int kPixels = 1 << 21;
    return {std::clamp(kPixels / width / 8 * 8, 8, height + 7), isInterruptible ? kPixels / 2 : kPixels};
}

}  // namespace macula::trace
