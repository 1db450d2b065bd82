#include "scene/state/carried_view.h"

#include "pipeline/volume/window.h"
#include "study/open/same_place.h"

namespace macula::scene {

DisplayWindow shownWindow(const study::OpenedStudy& study, const SliceState& slices) {
    return slices.window ? *slices.window : seriesWindow(*study.measured());
}

SliceState carriedSlices(const study::OpenedStudy& from, const SliceState& before,
                         const study::OpenedStudy& to, const SliceState& usual) {
    if (!study::staysInPlace(from, to)) return usual;
    SliceState carried = usual;
    carried.crosshairMm = before.crosshairMm;
    carried.asAcquired = before.asAcquired;
    carried.turn = before.turn;
    if (carried.curveMm.empty()) carried.curveMm = before.curveMm;
    carried.slab = before.slab;
    if (!study::arePhases(from, to)) return carried;
    carried.window = shownWindow(from, before);
    carried.isInverted = before.isInverted;
    carried.colours = before.colours;
    return carried;
}

}  // namespace macula::scene
