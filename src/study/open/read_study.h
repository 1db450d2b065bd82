// Reads a study for a picture, with the folder for its segmentations.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "dicom/scan.h"
#include "study/open/found_volumes.h"
#include "study/open/loaded_study.h"

namespace macula::study {

// The study to read. Empty fields: not given.
struct StudyPlace {
    std::filesystem::path path;
    std::string series;                  // as loadStudy
    std::filesystem::path presentation;  // a presentation state, whose series is read if `series` is empty
    dicom::ScanOptions how;
};

// Whether `path` may have segmentations: a DICOM folder may; a volume file and the phantom have none.
bool mayHoldSegmentations(const std::filesystem::path& path);

struct ReadStudy {
    LoadedStudy input;
    std::string series;                         // for chooseVolume; may be empty
    std::shared_ptr<const FoundVolumes> found;  // the folder; null unless segmentations are needed
    dicom::ScanOptions how;
};

// Fails as loadStudy, and as readPresentationState.
Result<ReadStudy> readStudy(const StudyPlace& place, bool needsSegmentations, Progress& progress);

}  // namespace macula::study
