#include "viewer/slices/pane_view.h"

#include <algorithm>
#include <cmath>

namespace macula::viewer {

namespace {

constexpr double kFarthest = 4.0;
constexpr double kClosest = 1.0 / 64.0;

}  // namespace

PaneView fittedView(const Volume& volume, const SliceSteps& steps, const glm::ivec2& sizePx) {
    PaneView view{.centreMm = middleMm(volume)};
    if (sizePx.x < 1 || sizePx.y < 1) return view;
    view.mmPerPx =
        slices::fittedMmPerPixel(volume, steps.plane(steps.nearest(view.centreMm), view.centreMm), sizePx);
    return view;
}

PaneView panned(const PaneView& view, const slices::SlicePlane& plane, const glm::dvec2& byPx) {
    PaneView moved = view;
    moved.centreMm -= (plane.right * byPx.x + plane.down * byPx.y) * view.mmPerPx;
    return moved;
}

PaneView zoomed(const PaneView& view, const slices::SlicePlane& plane, const glm::dvec2& fromMiddlePx,
                double factor, double fittedMmPerPx) {
    if (!(factor > 0.0) || !std::isfinite(factor)) return view;
    PaneView closer = view;
    closer.mmPerPx = std::clamp(view.mmPerPx / factor, fittedMmPerPx * kClosest, fittedMmPerPx * kFarthest);
    closer.centreMm +=
        (plane.right * fromMiddlePx.x + plane.down * fromMiddlePx.y) * (view.mmPerPx - closer.mmPerPx);
    return closer;
}

slices::SliceFrame frameOf(const PaneView& view, const SliceSteps& steps, int slice, const glm::ivec2& sizePx,
                           double pixelRatio) {
    return {.plane = steps.plane(slice, view.centreMm),
            .mmPerPixel = view.mmPerPx / pixelRatio,
            .sizePx = glm::ivec2(glm::round(glm::dvec2(sizePx) * pixelRatio))};
}

}  // namespace macula::viewer
