// The images that an object refers to, with their frames (Image SOP Instance Reference Macro, PS3.3 10.3).
#pragma once

#include <string>
#include <vector>

#include "dicom/read/dataset.h"

namespace macula::dicom {

// UIDs may name a patient: never logged.
struct ReferencedFrames {
    std::string sopInstanceUid;
    std::vector<int> numbers = {};  // from 1, in the order of the file; none: all frames
    bool isDamaged = false;         // its frame numbers cannot be read; it then refers to all frames

    // `frame` as Frame::number, from 0.
    bool holds(int frame) const;

    bool operator==(const ReferencedFrames&) const = default;
};

// Leaves out items that name no image.
std::vector<ReferencedFrames> referencedFrames(const std::vector<Dataset>& items);

// Sorted by UID, each image once, with the sorted frames of all its references.
std::vector<ReferencedFrames> byImage(std::vector<ReferencedFrames> references);

}  // namespace macula::dicom
