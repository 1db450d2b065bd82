#include "viewer/slices/pane_view.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/frames.h"

namespace macula::viewer {

namespace {

constexpr double kFarthest = 4.0;
constexpr double kClosest = 1.0 / 64.0;
constexpr int kMostSteps = 64;
constexpr double kInsideVoxels = 1e-3;

// A point near `from` that lies in both plane and volume, found by alternating projections (von Neumann);
// nothing if they do not meet.
std::optional<glm::dvec3> placeInVolume(const PlacedGrid& volume, const slices::SlicePlane& plane,
                                        const glm::dvec3& from) {
    const glm::dmat4 voxelFromPane = glm::inverse(volume.paneFromVoxel);
    const glm::dvec3 low(-0.5);
    const glm::dvec3 high = glm::dvec3(volume.size) - 0.5;
    const glm::dvec3 normal = plane.normal();
    glm::dvec3 mm = from;
    for (int step = 0; step < kMostSteps; ++step) {
        const glm::dvec3 voxel = transformPoint(voxelFromPane, mm);
        const glm::dvec3 inside = glm::clamp(voxel, low, high);
        if (glm::distance(voxel, inside) < kInsideVoxels) return mm;
        mm = transformPoint(volume.paneFromVoxel, inside);
        mm += normal * glm::dot(plane.centreMm - mm, normal);
    }
    return std::nullopt;
}

}  // namespace

PaneView fittedView(const Volume& volume, const SliceSteps& steps, const glm::ivec2& sizePx) {
    PaneView view{.centreMm = middleMm(volume)};
    if (sizePx.x < 1 || sizePx.y < 1) return view;
    view.mmPerPx =
        slices::fittedMmPerPixel(volume, steps.plane(steps.nearest(view.centreMm), view.centreMm), sizePx);
    return view;
}

PaneView withinReach(const PaneView& view, const slices::SlicePlane& plane,
                     std::span<const PlacedGrid> volumes) {
    const glm::dvec3 normal = plane.normal();
    const double offMm = glm::dot(view.centreMm - plane.centreMm, normal);
    const glm::dvec3 middle = view.centreMm - offMm * normal;
    std::optional<glm::dvec3> nearest;
    for (const PlacedGrid& volume : volumes) {
        const auto place = placeInVolume(volume, plane, middle);
        if (place && (!nearest || glm::distance(*place, middle) < glm::distance(*nearest, middle)))
            nearest = place;
    }
    PaneView within = view;
    if (nearest) within.centreMm = *nearest + offMm * normal;
    return within;
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
