#include "viewer/clip/clip_handles_tool.h"

#include <cmath>
#include <utility>

#include "scene/clip/clip_outline.h"
#include "viewer/slices/clip_on_slice.h"

namespace macula::viewer {

namespace {

constexpr double kHitPx = 10.0;        // logical
constexpr double kTowardsEye = 0.995;  // cosine: a handle cannot be dragged along a line seen nearly end-on

void addDots(std::vector<ToolMark>& marks, const scene::PictureRays& rays,
             const std::vector<glm::dvec3>& dotsMm) {
    for (const glm::dvec3& mm : dotsMm)
        if (const auto place = rays.placeOf(mm)) marks.push_back({.kind = MarkKind::dot, .place = *place});
}

bool movesAnywhere(const scene::PlacedHandle& handle) {
    return handle.along == glm::dvec3(0.0);
}

}  // namespace

std::vector<scene::PlacedHandle> ClipHandlesTool::handles(const scene::PictureRays& rays) const {
    const scene::StudyState& state = session_.state();
    const Volume& volume = *session_.study().volume;
    std::vector<scene::PlacedHandle> all = scene::handlesOf(state.clip, state.cuts, volume);
    for (scene::PlacedHandle& handle : all) {
        if (!handle.aroundMm) continue;
        const double radiusMm = glm::length(handle.atMm - *handle.aroundMm);
        handle.along = rays.axes().right;
        handle.atMm = *handle.aroundMm + radiusMm * handle.along;
    }
    std::erase_if(all, [&](const scene::PlacedHandle& handle) {
        return std::abs(glm::dot(handle.along, rays.axes().forward)) > kTowardsEye;
    });
    return all;
}

std::optional<scene::PlacedHandle> ClipHandlesTool::handleAt(const PicturePlace& place) const {
    const auto rays = scene::PictureRays::of(place.picture.camera, place.picture.aspect);
    if (!isUsable() || !rays) return std::nullopt;
    std::optional<scene::PlacedHandle> nearest;
    double least = kHitPx;
    for (const scene::PlacedHandle& handle : handles(*rays)) {
        const auto at = rays->placeOf(handle.atMm);
        if (!at) continue;
        const double away = glm::length(0.5 * (*at - place.at) * place.picture.sizePx);
        if (!(away <= least)) continue;
        least = away;
        nearest = handle;
    }
    return nearest;
}

// The pointer's position on the line of the handle, or across the line of sight through it.
std::optional<glm::dvec3> ClipHandlesTool::draggedTo(const scene::PlacedHandle& handle,
                                                     const PicturePlace& place) const {
    const auto rays = scene::PictureRays::of(place.picture.camera, place.picture.aspect);
    if (!rays) return std::nullopt;
    const scene::PictureRay ray = rays->through(place.at);
    if (movesAnywhere(handle) || handle.aroundMm) return scene::meets(ray, handle.atMm, rays->axes().forward);
    const auto by = scene::nearestOnLine(ray, handle.atMm, handle.along);
    if (!by) return std::nullopt;
    return handle.atMm + *by * handle.along;
}

bool ClipHandlesTool::press(const PicturePlace& place) {
    if (place.withShift) return false;
    const auto handle = handleAt(place);
    const auto at = handle ? draggedTo(*handle, place) : std::nullopt;
    if (!at) return false;
    session_.endDrag();  // ends the undo step of an earlier drag
    held_ = Held{.handle = *handle, .grabbedMm = *at - handle->atMm};
    pointed_ = handle->handle;
    return true;
}

void ClipHandlesTool::move(const PicturePlace& place) {
    if (!held_ || !isUsable()) return;
    if (const auto at = draggedTo(held_->handle, place))
        editing_.drag(held_->handle.handle, *at - held_->grabbedMm);
}

void ClipHandlesTool::release(const PicturePlace& place) {
    move(place);
    giveUp();
}

// Keeps the drag so far: a person can undo it.
void ClipHandlesTool::giveUp() {
    held_.reset();
    session_.endDrag();
}

std::optional<Qt::CursorShape> ClipHandlesTool::point(const PicturePlace& place) {
    const auto handle = handleAt(place);
    const auto pointed = handle ? std::optional(handle->handle) : std::nullopt;
    if (std::exchange(pointed_, pointed) != pointed) Q_EMIT editing_.changed();
    if (!handle) return std::nullopt;
    if (movesAnywhere(*handle)) return Qt::SizeAllCursor;
    const auto rays = scene::PictureRays::of(place.picture.camera, place.picture.aspect);
    if (!rays) return std::nullopt;
    return cursorAlong(
        {glm::dot(handle->along, rays->axes().right), -glm::dot(handle->along, rays->axes().up)});
}

bool ClipHandlesTool::turnWheel(double notches, const PictureGeometry& picture) {
    if (!isUsable()) return false;
    editing_.setCamera(picture.camera);
    return editing_.stepEyeCut(notches).ok();
}

std::vector<ToolMark> ClipHandlesTool::marks(const PictureGeometry& picture) const {
    const auto rays = scene::PictureRays::of(picture.camera, picture.aspect);
    if (!isUsable() || !rays) return {};
    std::vector<ToolMark> marks;
    addLines(marks, *rays);
    for (const scene::PlacedHandle& handle : handles(*rays)) {
        const auto place = rays->placeOf(handle.atMm);
        if (!place) continue;
        const bool isHeld = held_ ? held_->handle.handle == handle.handle : pointed_ == handle.handle;
        marks.push_back({.kind = isHeld                  ? MarkKind::heldHandle
                                 : movesAnywhere(handle) ? MarkKind::freeHandle
                                                         : MarkKind::handle,
                         .place = *place});
    }
    return marks;
}

void ClipHandlesTool::addLines(std::vector<ToolMark>& marks, const scene::PictureRays& rays) const {
    const scene::StudyState& state = session_.state();
    const Volume& volume = *session_.study().volume;
    if (const Result<Box> kept = scene::keptBox(state.clip, volume))
        addDots(marks, rays, scene::dotsOfBox(*kept));
    if (!state.clip) return;
    for (const scene::ShownShapePtr& shape : scene::shownShapes(clipFor(*state.clip, volume)))
        addDots(marks, rays, shape->dots(rays, volume.worldBox()));
}

}  // namespace macula::viewer
