// Files that are in a folder more than once.
#pragma once

#include <vector>

#include "base/progress.h"
#include "dicom/stack/instance.h"

namespace macula::dicom {

// The same file twice (a folder copied into itself) is no second slice: the first in order stays. Files that
// share a SOP Instance UID and differ are kept: which of them is right is not ours to say. `series` are the
// frames of one series each; returns how many files were dropped from each. Reads only files that share UID
// and size with another, each once, on all cores; stops early when cancelled.
std::vector<std::size_t> dropCopies(const std::vector<std::vector<Frame>*>& series, Progress& progress);

// The same slices once more under new identifiers: of images at one position that agree in all the split
// rules look at (but for number and coordinate system), in their values' scale and in every pixel, the one
// with the lowest number stays. Only when no position is left with two: phases that happen to have an equal
// slice are phases. Returns how many were dropped from each series; reads only the pixels of such images.
std::vector<std::size_t> dropRepeats(const std::vector<std::vector<Frame>*>& series,
                                     const CancelToken& cancel);

}  // namespace macula::dicom
