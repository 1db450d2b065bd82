// Which images an object refers to, and which frames of them (Image SOP Instance Reference Macro,
// PS3.3 10.3).
#pragma once

#include <string>
#include <vector>

#include "dicom/read/dataset.h"

namespace macula::dicom {

// UIDs may name a patient: never logged.
struct ReferencedFrames {
    std::string sopInstanceUid;
    std::vector<int> numbers = {};  // from 1, in the order of the file; none: all frames
    bool isDamaged = false;         // it names frames that cannot be read; all are meant then

    // `frame` as Frame::number, from 0.
    bool holds(int frame) const;

    bool operator==(const ReferencedFrames&) const = default;
};

// Nothing where the item names no image.
std::vector<ReferencedFrames> referencedFrames(const std::vector<Dataset>& items);

// Sorted by UID, each image once, with the frames of all that name it, sorted.
std::vector<ReferencedFrames> byImage(std::vector<ReferencedFrames> references);

}  // namespace macula::dicom
