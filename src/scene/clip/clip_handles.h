// Where a clip is taken hold of, in the volume and on a slice, and what comes of moving it. World frame:
// patient LPS, mm.
#pragma once

#include <cstddef>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "scene/clip/cuts.h"
#include "slices/slice_plane.h"

namespace macula::app {

struct ClipHandle {
    enum class Kind {
        face,         // of what is kept: keptBox
        removedFace,  // of a box that is removed
        plane,        // an oblique one of the clip
        eye,          // the cut from the eye
        corner,
        ballCentre,
        ballRadius,
    };
    Kind kind = Kind::face;
    Face face = Face::right;  // of the first two
    std::size_t plane = 0;    // of the third, among the planes of the clip

    bool operator==(const ClipHandle&) const = default;
};

struct PlacedHandle {
    ClipHandle handle;
    glm::dvec3 atMm{0.0};
    glm::dvec3 along{0.0};  // unit: where it can be moved to; zero: anywhere
};

// In the middle of each face, where each plane is nearest to the middle of the volume, at the corner, and at
// the centre of the ball and on its surface towards the patient's left. Faces are there without a clip too,
// at the border of the volume: so a clip is begun. None of faces where the clip leaves nothing.
std::vector<PlacedHandle> handlesOf(const ClipChoice& clip, const Cuts& cuts, const Volume& volume);

// The same on a slice: in the middle of the line where a part's border meets it, as far as that is within the
// picture. Nothing of a part that does not meet the slice, or lies along it. `along` lies in the slice.
std::vector<PlacedHandle> handlesOn(const slices::SliceFrame& frame, const ClipChoice& clip, const Cuts& cuts,
                                    const Volume& volume);

struct MovedClip {
    ClipChoice clip;
    Cuts cuts;
};
// The part that the handle belongs to goes through that point; of a ball its surface, or its centre. usage as
// the functions of edited_clip.h, and for what is not there any more.
Result<MovedClip> withHandleAt(const ClipChoice& clip, const Cuts& cuts, const ClipHandle& handle,
                               const glm::dvec3& mm, const Volume& volume);

// What is dragged on a slice stays as far from it as it is: the point to give withHandleAt for a place on the
// slice.
glm::dvec3 draggedTo(const ClipHandle& handle, const glm::dvec3& onSliceMm, const slices::SliceFrame& frame,
                     const ClipChoice& clip, const Volume& volume);

}  // namespace macula::app
