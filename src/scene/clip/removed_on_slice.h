// What of a slice a clip removes, to be dimmed and outlined. In pixels of its picture.
#pragma once

#include <span>
#include <vector>

#include "pipeline/volume/clip.h"
#include "scene/clip/cuts.h"
#include "slices/slice_plane.h"

namespace macula::app {

using Contour = std::vector<glm::dvec2>;  // closed

// Within the picture, what the contours wind around is what box, planes, corner and ball of the clip remove
// (shows); a ball is a polygon of kBallSides. Nothing where the frame is not usable.
inline constexpr int kBallSides = 128;
std::vector<Contour> removedContours(const Clip& clip, const slices::SliceFrame& frame);

// Where the border of each part meets the slice: of faces those of what is kept, within the picture and the
// volume. The first and last point of a closed line are the same.
std::vector<Contour> clipLines(const ClipChoice& clip, const Cuts& cuts, const Volume& volume,
                               const slices::SliceFrame& frame);

// What of the slice is behind the outline of a scissor cut, whether that or the rest is removed. Empty where
// nothing is; of a slice that is seen from its edge there may be several strips, none over another.
std::vector<Contour> behindOutline(const ScissorCut& cut, const slices::SliceFrame& frame);

// By the rule of winding, as painters fill.
bool windAround(std::span<const Contour> contours, const glm::dvec2& px);

}  // namespace macula::app
