// Reads where a frame lies in the patient (PS3.3 C.7.6.2, C.7.6.16.2.3, C.7.6.16.2.4).
#pragma once

#include "dicom/stack/instance.h"

namespace macula::dicom {

// The distance of each frame along the normal, for objects with one position for all frames: those of dose
// and of nuclear medicine, which list the offsets, and those that only give the distance between slices.
struct FrameOffsets {
    std::vector<double> mm;  // one for each frame whose offset is known; empty for other objects
    bool isByOrder = false;  // only their order shows where frames after the first lie
};
FrameOffsets frameOffsets(const Dataset& header);

// Fills in position, orientation and spacing. `header` is the file's top level, `dataset` the frame's.
void readPlane(const Dataset& header, const Dataset& dataset, double offsetMm, Frame& frame);

}  // namespace macula::dicom
