// What changes along the slices of a stack that stays whole.
#pragma once

#include "dicom/stack/split_rules.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

// Values that come of another kernel, contrast or acquisition step where it changes, and a step reads as
// pathology: gives a stack that is a volume one warning for each attribute of the rules' steps that changes
// along it, and for a rescale that changes at a few places.
void tellChanges(Stack& stack, const SplitRules& rules);

}  // namespace macula::dicom
