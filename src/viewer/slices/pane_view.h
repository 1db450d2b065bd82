// Which part of its plane a pane shows: zoom and place, the pane's own.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "slices/slice_plane.h"
#include "viewer/overlay/slice_steps.h"

namespace macula::viewer {

struct PaneView {
    glm::dvec3 centreMm{0.0};  // in the middle of the pane, or above it along the normal
    double mmPerPx = 1.0;      // logical pixels, as below

    bool operator==(const PaneView&) const = default;
};

// The slice through the middle of the volume fits, so that slices do not change their size as they go by.
PaneView fittedView(const Volume& volume, const SliceSteps& steps, const glm::ivec2& sizePx);

// Where a volume lies in the space of a pane: paneFromVoxel is an affine transform of voxel indices.
struct PlacedGrid {
    glm::dmat4 paneFromVoxel{1.0};
    glm::ivec3 size{1};
};

// The view, moved in its plane until the middle of the pane lies in one of the volumes: the nearest of those
// that the plane meets. So no picture is dragged out of its pane.
PaneView withinReach(const PaneView& view, const slices::SlicePlane& plane,
                     std::span<const PlacedGrid> volumes);

// The picture follows a hand that went so far.
PaneView panned(const PaneView& view, const slices::SlicePlane& plane, const glm::dvec2& byPx);

// Closer by `factor`, and what lies `fromMiddlePx` off the middle of the pane stays there. Never farther than
// a quarter, nor closer than 64 times, of `fittedMmPerPx`.
PaneView zoomed(const PaneView& view, const slices::SlicePlane& plane, const glm::dvec2& fromMiddlePx,
                double factor, double fittedMmPerPx);

// The picture of that slice on a screen that has `pixelRatio` device pixels to a logical one.
slices::SliceFrame frameOf(const PaneView& view, const SliceSteps& steps, int slice, const glm::ivec2& sizePx,
                           double pixelRatio);

}  // namespace macula::viewer
