// The part of a slice that a clip removes, for dimming and outlines. In pixels of the slice's picture.
#pragma once

#include <span>
#include <vector>

#include "pipeline/volume/clip.h"
#include "scene/clip/cuts.h"
#include "scene/clip/slice_polygons.h"
#include "slices/slice_plane.h"

namespace macula::scene {

// Within the picture the contours wind around what the shapes of the clip remove, by the rules of shows(); a
// circle is a polygon. Empty for an unusable frame.
std::vector<Contour> removedContours(const Clip& clip, const slices::SliceFrame& frame);

// The lines where the border of each part meets the slice, cut off at the volume except for a ball; faces are
// those of keptBox. A closed line ends with its first point.
std::vector<Contour> clipLines(const OptionalClip& clip, const Cuts& cuts, const Volume& volume,
                               const slices::SliceFrame& frame);

// The part of the slice behind the outline of a scissor cut, whichever side the cut removes. Empty if there
// is none; a slice seen edge-on may give several strips, which do not overlap.
std::vector<Contour> behindOutline(const ScissorCut& cut, const slices::SliceFrame& frame);

// Whether the contours enclose `px` by the nonzero winding rule.
bool isInsideContours(std::span<const Contour> contours, const glm::dvec2& px);

}  // namespace macula::scene
