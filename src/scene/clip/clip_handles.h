// The handles by which a user drags a clip, in the volume and on a slice. World frame: patient LPS, mm.
#pragma once

#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "scene/clip/clip_shapes.h"
#include "scene/clip/cuts.h"
#include "slices/slice_plane.h"

namespace macula::scene {

// Handles are in the middle of each face, where each oblique plane is nearest to the middle of the volume, at
// the corner, at the ball's centre, and on its surface towards the patient's left. Without a clip, faces at
// the border of the volume let a user begin one. A clip that leaves nothing has no kept faces.
std::vector<PlacedHandle> handlesOf(const OptionalClip& clip, const Cuts& cuts, const Volume& volume);

// The same on a slice: each handle is in the middle of the visible part of the line where the border of its
// part meets the slice. A part that misses the slice, or is nearly parallel to it, has no handle. `along`
// lies in the slice.
std::vector<PlacedHandle> handlesOn(const slices::SliceFrame& frame, const OptionalClip& clip,
                                    const Cuts& cuts, const Volume& volume);

struct MovedClip {
    OptionalClip clip;
    Cuts cuts;
};
// Moves the handle's part to pass through the point `mm`: of a ball, its surface or its centre. Fails with
// usage as the functions of edited_clip.h do, and for a part that no longer exists.
Result<MovedClip> withHandleAt(const OptionalClip& clip, const Cuts& cuts, const ClipHandle& handle,
                               const glm::dvec3& mm, const Volume& volume);

// The point to give withHandleAt for a drag to `onSliceMm`. Handles that move in any direction, such
// as a corner, keep their distance from the slice; others move to `onSliceMm` itself.
glm::dvec3 draggedTo(const ClipHandle& handle, const glm::dvec3& onSliceMm, const slices::SliceFrame& frame,
                     const OptionalClip& clip, const Volume& volume);

}  // namespace macula::scene
