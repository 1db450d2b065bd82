// Radiotherapy structure sets (PS3.3 A.19): regions that are drawn as contours, plane by plane.
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "base/label_map.h"
#include "base/progress.h"
#include "base/result.h"
#include "dicom/segmentation/segment_voxels.h"

namespace macula::dicom {

// Closed and flat: the last point is joined to the first. Patient LPS.
using Contour = std::vector<glm::dvec3>;

// A region of interest. Names may name a patient: never logged.
struct StructureRegion {
    Segment segment;                  // its place in the file, from 1; name and colour
    std::string frameOfReferenceUid;  // may be empty
    std::vector<Contour> contours;    // those that enclose something
    std::size_t points = 0;           // contours that are points or open lines, and enclose nothing
    std::size_t unusable = 0;         // contours that cannot be read
};

struct StructureSet {
    std::string sopInstanceUid;
    std::string label;
    std::vector<std::string> referencedSeriesUids;
    std::vector<StructureRegion> regions;  // in their order in the file
    // Regions without a number of their own, or beyond what a segmentation can hold, and contours of regions
    // that are not there.
    std::size_t lost = 0;
};

// Fails with inputNotUsable when the file is no structure set, or cannot be read.
Result<StructureSet> readStructureSet(const std::filesystem::path& file);

struct RegionVoxels {
    SegmentVoxelSets sets;
    std::size_t oblique = 0;  // contours that are not parallel to the slices, and are left out
    bool isUneven = false;    // planes of a region lie at different distances: the median counts for all
    bool isBetween = false;   // planes lie farther apart than slices: those between show the nearest
};

// A voxel belongs to a region if an odd number of the contours of its plane are around its centre: this makes
// holes of contours inside others, and of keyholes. A slice takes the nearest plane within half the distance
// of slices, or of planes where these lie farther apart. Volumes come from the areas of the contours times
// the distance of their planes, in patient space; nothing where a region has one plane only and the grid one
// slice. `slicePositionsMm` as in loadSegmentation. Fails with cancelled or outOfMemory.
Result<RegionVoxels> voxelsOf(const StructureSet& structures, const glm::dmat4& worldFromVoxel,
                              glm::ivec3 size, Progress& progress,
                              std::span<const glm::dvec3> slicePositionsMm = {});

}  // namespace macula::dicom
