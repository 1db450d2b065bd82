#include "scene/segments/segment_tints.h"

#include <algorithm>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include "base/check.h"

namespace macula::scene {

namespace {

struct Coloured {
    std::shared_ptr<const VoxelSet> voxels;
    SegmentTints::Colour colour;
};

std::vector<Coloured> colouredOf(std::span<const SegmentationSettings> choices,
                                 const LoadedSegmentations& loaded) {
    std::vector<Coloured> all;
    for (const auto& [digest, number, rgb, opacity] : colouredIn3dOf(choices)) {
        const auto found = std::ranges::find_if(
            loaded, [&, &digest = digest](const auto& each) { return each && each->digest == digest; });
        const study::LoadedSegment* segment = found == loaded.end() ? nullptr : (*found)->segment(number);
        if (segment == nullptr || !segment->isInVolume()) continue;
        const std::array<std::uint8_t, 3> own = rgb.value_or(study::usualRgb(segment->segment));
        all.push_back({segment->voxels,
                       {.rgb = glm::vec3(own[0], own[1], own[2]) / 255.0f,
                        .opacity = static_cast<float>(std::clamp(opacity, 0.0, 1.0))}});
    }
    return all;
}

TintBox boxAround(const std::vector<TintGeometry::Part>& parts, const Volume& volume) {
    TintBox box;
    box.volumeSize = volume.size();
    box.low = parts.front().voxels->low();
    glm::ivec3 high = parts.front().voxels->high();
    for (const TintGeometry::Part& each : parts) {
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

Result<PlannedTints> plannedTints(std::span<const SegmentationSettings> choices,
                                  const LoadedSegmentations& loaded) {
    std::vector<Coloured> segments = colouredOf(choices, loaded);
    const bool eachHasItsOwn = segments.size() <= SegmentTints::kMostColours;
    PlannedTints planned;
    for (Coloured& each : segments) {
        auto colour = eachHasItsOwn ? planned.colours.end() : std::ranges::find(planned.colours, each.colour);
        if (colour == planned.colours.end()) {
            if (planned.colours.size() == SegmentTints::kMostColours)
                return Error{ErrorCode::inputNotUsable,
                             Text("More than 255 segments of different colours cannot be shown in 3D."),
                             {},
                             Text("Colour fewer of them, or give some the same colour.")};
            planned.colours.push_back(each.colour);
            colour = planned.colours.end() - 1;
        }
        planned.geometry.parts.push_back(
            {std::move(each.voxels), static_cast<std::uint8_t>(colour - planned.colours.begin() + 1)});
    }
    return planned;
}

Result<std::shared_ptr<const TintBox>> tintBox(const TintGeometry& geometry, const Volume& volume,
                                               Progress& progress) try {
    MACULA_CHECK(!geometry.parts.empty());
    progress.beginStage(Text("Colouring segments"), geometry.parts.size());
    TintBox box = boxAround(geometry.parts, volume);
    for (const TintGeometry::Part& each : geometry.parts) {
        if (progress.cancelled())
            return Error{ErrorCode::cancelled, Text("Colouring segments was cancelled."), {}, {}};
        fill(box, *each.voxels, each.colour);
        progress.advance();
    }
    return std::make_shared<const TintBox>(std::move(box));
} catch (const std::bad_alloc&) {
    return Error{
        ErrorCode::outOfMemory,
        Text("There is not enough memory to colour segments."),
        {},
        Text("Close other programs, or colour fewer. The picture and what is chosen stay as before.")};
}

Result<std::optional<SegmentTints>> segmentTints(std::span<const SegmentationSettings> choices,
                                                 const LoadedSegmentations& loaded, const Volume& volume,
                                                 Progress& progress) {
    MACULA_TRY(PlannedTints planned, plannedTints(choices, loaded));
    if (planned.geometry.parts.empty()) return std::optional<SegmentTints>();
    SegmentTints tints;
    MACULA_TRY(tints.box, tintBox(planned.geometry, volume, progress));
    tints.colours = std::move(planned.colours);
    return std::optional<SegmentTints>(std::move(tints));
}

}  // namespace macula::scene
