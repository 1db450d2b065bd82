// Writes segments as a Segmentation object (PS3.3 A.51), for the archive and other programs.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/label_map.h"
#include "base/result.h"
#include "base/voxel_set.h"
#include "dicom/segmentation/segment_codes.h"
#include "dicom/write/new_object.h"
#include "dicom/write/referenced_series.h"

namespace macula::dicom {

struct WrittenSegment {
    Segment segment;  // its number only orders it: in the file the first is 1, the next 2, and so on
    SegmentCodes codes = {};
    std::shared_ptr<const VoxelSet> voxels;  // in the grid; may be empty, and may overlap others
};

// A slice of the grid.
struct SegmentedSlice {
    glm::dvec3 positionMm{0.0};         // of its first voxel
    std::optional<ReferencedImage> of;  // the image that it was made of; nothing: it is interpolated
};

struct WrittenSegmentation {
    std::string label = "SEGMENTATION";  // at most 16 of A to Z, 0 to 9, blank and underscore
    // The series that it was drawn on, with the images of `slices`.
    PresentedSeries series;
    glm::dmat4 worldFromVoxel{1.0};
    glm::ivec3 size{0};
    std::vector<SegmentedSlice> slices;  // size.z of them
    std::vector<WrittenSegment> segments;
};

// BINARY, explicit VR little endian: a frame for each slice in which a segment has a voxel. Reading it gives
// the same voxels, labels, codes and colours; a segment without a label is "Segment n", one without codes is
// "Tissue", and one that does not say how it was made is SEMIAUTOMATIC. Longer labels are cut to 64
// characters. Texts and names are in the character set of the image, or in UTF-8 if a label needs it. If
// deidentified, the caller leaves out labels that a person typed. Each call makes a new series and instance.
// The file is written whole or not at all, in place of one that is there. Fails with usage for segments
// without any voxel, or with voxels beyond the grid, for a grid whose rows and columns are not perpendicular,
// for more than 4 GB of frames, images without UIDs, and a missing image unless deidentified; with
// inputNotUsable when the image cannot be read or is another one; with outputNotWritable.
Result<void> writeSegmentation(const std::filesystem::path& path, const WrittenSegmentation& segmentation,
                               const NewObject& object);

}  // namespace macula::dicom
