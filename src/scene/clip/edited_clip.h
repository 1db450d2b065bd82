// Edits of a clip by hand. Each function takes the current clip and returns the next one, for one volume;
// points and sizes are in patient LPS, mm.
//
// The result cuts within the volume, leaves at least a voxel (voxelExtentMm) between moved faces, is the same
// after writing and reading, and has a valid Clip (clipFor). It is nothing when no part and no setting of a
// clip is left. All edits fail with usage and a reason when a number is not finite or nothing would be left.
// Settings such as the window of cut faces stay; name and title become those of an own clip.
#pragma once

#include "scene/clip/kept_box.h"
#include "slices/slice_plane.h"

namespace macula::scene {

inline constexpr const char* kOwnClipName = "own";

// Moves one face of keptBox to `atMm`, and pushes the opposite face where it must. If the clip removes a box
// or keeps a turned one, the faces become planes, of which a clip can have six.
Result<OptionalClip> withFace(const OptionalClip& clip, Face face, double atMm, const Volume& volume);
Result<OptionalClip> withFaceOpen(const OptionalClip& clip, Face face, const Volume& volume);

// Also removes everything that lies farther to that side than the point. Fails if nothing that is kept lies
// there.
Result<OptionalClip> withSideRemoved(const OptionalClip& clip, Face side, const glm::dvec3& pointMm,
                                     const Volume& volume);

// Moves both faces along the normal of that orientation so that the point is in the middle; at the border of
// the volume the slab is thinner.
Result<OptionalClip> withSlabKept(const OptionalClip& clip, slices::Orientation orientation,
                                  const glm::dvec3& pointMm, double thicknessMm, const Volume& volume);

// Removes one of the eight parts around the point, which is within the volume's box: the one on these sides,
// one for each axis. Replaces a corner that was removed before.
Result<OptionalClip> withCornerRemoved(const OptionalClip& clip, const std::array<Face, 3>& sides,
                                       const glm::dvec3& pointMm, const Volume& volume);

// The usable radii: from half the smallest voxel spacing to the box diagonal, or to ten times the shortest
// side of the box if that is less.
ValueRange ballRadiiMm(const Volume& volume);
// Removes a ball around a point within the volume's box. Replaces a previous ball, removed or kept.
Result<OptionalClip> withBallRemoved(const OptionalClip& clip, const glm::dvec3& centreMm, double radiusMm,
                                     const Volume& volume);

// A point on the plane at this distance from the middle of the volume's box along the unit normal, in
// fractions of the box. A plane that misses the box is moved until it touches it.
glm::dvec3 fractionOnPlane(const glm::dvec3& normal, double fromMiddleMm, const Volume& volume);

// Moves an existing part as near to the point as the volume allows, and keeps whether its inside or outside
// is removed. usage also when the clip lacks the part: that plane, a removed box (moved by its face), a
// corner, a ball.
Result<OptionalClip> withPlaneThrough(const OptionalClip& clip, std::size_t plane, const glm::dvec3& pointMm,
                                      const Volume& volume);
Result<OptionalClip> withRemovedFace(const OptionalClip& clip, Face face, double atMm, const Volume& volume);
Result<OptionalClip> withCornerAt(const OptionalClip& clip, const glm::dvec3& pointMm, const Volume& volume);
Result<OptionalClip> withBallAt(const OptionalClip& clip, const glm::dvec3& centreMm, double radiusMm,
                                const Volume& volume);

// Shows what was removed, and removes what was shown. usage for a clip of several parts, because no clip can
// show what they remove together; parts are all faces together, each oblique plane, a box, a corner and a
// ball.
Result<OptionalClip> turnedInsideOut(const OptionalClip& clip, const Volume& volume);

}  // namespace macula::scene
