// Readable text for the attribute that sets a stack apart from others of its series.
#pragma once

#include "base/text.h"
#include "dicom/stack/stack.h"

namespace macula::study {

// "TE 4.6 ms", "kernel B30f", "at 10:05:30", "oblique axial", "pixels 0.7 × 0.7 mm"; other keywords are split
// into words: "image type ORIGINAL, PRIMARY". Of a long UID only the end is shown. A value that cannot be
// parsed is shown as in the images. For the screen only.
Text textOf(const dicom::StackLabel& label);

}  // namespace macula::study
