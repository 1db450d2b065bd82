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

namespace macula::scene {

// The only patient data in it: UIDs of images, series and frame of reference, classes of images, and one
// path.
struct PresentedImages {
    dicom::PresentedSeries series;
    std::filesystem::path middleFile;  // the object takes patient and study from it
    std::string middleSopInstanceUid;
    std::optional<double> suvFactor = {};  // dicom::Stack::suvFactor: SUV divided by it is the images' value
};

// Describes the stack that is shown. Error: usage if it lacks images, a frame of reference or UIDs.
Result<PresentedImages> presentedImages(const dicom::Series& series, const dicom::Stack& stack);

struct PresentationRequest {
    StudyState state;                      // with preset and camera
    std::shared_ptr<const Volume> volume;  // any format
    PresentedImages images;
    double aspectWidthOverHeight = 1.0;
    bool isDeidentified = false;
};

// Returns sentences on what other programs will show differently. Errors: those of presentationOf and
// dicom::writePresentationState; nothing is written then.
Result<std::vector<Text>> writePresentation(const std::filesystem::path& path,
                                            const PresentationRequest& request);

}  // namespace macula::scene
