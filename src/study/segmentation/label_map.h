// Label maps from files of research programs, as segmentations of an open volume.
#pragma once

#include <filesystem>
#include <memory>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "study/segmentation/found_segmentation.h"
#include "study/segmentation/loaded_segmentation.h"

namespace macula::study {

struct OpenedLabelMap {
    FoundSegmentation found;  // as if it were in the folder; its header has no DICOM file
    std::shared_ptr<const LoadedSegmentation> loaded;
};

// Reads the file (formats::readLabelMapFile) onto the voxels of the volume: as they are where all voxels of
// the file lie on those of the volume to 0.01 mm, in whatever order the file has them, otherwise by the
// nearest voxel, and a note says so. Such a file names no patient and no frame of reference: a note says what
// was taken for granted. Errors: those of the reader; inputNotUsable where no voxel of a segment lies in the
// volume. Throws nothing.
Result<OpenedLabelMap> openLabelMap(const std::filesystem::path& path, const Volume& volume,
                                    Progress& progress);

// Whether a file that is dropped on the volume may be a segmentation of it. Reads only the header.
enum class LabelMapGuess {
    no,     // another grid, or no volume file
    maybe,  // on the voxels of the volume
    yes,    // 3D Slicer calls it a segmentation
};
LabelMapGuess guessLabelMap(const std::filesystem::path& path, const Volume& volume);

}  // namespace macula::study
