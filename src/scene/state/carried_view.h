// What stays as it is when another volume of the same place takes the place of the one that is shown: a
// person who goes through the phases of a heart compares them.
#pragma once

#include "scene/state/study_state.h"
#include "study/open/opened_study.h"

namespace macula::app {

// The window that slices of the study are shown through: that of the state, else that of the series.
DisplayWindow shownWindow(const OpenedStudy& study, const SliceState& slices);

// How slices of `to` are shown after those of `from`, which are shown as `before`: where it stays in place,
// at the same place, and phases through the same window, too. Else as `usual`.
SliceState carriedSlices(const OpenedStudy& from, const SliceState& before, const OpenedStudy& to,
                         const SliceState& usual);

}  // namespace macula::app
