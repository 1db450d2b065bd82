#include "scene/segments/own_segments.h"

#include <algorithm>
#include <new>
#include <random>
#include <utility>

#include "base/label_sets.h"
#include "base/sha256.h"
#include "segment/voxel_sets.h"

namespace macula::scene {

namespace {

std::string digestByChance() {
    std::random_device device;
    std::string bytes;
    for (int n = 0; n < 8; ++n) bytes += std::to_string(device()) + " ";
    return sha256Hex(bytes);
}

study::LoadedSegment counted(OwnSegment own, const Volume& volume) {
    study::LoadedSegment loaded{
        .segment = std::move(own.segment), .voxels = std::move(own.voxels), .volumeMl = {}, .centroidMm = {}};
    glm::dvec3 sum(0.0);
    std::size_t count = 0;
    loaded.voxels->forEach([&](const glm::ivec3& voxel) {
        sum += glm::dvec3(voxel);
        ++count;
    });
    if (count == 0) return loaded;
    loaded.volumeMl = double(count) * segment::voxelMl(volume.worldFromVoxel());
    loaded.centroidMm = transformPoint(volume.worldFromVoxel(), sum / double(count));
    return loaded;
}

Error notALabelMap(Text message) {
    return {ErrorCode::inputNotUsable,
            std::move(message),
            {},
            Text("The program has to write the number of a segment into each voxel of the volume it got.")};
}

bool isSameGrid(const Volume& a, const Volume& b) {
    if (a.size() != b.size()) return false;
    constexpr double kMostVoxels = 0.01;
    const glm::dvec3 spacing = b.spacingMm();
    const double mostMm = kMostVoxels * std::min({spacing.x, spacing.y, spacing.z});
    for (const glm::dvec3& corner : cornersOf({glm::dvec3(0.0), glm::dvec3(a.size() - 1)})) {
        const double offMm = glm::distance(transformPoint(a.worldFromVoxel(), corner),
                                           transformPoint(b.worldFromVoxel(), corner));
        if (!(offMm <= mostMm)) return false;
    }
    return true;
}

}  // namespace

std::shared_ptr<const study::LoadedSegmentation> ownRevision(std::vector<OwnSegment> segments,
                                                             const Volume& volume, std::string digest) {
    auto revision = std::make_shared<study::LoadedSegmentation>();
    revision->digest = digest.empty() ? digestByChance() : std::move(digest);
    std::ranges::sort(segments, {}, [](const OwnSegment& each) { return each.segment.number; });
    for (OwnSegment& each : segments) revision->segments.push_back(counted(std::move(each), volume));
    return revision;
}

std::vector<OwnSegment> segmentsOf(const study::LoadedSegmentation& revision) {
    std::vector<OwnSegment> segments;
    for (const study::LoadedSegment& each : revision.segments)
        segments.push_back({each.segment, each.voxels});
    return segments;
}

study::FoundSegmentation foundOwn(const study::LoadedSegmentation& revision, std::string title) {
    study::FoundSegmentation found;
    found.digest = revision.digest;
    found.title = std::move(title);
    found.isOwn = true;
    for (const study::LoadedSegment& each : revision.segments) found.header.segments.push_back(each.segment);
    return found;
}

void chooseRevision(std::vector<SegmentationSettings>& choices, const std::string& before,
                    const study::LoadedSegmentation& next) {
    SegmentationSettings choice = choiceOf(choices, before);
    std::erase_if(choices, [&](const SegmentationSettings& each) { return each.digest == before; });
    choice.digest = next.digest;
    choice.isShown = true;
    std::erase_if(choice.segments,
                  [&](const SegmentSettings& each) { return next.segment(each.number) == nullptr; });
    for (const study::LoadedSegment& each : next.segments) {
        SegmentSettings one = choiceOf(choice, each.segment.number);
        if (!one.rgb) one.rgb = study::usualRgb(each.segment);
        std::erase_if(choice.segments,
                      [&](const SegmentSettings& other) { return other.number == one.number; });
        choice.segments.push_back(one);
    }
    choose(choices, std::move(choice));
}

Result<FlatSegments> flattened(std::span<const OwnSegment> segments, const Volume& volume) {
    const glm::ivec3 size = volume.size();
    MACULA_TRY_VOID(segment::checkMemory(double(volume.voxelCount()), 2.0));
    std::vector<std::uint16_t> numbers(volume.voxelCount());
    std::vector<Segment> described;
    std::size_t overlapping = 0;
    for (const OwnSegment& each : segments) {
        described.push_back(each.segment);
        each.voxels->forEach([&](const glm::ivec3& v) {
            std::uint16_t& number =
                numbers[(std::size_t(v.z) * std::size_t(size.y) + std::size_t(v.y)) * std::size_t(size.x) +
                        std::size_t(v.x)];
            if (number != 0) ++overlapping;
            number = each.segment.number;
        });
    }
    MACULA_TRY(LabelMap map,
               LabelMap::create(size, volume.worldFromVoxel(), std::move(described), std::move(numbers)));
    return FlatSegments{std::move(map), overlapping};
}

Result<std::vector<OwnSegment>> segmentsOfLabels(const Volume& labels, const Volume& volume) try {
    if (!isSameGrid(labels, volume))
        return notALabelMap(Text("The result has other voxels than the volume, or lies elsewhere."));
    auto sets = labelSets(labels, kMostOwnSegments);
    if (!sets && sets.error().code == ErrorCode::inputNotUsable)
        return notALabelMap(std::move(sets.error().message));
    if (!sets) return sets.error();
    if (sets->empty()) return notALabelMap(Text("The result has no segment: all of its voxels are 0."));
    std::vector<OwnSegment> segments;
    for (auto& [number, set] : *sets) {
        OwnSegment own;
        own.segment.number = number;
        own.segment.label = "Label " + std::to_string(number);
        own.voxels = std::make_shared<const VoxelSet>(std::move(set));
        segments.push_back(std::move(own));
    }
    return segments;
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory,
                 Text("There is not enough memory for the segments of this result."),
                 {},
                 Text("Close other programs.")};
}

}  // namespace macula::scene
