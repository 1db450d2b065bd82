// Whether two volumes lie in one place: in one frame of reference, or voxel on voxel.
#pragma once

#include "study/open/opened_study.h"

namespace macula::app {

// Whether both name the same frame of reference, and may be the same patient's. Copies that were made anew
// for a patient's name keep it.
bool shareFrameOfReference(const OpenedStudy& study, const OpenedStudy& second);

// Whether both have their voxels at the same places of one patient: one grid, in one frame of reference or of
// one series.
bool shareGrid(const OpenedStudy& a, const OpenedStudy& b);

// Whether `to` is another volume than `from`, and shares its grid. What is opened again comes as it was left.
bool staysInPlace(const OpenedStudy& from, const OpenedStudy& to);

// Whether both are phases of one series on one grid, so that one window is right for all of them.
bool arePhases(const OpenedStudy& a, const OpenedStudy& b);

}  // namespace macula::app
