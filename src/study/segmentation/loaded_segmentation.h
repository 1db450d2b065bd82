// A segmentation on the voxels of a volume.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "base/voxel_set.h"
#include "study/segmentation/found_segmentation.h"

namespace macula::app {

struct LoadedSegment {
    Segment segment;
    std::shared_ptr<const VoxelSet> voxels;  // of the volume; none where it lies outside
    // Voxels that it was drawn on, times the volume of one; nothing where it has none, or where nobody knows.
    std::optional<double> volumeMl;
    std::optional<glm::dvec3> centroidMm;

    bool isInVolume() const { return voxels && !voxels->isEmpty(); }
};

struct LoadedSegmentation {
    std::string digest;
    std::vector<LoadedSegment> segments;  // by number
    std::vector<std::string> notes;       // sentences on what was done to it, without patient data
    bool isResampled = false;             // drawn on other voxels: the nearest of them counts
    bool hasFractions = false;            // what is half or more counts

    const LoadedSegment* segment(std::uint16_t number) const;  // null when there is none
};

// On the voxels of the volume where it was drawn on these; else the nearest voxel counts, and a note says so.
// `stack` is that of the volume. Fails as dicom::loadSegmentVoxels.
Result<std::shared_ptr<const LoadedSegmentation>> loadSegments(const FoundSegmentation& found,
                                                               const Volume& volume,
                                                               const dicom::Stack& stack, Progress& progress);

// sRGB: what the file recommends, else one of a row of colours that are told apart.
std::array<std::uint8_t, 3> usualRgb(const Segment& segment);

}  // namespace macula::app
