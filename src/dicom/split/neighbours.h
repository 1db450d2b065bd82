// Reports stacks that continue in another series.
#pragma once

#include <vector>

#include "dicom/stack/series.h"

namespace macula::dicom {

// Gives both of two even stacks a message when they lie in one coordinate system, have the same grid in the
// plane, and the second begins one slice distance after the end of the first. It does not join them: only a
// person knows whether they are one acquisition. `series` are those of one study.
void reportNeighbours(std::vector<Series>& series);

}  // namespace macula::dicom
