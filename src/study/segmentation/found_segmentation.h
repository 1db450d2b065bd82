// Finds the segmentations and structure sets of a folder, and which of them can be shown on one of its
// volumes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "dicom/segmentation/segmentation.h"
#include "dicom/segmentation/structure_set.h"
#include "study/open/found_volumes.h"

namespace macula::study {

// Strings are for the screen; they may name a patient.
struct FoundSegmentation {
    dicom::Segmentation header;  // default where the file cannot be read
    // Of a structure set, whose regions are the segments of `header`; else null.
    std::shared_ptr<const dicom::StructureSet> structures = {};
    std::string digest;  // SHA-256 of its SOP Instance UID, or of its path without one
    std::string title;   // its content label and the description of its series
    Text whyNot = {};    // a sentence: why it cannot be shown; empty: it can
    // A sentence where it was drawn on another series of the same coordinate system; otherwise empty.
    Text note = {};
    bool isOwn = false;  // a person makes it here: it has no file

    bool canBeShown() const { return whyNot.empty(); }
};

// Reads only headers. A segmentation fits the volume if both have the same patient and frame of reference or,
// where either names no frame of reference, if it refers to the series of the volume. In the order of the
// scan, those that can be shown first, copies once. Error: cancelled.
Result<std::vector<FoundSegmentation>> findSegmentations(const FoundVolumes& found, const FoundVolume& volume,
                                                         Progress& progress);

}  // namespace macula::study
