#include "dicom/pixels/frame_index.h"

#include <algorithm>
#include <array>

namespace macula::dicom {

namespace {

constexpr std::uint64_t kItemHeaderBytes = 8;
constexpr std::size_t kMostFragments = std::size_t{1} << 22;

std::uint32_t doubleWord(std::span<const std::byte> b) {
    return std::to_integer<std::uint32_t>(b[0]) | std::to_integer<std::uint32_t>(b[1]) << 8 |
           std::to_integer<std::uint32_t>(b[2]) << 16 | std::to_integer<std::uint32_t>(b[3]) << 24;
}

struct Items {
    std::vector<std::uint64_t> offsetTable;
    std::vector<Extent> fragments;
    bool whole = false;       // the items reach the sequence delimiter
    bool endsInside = false;  // the file ends inside an item

    // The offset of a fragment's item from the first item, as offset tables have it.
    std::uint64_t start(std::size_t i) const { return fragments[i].offset - fragments[0].offset; }
    // The offset at which the item after the last one would begin.
    std::uint64_t end() const {
        return start(fragments.size() - 1) + fragments.back().bytes + kItemHeaderBytes;
    }
};

Items readItems(const RandomFile& file, std::uint64_t at, std::size_t frames) {
    Items items;
    for (bool first = true; items.fragments.size() < kMostFragments; first = false) {
        std::array<std::byte, kItemHeaderBytes> header;
        if (!file.read(at, header)) {
            items.endsInside = at < file.size();
            return items;
        }
        const std::uint32_t tag = doubleWord(header);
        const std::uint32_t bytes = doubleWord(std::span(header).subspan(4));
        at += kItemHeaderBytes;
        items.whole = tag == 0xE0DDFFFE;
        if (items.whole || tag != 0xE000FFFE) return items;
        if (bytes > file.size() - at) {
            items.endsInside = true;
            return items;
        }
        if (!first) {
            items.fragments.push_back({at, bytes});
        } else if (bytes / 4 == frames && bytes % 4 == 0) {
            std::vector<std::byte> table(bytes);
            if (!file.read(at, table)) return items;
            for (std::size_t i = 0; i < table.size(); i += 4) {
                items.offsetTable.push_back(doubleWord(std::span(table).subspan(i, 4)));
            }
        }
        at += bytes;
    }
    return items;
}

// The index by a table of offsets; nothing if an offset is not that of a fragment. Only the whole frames if
// the file is cut off.
std::optional<FrameIndex> byOffsets(const Items& items, std::span<const std::uint64_t> offsets) {
    FrameIndex index;
    if (items.fragments.empty()) return index;
    if (offsets[0] != 0) return {};
    std::size_t fragment = 0;
    for (std::size_t frame = 0; frame < offsets.size(); ++frame) {
        const std::size_t first = fragment;
        const bool last = frame + 1 == offsets.size();
        if (last) {
            fragment = items.fragments.size();
            if (items.endsInside) return index;
        } else {
            if (offsets[frame + 1] <= offsets[frame]) return {};
            while (fragment < items.fragments.size() && items.start(fragment) < offsets[frame + 1])
                ++fragment;
            if (fragment == items.fragments.size() && items.end() != offsets[frame + 1]) {
                if (items.whole) return {};
                return index;  // cut off inside this frame
            }
            if (fragment < items.fragments.size() && items.start(fragment) != offsets[frame + 1]) return {};
        }
        if (first == fragment) return index;
        index.addFrame(std::span(items.fragments).subspan(first, fragment - first));
    }
    return index;
}

FrameIndex oneEach(const Items& items, std::size_t frames) {
    FrameIndex index;
    for (std::size_t i = 0; i < std::min(items.fragments.size(), frames); ++i)
        index.addFrame(std::span(items.fragments).subspan(i, 1));
    return index;
}

bool beginsStream(std::span<const std::byte> bytes) {
    return dicom::beginsStream({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
}

bool fragmentBeginsStream(const RandomFile& file, const Extent& fragment) {
    std::array<std::byte, 8> head;
    const auto bytes = std::span(head).first(std::min<std::uint64_t>(fragment.bytes, head.size()));
    return file.read(fragment.offset, bytes) && beginsStream(bytes);
}

// Whether a fragment ends with the end marker of JPEG, JPEG-LS and JPEG 2000 streams, and at most one byte of
// padding.
bool fragmentEndsStream(const RandomFile& file, const Extent& fragment) {
    std::array<std::byte, 3> tail{};
    if (fragment.bytes < tail.size() || !file.read(fragment.offset + fragment.bytes - tail.size(), tail))
        return false;
    const auto endsAt = [&](std::size_t i) {
        return tail[i] == std::byte{0xFF} && tail[i + 1] == std::byte{0xD9};
    };
    return endsAt(1) || endsAt(0);
}

// The fragments that begin a stream, by a marker; if `afterEndsOnly`, only those after the end of another
// stream.
std::vector<std::size_t> startsOf(const RandomFile& file, const Items& items, bool afterEndsOnly) {
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < items.fragments.size(); ++i) {
        if (!fragmentBeginsStream(file, items.fragments[i])) continue;
        if (i > 0 && afterEndsOnly && !fragmentEndsStream(file, items.fragments[i - 1])) continue;
        starts.push_back(i);
    }
    return starts;
}

// The index of frames of several fragments each, by the markers of their streams. Streams beyond `frames` are
// ignored; if there are fewer, the last frames are missing.
std::optional<FrameIndex> byMarkers(const RandomFile& file, const Items& items, std::size_t frames) {
    std::vector<std::size_t> starts = startsOf(file, items, true);
    if (starts.size() != frames) {
        if (auto all = startsOf(file, items, false); all.size() == frames) starts = std::move(all);
    }
    if (starts.empty() || starts[0] != 0) return {};
    const std::size_t there = starts.size();
    starts.push_back(items.fragments.size());
    FrameIndex index;
    for (std::size_t i = 0; i < std::min(there, frames); ++i) {
        // The file may end inside the last one.
        if (i + 1 == there && !items.whole && !fragmentEndsStream(file, items.fragments.back())) break;
        index.addFrame(std::span(items.fragments).subspan(starts[i], starts[i + 1] - starts[i]));
    }
    return index;
}

// The index of several frames in one fragment: cuts wherever one stream ends and another one begins. These
// markers cannot occur inside a stream.
std::optional<FrameIndex> insideOfOne(const RandomFile& file, const Extent& fragment, std::size_t frames) {
    if (!fragmentBeginsStream(file, fragment)) return {};
    constexpr std::size_t kStep = 1 << 16;
    constexpr std::size_t kOverlap = 16;
    std::vector<std::byte> buffer(kStep + kOverlap);
    std::vector<std::uint64_t> starts{0};
    for (std::uint64_t at = 0; at < fragment.bytes; at += kStep) {
        const auto bytes =
            std::span(buffer).first(std::min<std::uint64_t>(buffer.size(), fragment.bytes - at));
        if (!file.read(fragment.offset + at, bytes)) return {};
        for (std::size_t i = 0; i < std::min(bytes.size(), kStep); ++i) {
            if (bytes[i] != std::byte{0xFF} || i + 2 >= bytes.size() || bytes[i + 1] != std::byte{0xD9})
                continue;
            const std::size_t end = i + 2;  // and at most one byte of padding, which may be 0 or FF
            const std::size_t next = beginsStream(bytes.subspan(end)) ? end : end + 1;
            if (next > bytes.size() || !beginsStream(bytes.subspan(next))) continue;
            if (starts.size() == frames) return {};
            starts.push_back(at + next);
        }
    }
    if (starts.size() != frames) return {};
    FrameIndex index;
    for (std::size_t i = 0; i < frames; ++i) {
        const std::uint64_t end = i + 1 < frames ? starts[i + 1] : fragment.bytes;
        index.addFrame(std::array{Extent{fragment.offset + starts[i], end - starts[i]}});
    }
    return index;
}

}  // namespace

std::optional<FrameIndex> indexFrames(const RandomFile& file, std::uint64_t firstItem, std::size_t frames,
                                      Codec codec, std::span<const std::uint64_t> extendedOffsets) {
    const Items items = readItems(file, firstItem, frames);
    const std::size_t count = items.fragments.size();
    if (count == 0 || frames == 0) return FrameIndex{};
    const bool hasMarkers = codec == Codec::jpeg || codec == Codec::jpegLs || codec == Codec::jpeg2000;
    if (frames == 1) {
        if (hasMarkers && count > 1 && items.whole) {
            if (auto index = byMarkers(file, items, 1)) return index;
        }
        FrameIndex index;
        if (!items.endsInside) index.addFrame(items.fragments);
        return index;
    }
    if (items.whole && count == frames) return oneEach(items, frames);
    if (extendedOffsets.size() == frames) {
        if (auto index = byOffsets(items, extendedOffsets)) return index;
    }
    if (items.offsetTable.size() == frames) {
        if (auto index = byOffsets(items, items.offsetTable)) return index;
    }
    if (hasMarkers) {
        if (count == 1 && items.whole) return insideOfOne(file, items.fragments[0], frames);
        return byMarkers(file, items, frames);
    }
    // Run lengths, or no compression: each frame is always one fragment (PS3.5 A.4.2).
    const bool isOneEach = count <= frames || startsOf(file, items, false).size() == count;
    return isOneEach ? std::optional(oneEach(items, frames)) : std::nullopt;
}

}  // namespace macula::dicom
