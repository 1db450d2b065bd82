// The slice settings that stay when another volume at the same place replaces the one that is shown, so that
// a person can compare the phases of a heart.
#pragma once

#include "scene/state/study_state.h"
#include "study/open/opened_study.h"

namespace macula::scene {

// The window of the study's slices: that of the state, otherwise that of the series.
DisplayWindow shownWindow(const study::OpenedStudy& study, const SliceState& slices);

// How to show slices of `to` after those of `from`, shown as `before`: if staysInPlace, with the same
// cross-hair, planes and slab, and phases also with the same window and inversion. Otherwise as `usual`.
SliceState carriedSlices(const study::OpenedStudy& from, const SliceState& before,
                         const study::OpenedStudy& to, const SliceState& usual);

}  // namespace macula::scene
