// Series of a study that cover more at one end than a stack does.
#pragma once

#include <vector>

#include "dicom/stack/series.h"

namespace macula::dicom {

// Gives a volume a note when a parallel one of another series, in the same frame of reference and of the same
// modality, ends where it does at one end and goes on at the other, by five slices, 15 mm and a tenth of its
// length at least: a copy that was stopped looks so, and so does a protocol of two regions. Where there is
// none, a localizer of CT counts whose length is left out by two fifths at one end, and not at the other.
// `series` are those of one study; a study of more than 2000 volumes is not compared.
void reportFartherReach(std::vector<Series>& series);

}  // namespace macula::dicom
