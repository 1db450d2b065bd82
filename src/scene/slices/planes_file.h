// Planes through a volume as a series of DICOM images.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "scene/slices/plane_batch.h"
#include "study/open/found_volumes.h"

namespace macula::scene {

struct PlaneBatchRequest {
    PlaneBatch batch;
    std::shared_ptr<const Volume> volume;              // with its values as they are measured
    std::shared_ptr<const study::FoundVolumes> found;  // null: the volume is of no DICOM images
    std::size_t volumeIndex = 0;                       // among them
    std::optional<DisplayWindow> window;
    bool isDeidentified = false;
};

struct WrittenPlanes {
    std::vector<std::filesystem::path> files;
    std::vector<Text> notes;  // sentences on what a reader of the series has to know
};

// Writes one Secondary Capture image for each plane into `folder`, which must be missing or empty: all of
// them or none. Pixels have the side mmPerPixelOf; values are rounded to the steps of the stored ones, or to
// a 65534th of their range. The images have the frame of reference of the volume, and refer to those that
// they were made of. Errors: those of framesOf and dicom::writePlaneImage; usage for a volume of no DICOM
// images unless deidentified, and for planes that all miss the volume; cancelled. Throws nothing.
Result<WrittenPlanes> writePlanes(const std::filesystem::path& folder, const PlaneBatchRequest& request,
                                  Progress& progress);

}  // namespace macula::scene
