// Reports what other series of a study say of a stack: one reaches farther at one end, or continues it.
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

// Gives both of two even stacks a message when they lie in one coordinate system, have the same grid in the
// plane, and the second begins one slice distance after the end of the first. It does not join them: only a
// person knows whether they are one acquisition. `series` are those of one study.
void reportNeighbours(std::vector<Series>& series);

}  // namespace macula::dicom
