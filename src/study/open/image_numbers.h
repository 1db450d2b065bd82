// Image numbers, by which another workstation finds the images of a volume.
#pragma once

#include <span>
#include <vector>

#include "dicom/stack/stack.h"

namespace macula::study {

// The InstanceNumber (0020,0013) of each of the `slices` slices of a volume, in their order; 0 for an
// interpolated slice. Empty when a number is missing or below 1, when two images share one (as frames of one
// file do), or when the volume lacks slices of the stack.
std::vector<int> imageNumbersOf(const dicom::Stack& stack, int slices);

// Whether each number except 0 equals the position of its slice, counted from 1, and so adds no information.
bool countAsSlices(std::span<const int> imageNumbers);

}  // namespace macula::study
