#include "app/segmentation/segment_tints.h"

#include <algorithm>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace macula::app {

namespace {

struct Coloured {
    const VoxelSet* voxels;
    SegmentTints::Colour colour;
};

std::vector<Coloured> colouredOf(std::span<const SegmentationChoice> choices,
                                 const LoadedSegmentations& loaded) {
    std::vector<Coloured> all;
    for (const auto& [digest, number, rgb, opacity] : colouredIn3dOf(choices)) {
        const auto found = std::ranges::find_if(
            loaded, [&, &digest = digest](const auto& each) { return each && each->digest == digest; });
        const LoadedSegment* segment = found == loaded.end() ? nullptr : (*found)->segment(number);
        if (segment == nullptr || !segment->isInVolume()) continue;
        const std::array<std::uint8_t, 3> own = rgb.value_or(usualRgb(segment->segment));
        all.push_back({segment->voxels.get(),
                       {.rgb = glm::vec3(own[0], own[1], own[2]) / 255.0f,
                        .opacity = static_cast<float>(std::clamp(opacity, 0.0, 1.0))}});
    }
    return all;
}

TintBox boxAround(const std::vector<Coloured>& segments, const Volume& volume) {
    TintBox box;
    box.volumeSize = volume.size();
    box.low = segments.front().voxels->low();
    glm::ivec3 high = segments.front().voxels->high();
    for (const Coloured& each : segments) {
        box.low = glm::min(box.low, each.voxels->low());
        high = glm::max(high, each.voxels->high());
    }
    box.low = glm::max(box.low, glm::ivec3(0));
    box.size = glm::min(high, volume.size() - 1) - box.low + 1;
    const glm::dvec3 size(box.size);
    if (size.x * size.y * size.z > double(std::size_t(1) << 31) - 1.0) throw std::bad_alloc();
    box.voxels.resize(std::size_t(box.size.x) * std::size_t(box.size.y) * std::size_t(box.size.z), 0);
    return box;
}

void fill(TintBox& box, const VoxelSet& voxels, std::uint8_t colour) {
    voxels.forEach([&](const glm::ivec3& voxel) {
        const glm::ivec3 at = voxel - box.low;
        box.voxels[(std::size_t(at.z) * std::size_t(box.size.y) + std::size_t(at.y)) *
                       std::size_t(box.size.x) +
                   std::size_t(at.x)] = colour;
    });
}

}  // namespace

Result<std::optional<SegmentTints>> segmentTints(std::span<const SegmentationChoice> choices,
                                                 const LoadedSegmentations& loaded, const Volume& volume,
                                                 Progress& progress) try {
    const std::vector<Coloured> segments = colouredOf(choices, loaded);
    if (segments.empty()) return std::optional<SegmentTints>();
    progress.beginStage("Colouring segments", segments.size());
    SegmentTints tints;
    TintBox box = boxAround(segments, volume);
    for (const Coloured& each : segments) {
        if (progress.cancelled())
            return Error{ErrorCode::cancelled, "Colouring segments was cancelled.", {}, {}};
        auto known = std::ranges::find(tints.colours, each.colour);
        if (known == tints.colours.end()) {
            if (tints.colours.size() == SegmentTints::kMostColours)
                return Error{ErrorCode::inputNotUsable,
                             "More than 255 segments of different colours cannot be shown in 3D.",
                             {},
                             "Colour fewer of them, or give some the same colour."};
            tints.colours.push_back(each.colour);
            known = tints.colours.end() - 1;
        }
        fill(box, *each.voxels, static_cast<std::uint8_t>(known - tints.colours.begin() + 1));
        progress.advance();
    }
    tints.box = std::make_shared<const TintBox>(std::move(box));
    return std::optional<SegmentTints>(std::move(tints));
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory,
                 "There is not enough memory to colour segments.",
                 {},
                 "Close other programs, or colour fewer. The picture and what is chosen stay as before."};
}

}  // namespace macula::app
