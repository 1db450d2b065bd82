// Zoom and position of a pane in its plane.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "slices/slice_plane.h"
#include "viewer/overlay/slice_steps.h"

namespace macula::viewer {

struct PaneView {
    glm::dvec3 centreMm{0.0};  // in the middle of the pane; may be off the plane along the normal
    double mmPerPx = 1.0;      // logical pixels, as below

    bool operator==(const PaneView&) const = default;
};

// Fits the slice through the middle of the volume, so that all slices keep one scale.
PaneView fittedView(const Volume& volume, const SliceSteps& steps, const glm::ivec2& sizePx);

// Where a volume lies in the space of a pane: paneFromVoxel is an affine transform of voxel indices.
struct PlacedGrid {
    glm::dmat4 paneFromVoxel{1.0};
    glm::ivec3 size{1};
};

// Moves the view in its plane until the middle of the pane lies in the nearest volume that the plane meets.
// So a drag cannot move the picture out of its pane.
PaneView withinReach(const PaneView& view, const slices::SlicePlane& plane,
                     std::span<const PlacedGrid> volumes);

// Moves the picture by `byPx` logical pixels.
PaneView panned(const PaneView& view, const slices::SlicePlane& plane, const glm::dvec2& byPx);

// Magnifies by `factor`. The point `fromMiddlePx` off the middle of the pane stays fixed. Limits the
// magnification to 1/4 to 64 times that of `fittedMmPerPx`.
PaneView zoomed(const PaneView& view, const slices::SlicePlane& plane, const glm::dvec2& fromMiddlePx,
                double factor, double fittedMmPerPx);

// The frame of that slice on a screen with `pixelRatio` device pixels to a logical one.
slices::SliceFrame frameOf(const PaneView& view, const SliceSteps& steps, int slice, const glm::ivec2& sizePx,
                           double pixelRatio);

}  // namespace macula::viewer
