// Reports series of a study that reach farther than a stack at one end.
#pragma once

#include <vector>

#include "dicom/stack/series.h"

namespace macula::dicom {

// Gives a volume a note when a parallel one of another series, in the same frame of reference and of the same
// modality, ends where it does at one end and continues at the other by at least five slices, 15 mm and a
// tenth of its length: either copying was stopped, or the protocol has two regions. Without such a series,
// uses a CT localizer that extends beyond one end by two fifths of its length, and at the other by at most a
// quarter. `series` are those of one study; a study of more than 2000 volumes is not compared.
void reportFartherReach(std::vector<Series>& series);

}  // namespace macula::dicom
