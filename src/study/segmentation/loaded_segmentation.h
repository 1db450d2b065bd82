// A segmentation on the grid of a volume.
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

namespace macula::study {

struct LoadedSegment {
    Segment segment;
    std::shared_ptr<const VoxelSet> voxels;  // in the grid of the volume; empty where it lies outside
    // Computed from the voxels as drawn. Nothing if there are none, or if the thickness of the only slice is
    // unknown.
    std::optional<double> volumeMl;
    std::optional<glm::dvec3> centroidMm;

    bool isInVolume() const { return voxels && !voxels->isEmpty(); }
};

struct LoadedSegmentation {
    std::string digest;
    std::vector<LoadedSegment> segments;  // by number
    std::vector<Text> notes;              // sentences on how it was loaded, without patient data
    bool isResampled = false;             // drawn on another grid: each voxel takes the nearest one
    bool hasFractions = false;            // fractional: a voxel belongs to a segment at one half or more

    const LoadedSegment* segment(std::uint16_t number) const;  // null when there is none
};

// Keeps the voxels of a segmentation on the grid of the volume; from another grid takes the nearest voxel,
// and a note says so. `stack` is that of the volume. Fails as dicom::loadSegmentVoxels.
Result<std::shared_ptr<const LoadedSegmentation>> loadSegments(const FoundSegmentation& found,
                                                               const Volume& volume,
                                                               const dicom::Stack& stack, Progress& progress);

// sRGB: the colour that the file recommends, otherwise one of seven of Okabe and Ito, by the segment's
// number.
std::array<std::uint8_t, 3> usualRgb(const Segment& segment);

}  // namespace macula::study
