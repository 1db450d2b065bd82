// Files that are in a folder more than once.
#pragma once

#include <vector>

#include "base/progress.h"
#include "dicom/series.h"

namespace macula::dicom {

// The same file twice (a folder copied into itself) is no second slice: the first by order in the series
// stays, and the series gets a message. Files that share a SOP Instance UID and differ are kept: which of
// them is right is not ours to say, and their equal positions will be reported. Reads only files that share
// UID and size with another, each once, on all cores; stops early when cancelled.
void dropCopies(const std::vector<Series*>& all, Progress& progress);

}  // namespace macula::dicom
