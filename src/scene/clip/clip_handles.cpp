#include "scene/clip/clip_handles.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "scene/clip/edit_steps.h"
#include "scene/clip/edited_clip.h"
#include "scene/clip/eye_cut.h"
#include "scene/clip/handles_on_slice.h"

namespace macula::scene {

namespace {

using Kind = ClipHandle::Kind;

std::vector<ShownShapePtr> shapesOf(const OptionalClip& clip, const Volume& volume) {
    return clip ? shownShapes(macula::clipFor(*clip, volume)) : std::vector<ShownShapePtr>();
}

// Null if it is not there any more.
ShownShapePtr shapeWith(const ClipHandle& handle, const OptionalClip& clip, const Volume& volume) {
    for (ShownShapePtr& shape : shapesOf(clip, volume))
        if (shape->has(handle)) return std::move(shape);
    return nullptr;
}

}  // namespace

std::vector<PlacedHandle> handlesOf(const OptionalClip& clip, const Cuts& cuts, const Volume& volume) {
    std::vector<PlacedHandle> handles;
    const Box all = volume.worldBox();
    if (const Result<Box> kept = keptBox(clip, volume)) handles = handlesOfFaces(Kind::face, *kept);
    for (const ShownShapePtr& shape : shapesOf(clip, volume))
        std::ranges::copy(shape->handles(all), std::back_inserter(handles));
    if (cuts.eye && hasRoomForEyeCut(clip))
        handles.push_back(handleOfPlane({.kind = Kind::eye}, cuts.eye->plane, all));
    return handles;
}

std::vector<PlacedHandle> handlesOn(const slices::SliceFrame& frame, const OptionalClip& clip,
                                    const Cuts& cuts, const Volume& volume) {
    if (!frame.isUsable() || frame.sizePx.x < 1 || frame.sizePx.y < 1) return {};
    HandlesOnSlice slice(frame, volume);
    if (const Result<Box> kept = keptBox(clip, volume)) slice.addFaces(Kind::face, *kept);
    for (const ShownShapePtr& shape : shapesOf(clip, volume)) shape->addHandles(slice);
    if (cuts.eye && hasRoomForEyeCut(clip)) slice.addPlane({.kind = Kind::eye}, cuts.eye->plane);
    return slice.take();
}

Result<MovedClip> withHandleAt(const OptionalClip& clip, const Cuts& cuts, const ClipHandle& handle,
                               const glm::dvec3& mm, const Volume& volume) {
    MovedClip moved{.clip = clip, .cuts = cuts};
    if (handle.kind == Kind::face) {
        MACULA_TRY(moved.clip, withFace(clip, handle.face, mm[axisOf(handle.face)], volume));
    } else if (handle.kind == Kind::eye) {
        if (!cuts.eye) return notThere();
        moved.cuts.eye = through(*cuts.eye, mm, volume);
    } else {
        const ShownShapePtr shape = shapeWith(handle, clip, volume);
        if (!shape) return notThere();
        MACULA_TRY(moved.clip, shape->withHandleAt(clip, handle, mm, volume));
    }
    return moved;
}

glm::dvec3 draggedTo(const ClipHandle& handle, const glm::dvec3& onSliceMm, const slices::SliceFrame& frame,
                     const OptionalClip& clip, const Volume& volume) {
    const ShownShapePtr shape = shapeWith(handle, clip, volume);
    if (!shape) return onSliceMm;
    const std::vector<PlacedHandle> handles = shape->handles(volume.worldBox());
    const auto placed = std::ranges::find(handles, handle, &PlacedHandle::handle);
    if (placed == handles.end() || placed->along != glm::dvec3(0.0)) return onSliceMm;
    return onSliceMm + frame.distanceMm(placed->atMm) * frame.plane.normal();
}

}  // namespace macula::scene
