// The numbers by which a person finds the images of a volume again on another workstation.
#pragma once

#include <vector>

#include "dicom/split/stack.h"

namespace macula::app {

// The InstanceNumber (0020,0013) of each of the `slices` slices of a volume, in their order; 0 for a slice
// that is interpolated. Empty where no slice has a number of its own: a number is missing or below 1, two
// images share one (as frames of one file do), or the volume lacks slices of the stack. Empty, too, where the
// numbers count as the slices do.
std::vector<int> imageNumbersOf(const dicom::Stack& stack, int slices);

}  // namespace macula::app
