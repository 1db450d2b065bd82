// Warns of attributes that change along the slices of a stack that stays whole, and of slices that were
// acquired long before or after their neighbours.
#pragma once

#include "dicom/stack/split_rules.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

// A new kernel, contrast or acquisition makes a step in the values, which may look like pathology. Gives a
// stack that is a volume one warning for each attribute of the rules with a `step` that changes along it, and
// one for a rescale that changes at a few places.
void tellChanges(Stack& stack, const SplitRules& rules);

// Warns when part of a volume was acquired apart: one to four pauses between neighbours exceed 30 s and 20
// times the median. Not for PET and NM, whose beds follow each other after minutes.
void tellAcquiredApart(Stack& stack, const SplitRules& rules);

}  // namespace macula::dicom
