#include "dicom/pixels/decoders.h"

#include <algorithm>
#include <cstdint>

namespace macula::dicom {

namespace {

constexpr std::size_t kHeaderBytes = 64;

// PackBits, into every `stride`th byte of `target`. What comes after the last cell is padding.
bool unpackSegment(std::span<const std::byte> segment, std::size_t stride, std::span<std::byte> target) {
    std::size_t out = 0;
    std::size_t in = 0;
    while (out < target.size()) {
        if (in >= segment.size()) return false;
        const auto control = std::to_integer<unsigned>(segment[in++]);
        if (control == 128) continue;
        const bool repeats = control > 128;
        const std::size_t count = repeats ? 257 - control : control + 1;
        if (in + (repeats ? 1 : count) > segment.size()) return false;
        for (std::size_t i = 0; i < count && out < target.size(); ++i, out += stride)
            target[out] = segment[repeats ? in : in + i];
        in += repeats ? 1 : count;
    }
    return true;
}

}  // namespace

bool decodeRle(std::span<const std::byte> frame, std::size_t bytesPerCell, std::span<std::byte> cells) {
    if (frame.size() <= kHeaderBytes || cells.empty()) return false;
    const auto word = [&](std::size_t i) {
        std::uint32_t value = 0;
        for (std::size_t byte = 0; byte < 4; ++byte)
            value |= std::to_integer<std::uint32_t>(frame[4 * i + byte]) << (8 * byte);
        return value;
    };
    const std::size_t segments = word(0);
    if (segments != bytesPerCell && segments != 1) return false;
    if (segments < bytesPerCell) std::ranges::fill(cells, std::byte{0});
    for (std::size_t s = 0; s < segments; ++s) {
        const std::size_t begin = word(1 + s);
        const std::size_t end = s + 1 < segments ? word(2 + s) : frame.size();
        if (begin < kHeaderBytes || begin >= end || end > frame.size()) return false;
        const std::size_t byte = segments - 1 - s;  // the most significant comes first
        if (!unpackSegment(frame.subspan(begin, end - begin), bytesPerCell, cells.subspan(byte)))
            return false;
    }
    return true;
}

}  // namespace macula::dicom
