// What stays as it is when another volume of the same place takes the place of the one that is shown: a
// person who goes through the phases of a heart compares them.
#pragma once

#include "app/state/study_state.h"
#include "app/study/opened_study.h"

namespace macula::app {

// Whether both have their voxels at the same places of one patient: one grid, in one frame of reference or of
// one series.
bool shareGrid(const OpenedStudy& a, const OpenedStudy& b);

// Whether `to` is another volume than `from`, and shares its grid. What is opened again comes as it was left.
bool staysInPlace(const OpenedStudy& from, const OpenedStudy& to);

// Whether both are phases of one series on one grid, so that one window is right for all of them.
bool arePhases(const OpenedStudy& a, const OpenedStudy& b);

// The window that slices of the study are shown through: that of the state, else that of the series.
DisplayWindow shownWindow(const OpenedStudy& study, const SliceState& slices);

// How slices of `to` are shown after those of `from`, which are shown as `before`: where it stays in place,
// at the same place, and phases through the same window, too. Else as `usual`.
SliceState carriedSlices(const OpenedStudy& from, const SliceState& before, const OpenedStudy& to,
                         const SliceState& usual);

}  // namespace macula::app
