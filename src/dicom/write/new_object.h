// Whose a written DICOM object is.
#pragma once

#include <optional>
#include <string>

#include "dicom/write/secondary_capture.h"

namespace macula::dicom {

struct NewObject {
    // An image of the series that the object is about, which gives patient and study. Its file must still
    // hold that instance. A deidentified object may have none: there the image only shows which objects
    // belong to one patient (object_owner.h).
    std::optional<SecondaryCapture::Source> image;
    // Copies nothing of patient and study, and replaces the UIDs of series, frame of reference and images by
    // those of standInUid: only with the series and this installation's key, made if there is none, can one
    // tell which series it is (isSeries).
    bool isDeidentified = false;
    std::string softwareVersion = "0";  // not empty, at most 64 characters, ASCII
};

}  // namespace macula::dicom
