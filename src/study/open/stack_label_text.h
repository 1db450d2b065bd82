// What tells a stack from the others of its series, in the words of people.
#pragma once

#include <string>

#include "dicom/stack/stack.h"

namespace macula::app {

// "TE 4.6 ms", "kernel B30f", "at 10:05:30", "oblique axial", "pixels 0.7 × 0.7 mm"; a keyword without words
// of its own is taken apart: "body part examined CHEST". Of a UID only the end, which tells it from others. A
// value that cannot be read as its attribute says stands as it is in the images. For the screen only.
std::string textOf(const dicom::StackLabel& label);

}  // namespace macula::app
