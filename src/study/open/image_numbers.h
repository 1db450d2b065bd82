// The numbers by which a person finds the images of a volume again on another workstation.
#pragma once

#include <span>
#include <vector>

#include "dicom/stack/stack.h"

namespace macula::app {

// The InstanceNumber (0020,0013) of each of the `slices` slices of a volume, in their order; 0 for a slice
// that is interpolated. Empty where no slice has a number of its own: a number is missing or below 1, two
// images share one (as frames of one file do), or the volume lacks slices of the stack.
std::vector<int> imageNumbersOf(const dicom::Stack& stack, int slices);

// Whether the numbers are those of the slices, from 1, so that they say nothing besides.
bool countAsSlices(std::span<const int> imageNumbers);

}  // namespace macula::app
