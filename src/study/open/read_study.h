// A study that is read for a picture, with what its segmentations need.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "dicom/scan.h"
#include "study/open/found_volumes.h"
#include "study/open/study_input.h"

namespace macula::app {

// Which study, as somebody asked for it. Empty: not given.
struct StudyPlace {
    std::filesystem::path path;
    std::string series;                  // as loadStudy
    std::filesystem::path presentation;  // of whose series it is, where no series is given
    dicom::ScanOptions how;
};

// Whether there may be segmentations: in a folder of DICOM files, and in no volume file or phantom.
bool mayHoldSegmentations(const std::filesystem::path& path);

struct ReadStudy {
    StudyInput input;
    std::string series;                         // that was meant, as chooseVolume takes it
    std::shared_ptr<const FoundVolumes> found;  // the folder; null where its segmentations are not needed
    dicom::ScanOptions how;
};

// Fails as loadStudy, and as readPresentationState.
Result<ReadStudy> readStudy(const StudyPlace& place, bool needsSegmentations, Progress& progress);

}  // namespace macula::app
