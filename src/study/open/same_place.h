// Whether two volumes share a frame of reference or a grid.
#pragma once

#include "study/open/opened_study.h"

namespace macula::study {

// Whether both name the same frame of reference and are not known to belong to different patients. A copy
// with another name of the patient keeps the UID.
bool shareFrameOfReference(const OpenedStudy& study, const OpenedStudy& second);

// Whether both have the same grid (to 0.001 mm), in one frame of reference or series, and are not known to be
// of different patients.
bool shareGrid(const OpenedStudy& a, const OpenedStudy& b);

// Whether `to` is another volume than `from` on the same grid. A volume that is opened again is not.
bool staysInPlace(const OpenedStudy& from, const OpenedStudy& to);

// Whether both are phases of one series, or of one thing in a folder (phases.h), with one grid and unit, so
// that one window suits all of them.
bool arePhases(const OpenedStudy& a, const OpenedStudy& b);

}  // namespace macula::study
