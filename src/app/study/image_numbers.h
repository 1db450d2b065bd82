// The numbers by which a person finds the images of a volume again on another workstation.
#pragma once

#include <vector>

#include "dicom/split/stack.h"

namespace macula::app {

// InstanceNumber (0020,0013) of each of so many slices, for reports; 0 for those that are interpolated. Empty
// where numbers say nothing that the place of a slice does not say: they are missing, stand twice, are those
// of files with several frames, count as the slices do, or slices at the ends could not be read.
std::vector<int> imageNumbersOf(const dicom::Stack& stack, int slices);

}  // namespace macula::app
