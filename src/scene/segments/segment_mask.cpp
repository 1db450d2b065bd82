#include "scene/segments/segment_mask.h"

#include <algorithm>
#include <new>
#include <utility>

#include "pipeline/volume/mask_bits.h"

namespace macula::scene {

namespace {

struct Wanted {
    std::vector<const VoxelSet*> alone;
    std::vector<const VoxelSet*> hidden;
};

Wanted wantedOf(std::span<const SegmentationSettings> choices, const LoadedSegmentations& loaded) {
    Wanted wanted;
    for (const auto& [digest, number, in3d] : in3dOf(choices)) {
        const auto found = std::ranges::find_if(
            loaded, [&, &digest = digest](const auto& each) { return each && each->digest == digest; });
        if (found == loaded.end()) continue;
        const study::LoadedSegment* segment = (*found)->segment(number);
        if (segment == nullptr || !segment->isInVolume()) continue;
        (in3d == In3d::alone ? wanted.alone : wanted.hidden).push_back(segment->voxels.get());
    }
    return wanted;
}

void set(MaskBits& bits, const VoxelSet& voxels, bool isShown) {
    const auto row = std::size_t(bits.size.x);
    const auto slice = row * std::size_t(bits.size.y);
    voxels.forEach([&](const glm::ivec3& voxel) {
        const std::size_t n =
            std::size_t(voxel.z) * slice + std::size_t(voxel.y) * row + std::size_t(voxel.x);
        const std::uint32_t bit = 1u << (n % 32);
        if (isShown) {
            bits.words[n / 32] |= bit;
        } else {
            bits.words[n / 32] &= ~bit;
        }
    });
}

}  // namespace

Result<std::optional<Mask>> segmentMask(std::span<const SegmentationSettings> choices,
                                        const LoadedSegmentations& loaded, const Volume& volume,
                                        Progress& progress) try {
    const Wanted wanted = wantedOf(choices, loaded);
    if (wanted.alone.empty() && wanted.hidden.empty()) return std::optional<Mask>();
    progress.beginStage(Text("Hiding segments"), wanted.alone.size() + wanted.hidden.size());
    const glm::ivec3 size = volume.size();
    MaskBits bits{size, {}};
    bits.words.resize((volume.voxelCount() + 31) / 32, wanted.alone.empty() ? ~std::uint32_t{0} : 0u);
    const auto apply = [&](const std::vector<const VoxelSet*>& segments, bool isShown) {
        for (const VoxelSet* voxels : segments) {
            if (progress.cancelled()) return false;
            set(bits, *voxels, isShown);
            progress.advance();
        }
        return true;
    };
    if (!apply(wanted.alone, true) || !apply(wanted.hidden, false))
        return Error{ErrorCode::cancelled, Text("Hiding segments was cancelled."), {}, {}};
    Mask mask;
    mask.bits = std::make_shared<const MaskBits>(std::move(bits));
    const auto remark = [](std::size_t count, const Text& one, const Text& many) {
        return count == 0 ? Text() : count == 1 ? one : many;
    };
    mask.remark = Text::joined(
        {remark(wanted.alone.size(), Text("one segment alone"), Text("some segments alone")),
         remark(wanted.hidden.size(), Text("a segment left out"), Text("some segments left out"))},
        ", ");
    return std::optional<Mask>(std::move(mask));
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory,
                 Text("There is not enough memory to hide segments."),
                 {},
                 Text("Close other programs, or hide fewer. The picture and what is chosen stay as before.")};
}

}  // namespace macula::scene
