// A presentation state of a study that is open, as a file.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "dicom/presentation/volume_presentation.h"
#include "dicom/stack/series.h"
#include "scene/state/study_state.h"

namespace macula::app {

// Nothing of the patient is in it but UIDs of images, where they lie and what class they are.
struct PresentedImages {
    dicom::PresentedSeries series;
    std::filesystem::path middleFile;  // patient and study are taken from it
    std::string middleSopInstanceUid;
    std::optional<double> suvFactor = {};  // dicom::Stack::suvFactor: the object has values of the images
};

// Of the stack that is shown. usage when it has no images, no frame of reference or no UID.
Result<PresentedImages> presentedImages(const dicom::Series& series, const dicom::Stack& stack);

struct PresentationWish {
    StudyState state;                      // with preset and camera
    std::shared_ptr<const Volume> volume;  // any format
    PresentedImages images;
    double aspectWidthOverHeight = 1.0;
    bool isDeidentified = false;
};

// Sentences: what other programs will show otherwise. Fails as presentationOf and
// dicom::writePresentationState; nothing is written then.
Result<std::vector<std::string>> writePresentation(const std::filesystem::path& path,
                                                   const PresentationWish& wish);

}  // namespace macula::app
