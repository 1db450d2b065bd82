// The segmentations of a folder, and which of them can be shown on a volume of it.
#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "dicom/segmentation/segmentation.h"
#include "study/open/found_volumes.h"

namespace macula::app {

// Strings are for the screen; they may name a patient.
struct FoundSegmentation {
    dicom::Segmentation header;  // as far as it could be read
    std::string digest;          // SHA-256 of its SOP Instance UID
    std::string title;           // what it calls itself, or its series
    std::string whyNot = {};     // why it cannot be shown, a sentence; empty: it can
    // It was drawn on another series, in the same coordinate system: a sentence; may be empty.
    std::string note = {};

    bool canBeShown() const { return whyNot.empty(); }
};

// Reads headers alone. A segmentation is of the volume when it has the patient and the frame of reference of
// it; where one of both names none, when it says that it was drawn on the series. In the order of the scan,
// those that can be shown first. cancelled.
Result<std::vector<FoundSegmentation>> findSegmentations(const FoundVolumes& found, const FoundVolume& volume,
                                                         Progress& progress);

}  // namespace macula::app
