// A clip that is changed by hand. Each function takes what is chosen and gives what is to be chosen next, for
// one volume; points and sizes are in patient LPS, mm.
//
// What comes out is within the volume, leaves at least a voxel between faces that moved
// (voxelExtentMm), says the same
// when it was written and read, and has a Clip (clipFor). Nothing comes out where all of the volume is shown
// again. All fail with usage, and the message says why: on numbers that are not finite, and when nothing
// would be left. The window of cut faces and what else is of a clip stays; name and title become its own.
#pragma once

#include "scene/clip/kept_box.h"
#include "slices/slice_plane.h"

namespace macula::app {

inline constexpr const char* kOwnClipName = "own";

// One face of what is kept (keptBox) goes there, and takes the opposite one along where it must. Where the
// clip removes a box, or keeps a turned one, faces are planes, of which it has six.
Result<ClipChoice> withFace(const ClipChoice& clip, Face face, double atMm, const Volume& volume);
Result<ClipChoice> withFaceOpen(const ClipChoice& clip, Face face, const Volume& volume);

// All that lies further to that side than the point is removed too. Fails where nothing does.
Result<ClipChoice> withSideRemoved(const ClipChoice& clip, Face side, const glm::dvec3& pointMm,
                                   const Volume& volume);

// Both faces along the normal of that orientation, so that the point is in the middle; at the border of the
// volume the slab is thinner.
Result<ClipChoice> withSlabKept(const ClipChoice& clip, slices::Orientation orientation,
                                const glm::dvec3& pointMm, double thicknessMm, const Volume& volume);

// One of the eight parts around the point, which is within the volume's box: that on these sides, one of each
// axis. It takes the place of a corner that was removed before.
Result<ClipChoice> withCornerRemoved(const ClipChoice& clip, const std::array<Face, 3>& sides,
                                     const glm::dvec3& pointMm, const Volume& volume);

// Radii that a clip of this volume can say, and that remove something.
ValueRange ballRadiiMm(const Volume& volume);
// A ball around a point within the volume's box. It takes the place of the ball before, removed or kept.
Result<ClipChoice> withBallRemoved(const ClipChoice& clip, const glm::dvec3& centreMm, double radiusMm,
                                   const Volume& volume);

// Where in the volume's box, in fractions of it, a plane can be said to go through that is so far from its
// middle, along the unit normal; of one that does not meet the box, that which is nearest to it.
glm::dvec3 fractionOnPlane(const glm::dvec3& normal, double fromMiddleMm, const Volume& volume);

// What is there already goes elsewhere, as near to the point as the volume allows; whether its inside or its
// outside is removed stays. usage also for what the clip has not: such a plane, a box that is removed (by its
// face), a corner, a ball.
Result<ClipChoice> withPlaneThrough(const ClipChoice& clip, std::size_t plane, const glm::dvec3& pointMm,
                                    const Volume& volume);
Result<ClipChoice> withRemovedFace(const ClipChoice& clip, Face face, double atMm, const Volume& volume);
Result<ClipChoice> withCornerAt(const ClipChoice& clip, const glm::dvec3& pointMm, const Volume& volume);
Result<ClipChoice> withBallAt(const ClipChoice& clip, const glm::dvec3& centreMm, double radiusMm,
                              const Volume& volume);

// Shows what was removed, and removes what was shown. Of a clip of one part: faces, one oblique plane, a box,
// a corner or a ball; of more the rest is no clip.
Result<ClipChoice> turnedInsideOut(const ClipChoice& clip, const Volume& volume);

}  // namespace macula::app
