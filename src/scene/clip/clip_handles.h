// The handles by which a user drags a clip, in the volume and on a slice. World frame: patient LPS, mm.
#pragma once

#include <cstddef>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "scene/clip/cuts.h"
#include "slices/slice_plane.h"

namespace macula::scene {

struct ClipHandle {
    enum class Kind {
        face,         // a face of keptBox
        removedFace,  // a face of a box that is removed
        plane,        // an oblique plane of the clip
        eye,          // the plane of the EyeCut
        corner,
        ballCentre,
        ballRadius,
    };
    Kind kind = Kind::face;
    Face face = Face::right;  // for face and removedFace
    std::size_t plane = 0;    // for plane: index into Clip::planes

    bool operator==(const ClipHandle&) const = default;
};

struct PlacedHandle {
    ClipHandle handle;
    glm::dvec3 atMm{0.0};
    glm::dvec3 along{0.0};  // unit: the direction it can move in; zero: any direction
};

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

// The point to give withHandleAt for a drag to `onSliceMm`. The corner and the ball's centre keep their
// distance from the slice; other handles move to `onSliceMm` itself.
glm::dvec3 draggedTo(const ClipHandle& handle, const glm::dvec3& onSliceMm, const slices::SliceFrame& frame,
                     const OptionalClip& clip, const Volume& volume);

}  // namespace macula::scene
