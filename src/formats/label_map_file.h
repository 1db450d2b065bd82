// Label maps in NIfTI, NRRD and MetaImage files: each voxel has the number of a segment, and 0 where there is
// none. In a .seg.nrrd file of 3D Slicer segments also have names and colours, and may overlap: these then
// lie in several layers.
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

#include "base/label_map.h"
#include "base/progress.h"
#include "base/result.h"
#include "base/text.h"
#include "base/voxel_set.h"

namespace macula::formats {

inline constexpr std::size_t kMostLabels = 1000;  // segments of a file

struct FileSegment {
    Segment segment;  // its number is from 1, and unique; that of the file where this is
    VoxelSet voxels;  // of the file's grid
};

struct LabelMapFile {
    glm::ivec3 size{0};
    glm::dmat4 worldFromVoxel{1.0};     // patient LPS mm
    std::vector<FileSegment> segments;  // by number, empty ones too; may overlap
    bool hasNames = false;              // else segments are called "Label 3"
    std::vector<Text> assumptions;      // sentences on where the file lies, as in Provenance
};

// Whether the name is that of a segmentation of 3D Slicer: .seg.nrrd or .seg.nhdr, in upper or lower case.
bool isSegmentationName(const std::filesystem::path& path);

// Errors: those of readVolumeFile; inputNotUsable for values that are no whole numbers from 0 to 65535, for
// more than kMostLabels segments, for none, and for several volumes that are no layers. Throws nothing.
Result<LabelMapFile> readLabelMapFile(const std::filesystem::path& path, Progress& progress);

}  // namespace macula::formats
