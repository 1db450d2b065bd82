// Keeps one of each file, or slice, that a folder has more than once.
#pragma once

#include <vector>

#include "base/progress.h"
#include "dicom/stack/instance.h"

namespace macula::dicom {

// Keeps the first in order of identical files (a folder copied into itself). Keeps files that share a SOP
// Instance UID but differ, because nothing shows which of them is right. `series` are the frames of one
// series each; returns how many files were dropped from each. Reads only files that share UID and size with
// another, each once, on all cores; stops early when cancelled.
std::vector<std::size_t> dropCopies(const std::vector<std::vector<Frame>*>& series, Progress& progress);

// Drops slices that are repeated under new identifiers: of images at one position with equal attributes of
// the split rules (except number and coordinate system), rescale and pixels, it keeps the one with the lowest
// number. Drops only if no position keeps two: phases may happen to have an equal slice. Returns how many
// were dropped from each series; reads only the pixels of such images.
std::vector<std::size_t> dropRepeats(const std::vector<std::vector<Frame>*>& series,
                                     const CancelToken& cancel);

}  // namespace macula::dicom
