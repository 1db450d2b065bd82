#include "study/segmentation/loaded_segmentation.h"

#include <algorithm>
#include <array>
#include <utility>

#include "dicom/messages/messages.h"
#include "dicom/segmentation/segment_voxels.h"

namespace macula::study {

namespace {

constexpr double kMm3PerMl = 1000.0;

// The palette of Okabe and Ito, safe for colour blindness; without black.
constexpr std::array<std::array<std::uint8_t, 3>, 7> kColours{{{230, 159, 0},
                                                               {86, 180, 233},
                                                               {0, 158, 115},
                                                               {240, 228, 66},
                                                               {0, 114, 178},
                                                               {213, 94, 0},
                                                               {204, 121, 167}}};

std::vector<Text> notesOf(const FoundSegmentation& found, const dicom::SegmentVoxelSets& sets) {
    std::vector<Text> notes;
    if (!found.note.empty()) notes.push_back(found.note);
    if (sets.isResampled)
        notes.push_back(
            Text("It was drawn on other voxels than those of this volume; the nearest voxel is shown."));
    if (found.header.type == dicom::SegmentationType::fractional)
        notes.push_back(Text("It has fractions; what is half or more is shown as the segment."));
    for (const std::uint16_t number : found.header.paddedSegments)
        notes.push_back(
            dicom::message(dicom::key::kSegmentIsPadding, {{"number", std::int64_t(number)}}).sentence);
    if (sets.outside > 0)
        notes.push_back(
            Text("{} of its voxels lie outside of this volume, and are not counted.", sets.outside));
    const bool isSeen = std::ranges::any_of(
        sets.segments, [](const dicom::SegmentVoxels& each) { return !each.voxels.isEmpty(); });
    if (!isSeen) notes.push_back(Text("No voxel of it lies in this volume."));
    return notes;
}

}  // namespace

const LoadedSegment* LoadedSegmentation::segment(std::uint16_t number) const {
    const auto found =
        std::ranges::find_if(segments, [&](const LoadedSegment& s) { return s.segment.number == number; });
    return found == segments.end() ? nullptr : &*found;
}

namespace {

struct RegionsHere {
    dicom::StructureSet structures;  // regions of other coordinate systems have no contours
    std::size_t elsewhere = 0;       // such regions
};

RegionsHere regionsHere(const dicom::StructureSet& structures, const std::string& frameOfReference) {
    RegionsHere here{structures, 0};
    for (dicom::StructureRegion& region : here.structures.regions) {
        const bool isElsewhere = !frameOfReference.empty() && !region.frameOfReferenceUid.empty() &&
                                 region.frameOfReferenceUid != frameOfReference;
        if (!isElsewhere || region.contours.empty()) continue;
        region.contours.clear();
        ++here.elsewhere;
    }
    return here;
}

std::vector<Text> notesOf(const FoundSegmentation& found, const dicom::RegionVoxels& regions,
                          std::size_t elsewhere) {
    std::vector<Text> notes;
    if (!found.note.empty()) notes.push_back(found.note);
    notes.push_back(
        Text("It is drawn as contours: volumes come from their areas, voxels from what they enclose."));
    if (regions.isBetween)
        notes.push_back(
            Text("Some contours lie farther apart than slices; slices between them show the nearest."));
    if (regions.isUneven)
        notes.push_back(Text(
            "Contours of some regions lie at uneven distances; their volumes take each for the usual one."));
    if (elsewhere > 0)
        notes.push_back(Text("{} regions lie in another coordinate system, and are not shown.", elsewhere));
    if (found.structures->lost > 0)
        notes.push_back(
            Text("{} regions have no number of their own, and are left out.", found.structures->lost));
    if (regions.oblique > 0)
        notes.push_back(
            Text("{} contours are not parallel to the slices, and are left out.", regions.oblique));
    std::size_t points = 0;
    std::size_t unusable = 0;
    for (const dicom::StructureRegion& region : found.structures->regions) {
        points += region.points;
        unusable += region.unusable;
    }
    if (points > 0)
        notes.push_back(Text("{} points and open lines enclose nothing, and are left out.", points));
    if (unusable > 0)
        notes.push_back(
            Text("{} contours cannot be read, or are too long: regions may lack parts.", unusable));
    const bool isSeen = std::ranges::any_of(
        regions.sets.segments, [](const dicom::SegmentVoxels& each) { return !each.voxels.isEmpty(); });
    if (!isSeen) notes.push_back(Text("No voxel of it lies in this volume."));
    return notes;
}

std::vector<LoadedSegment> segmentsOf(dicom::SegmentVoxelSets sets) {
    std::vector<LoadedSegment> segments;
    for (dicom::SegmentVoxels& each : sets.segments) {
        LoadedSegment segment;
        segment.segment = std::move(each.segment);
        segment.voxels = std::make_shared<const VoxelSet>(std::move(each.voxels));
        if (each.volumeMm3) segment.volumeMl = *each.volumeMm3 / kMm3PerMl;
        segment.centroidMm = each.centroidMm;
        segments.push_back(std::move(segment));
    }
    return segments;
}

}  // namespace

Result<std::shared_ptr<const LoadedSegmentation>> loadSegments(const FoundSegmentation& found,
                                                               const Volume& volume,
                                                               const dicom::Stack& stack,
                                                               Progress& progress) {
    const std::vector<glm::dvec3> positionsMm =
        stack.worldFromVoxel ? dicom::slicePositionsMm(stack) : std::vector<glm::dvec3>();
    auto loaded = std::make_shared<LoadedSegmentation>();
    loaded->digest = found.digest;
    if (found.structures) {
        const RegionsHere here = regionsHere(*found.structures, frameOfReferenceOf(stack));
        MACULA_TRY(dicom::RegionVoxels regions, dicom::voxelsOf(here.structures, volume.worldFromVoxel(),
                                                                volume.size(), progress, positionsMm));
        loaded->notes = notesOf(found, regions, here.elsewhere);
        loaded->segments = segmentsOf(std::move(regions.sets));
        return std::shared_ptr<const LoadedSegmentation>(std::move(loaded));
    }
    MACULA_TRY(dicom::SegmentVoxelSets sets, dicom::loadSegmentVoxels(found.header, volume.worldFromVoxel(),
                                                                      volume.size(), progress, positionsMm));
    loaded->notes = notesOf(found, sets);
    loaded->isResampled = sets.isResampled;
    loaded->hasFractions = found.header.type == dicom::SegmentationType::fractional;
    loaded->segments = segmentsOf(std::move(sets));
    return std::shared_ptr<const LoadedSegmentation>(std::move(loaded));
}

std::array<std::uint8_t, 3> usualRgb(const Segment& segment) {
    if (segment.recommendedRgb) return *segment.recommendedRgb;
    return kColours.at((std::size_t(segment.number) + kColours.size() - 1) % kColours.size());
}

}  // namespace macula::study
