// Slices of a volume that were acquired long before or after those beside them.
#pragma once

#include "dicom/stack/split_rules.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

// Warns of a volume part of which was acquired apart: a gap between neighbours that is long by itself and
// beside all others. Slices acquired in turn, odd and even ones, and the beds of one PET scan are not meant.
void tellAcquiredApart(Stack& stack, const SplitRules& rules);

}  // namespace macula::dicom
