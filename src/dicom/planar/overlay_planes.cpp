#include "dicom/planar/overlay_planes.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "dicom/read/tags.h"

namespace macula::dicom {

namespace {

constexpr std::uint16_t kFirstGroup = 0x6000;
constexpr std::uint16_t kLastGroup = 0x601E;
constexpr int kFarthest = 65536;
constexpr int kMostFrames = 100'000;

std::vector<std::uint8_t> bytesOf(const std::vector<std::uint16_t>& words) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(2 * words.size());
    for (const std::uint16_t word : words) {
        bytes.push_back(static_cast<std::uint8_t>(word & 0xff));
        bytes.push_back(static_cast<std::uint8_t>(word >> 8));
    }
    return bytes;
}

// (row, column) in the file; SS, or a writer's IS.
glm::ivec2 originOf(const Dataset& header, Tag tag) {
    const std::vector<std::uint16_t> words = header.words(tag);
    if (words.size() == 2) return {static_cast<std::int16_t>(words[1]), static_cast<std::int16_t>(words[0])};
    const auto numbers = header.numbers(tag, 2);
    const auto isUsable = [](double value) { return value >= -kFarthest && value <= kFarthest; };
    if (!numbers || !isUsable((*numbers)[0]) || !isUsable((*numbers)[1])) return glm::ivec2(1);
    return {int((*numbers)[1]), int((*numbers)[0])};
}

std::optional<OverlayPlane> planeOf(const Dataset& header, std::uint16_t group) {
    OverlayPlane plane{.group = group};
    plane.layer = header.shortText({group, 0x1001});
    plane.rows = header.integer({group, 0x0010}).value_or(0);
    plane.columns = header.integer({group, 0x0011}).value_or(0);
    const bool hasSize =
        plane.rows >= 1 && plane.columns >= 1 && plane.rows <= kMostRows && plane.columns <= kMostRows;
    if (!hasSize) return plane.layer.empty() ? std::nullopt : std::optional(plane);
    plane.origin = originOf(header, {group, 0x0050});
    plane.isRegion = header.shortText({group, 0x0040}) == "R";
    plane.label = header.shortText({group, 0x1500});
    if (const auto frames = header.integer({group, 0x0015}); frames && *frames >= 1)
        plane.frames = std::min(*frames, kMostFrames);
    plane.firstFrame = std::max(1, header.integer({group, 0x0051}).value_or(1));
    const std::vector<std::uint16_t> words = header.words({group, 0x3000});
    if (!words.empty()) {
        const std::size_t bits =
            std::size_t(plane.rows) * std::size_t(plane.columns) * std::size_t(plane.frames.value_or(1));
        if (16 * words.size() < bits) return {};
        plane.packed = std::make_shared<const std::vector<std::uint8_t>>(bytesOf(words));
        return plane;
    }
    const int bit = header.integer({group, tag::kOverlayBitPositionElement}).value_or(0);
    const int allocated = header.integer({group, 0x0100}).value_or(1);
    const bool isEmbedded = (allocated == 8 || allocated == 16) && bit > 0 && bit < allocated;
    if (isEmbedded) plane.embeddedBit = bit;
    return isEmbedded || !plane.layer.empty() ? std::optional(plane) : std::nullopt;
}

}  // namespace

bool OverlayMask::marks(int column, int row) const {
    const int x = column - (origin.x - 1);
    const int y = row - (origin.y - 1);
    return x >= 0 && y >= 0 && x < columns && y < rows &&
           isOn[std::size_t(y) * std::size_t(columns) + std::size_t(x)];
}

std::vector<OverlayPlane> readOverlayPlanes(const Dataset& header) {
    std::vector<OverlayPlane> planes;
    for (std::uint16_t group = kFirstGroup; group <= kLastGroup; group += 2)
        if (auto plane = planeOf(header, group)) planes.push_back(*std::move(plane));
    return planes;
}

std::optional<OverlayMask> maskOf(const OverlayPlane& plane, int frame) {
    if (!plane.packed) return {};
    int own = 0;
    if (plane.frames) {
        own = frame + 1 - plane.firstFrame;
        if (own < 0 || own >= *plane.frames) return {};
    }
    const std::size_t count = std::size_t(plane.columns) * std::size_t(plane.rows);
    OverlayMask mask{plane.group, plane.columns, plane.rows, plane.origin, std::vector<bool>(count)};
    const std::size_t first = std::size_t(own) * count;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t bit = first + i;
        mask.isOn[i] = ((*plane.packed)[bit / 8] >> (bit % 8) & 1) != 0;
    }
    return mask;
}

OverlayMask embeddedMaskOf(const OverlayPlane& plane, int columns, std::span<const std::uint16_t> cells) {
    MACULA_CHECK(columns >= 1 && plane.embeddedBit > 0 && plane.embeddedBit < 16);
    const int rows = int(cells.size() / std::size_t(columns));
    OverlayMask mask{plane.group, columns, rows, plane.origin, std::vector<bool>(cells.size())};
    for (std::size_t i = 0; i < cells.size(); ++i)
        mask.isOn[i] = (cells[i] >> unsigned(plane.embeddedBit) & 1) != 0;
    return mask;
}

}  // namespace macula::dicom
