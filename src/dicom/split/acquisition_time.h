// Finds slices of a volume that were acquired long before or after their neighbours.
#pragma once

#include "dicom/stack/split_rules.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

// Warns when part of a volume was acquired apart: one to four pauses between neighbours exceed 30 s and 20
// times the median. Not for PET and NM, whose beds follow each other after minutes.
void tellAcquiredApart(Stack& stack, const SplitRules& rules);

}  // namespace macula::dicom
