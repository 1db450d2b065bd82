#include "scene/state/carried_view.h"

#include "pipeline/volume/window.h"
#include "study/open/same_place.h"

namespace macula::app {

DisplayWindow shownWindow(const OpenedStudy& study, const SliceState& slices) {
    return slices.window ? *slices.window : seriesWindow(*study.measured());
}

SliceState carriedSlices(const OpenedStudy& from, const SliceState& before, const OpenedStudy& to,
                         const SliceState& usual) {
    if (!staysInPlace(from, to)) return usual;
    SliceState carried = usual;
    carried.crosshairMm = before.crosshairMm;
    carried.asAcquired = before.asAcquired;
    carried.slab = before.slab;
    if (!arePhases(from, to)) return carried;
    carried.window = shownWindow(from, before);
    carried.isInverted = before.isInverted;
    return carried;
}

}  // namespace macula::app
