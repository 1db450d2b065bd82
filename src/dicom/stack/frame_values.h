// Reads how the pixels of a frame become values: rescale (PS3.3 C.11.1), real world value mapping
// (C.7.6.16.2.11), modality LUT, padding (C.7.5.1.1.2), display windows (C.11.2).
#pragma once

#include "dicom/stack/instance.h"

namespace macula::dicom {

// Fills in the fields for these; frame.instance must be set.
void readValues(const Dataset& dataset, Frame& frame);

}  // namespace macula::dicom
