#include "viewer/clip/clip_handles_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scene/clip/clip_outline.h"
#include "viewer/slices/clip_on_slice.h"

namespace macula::viewer {

namespace {

using Kind = scene::ClipHandle::Kind;

constexpr double kHitPx = 10.0;  // logical
constexpr int kDotsOfEdge = 5;   // between the ends of an edge
constexpr int kDotsOfBall = 40;
constexpr double kTowardsEye = 0.995;  // cosine: a handle cannot be dragged along a line seen nearly end-on

void addDot(std::vector<ToolMark>& marks, const scene::PictureRays& rays, const glm::dvec3& mm) {
    if (const auto place = rays.placeOf(mm)) marks.push_back({.kind = MarkKind::dot, .place = *place});
}

void addEdge(std::vector<ToolMark>& marks, const scene::PictureRays& rays, const glm::dvec3& a,
             const glm::dvec3& b) {
    for (int i = 0; i <= kDotsOfEdge; ++i) addDot(marks, rays, a + double(i) / (kDotsOfEdge + 1) * (b - a));
}

void addBox(std::vector<ToolMark>& marks, const scene::PictureRays& rays, const Box& box) {
    const std::array<glm::dvec3, 8> corners = cornersOf(box);
    for (std::size_t a = 0; a < corners.size(); ++a) {
        for (std::size_t b = a + 1; b < corners.size(); ++b) {
            const glm::dvec3 apart = corners[b] - corners[a];
            if (int(apart.x != 0.0) + int(apart.y != 0.0) + int(apart.z != 0.0) == 1)
                addEdge(marks, rays, corners[a], corners[b]);
        }
    }
    addDot(marks, rays, box.high);
}

// Adds dots where a plane meets the box.
void addPlane(std::vector<ToolMark>& marks, const scene::PictureRays& rays, const HalfSpace& plane,
              const Box& box) {
    const glm::dvec3 n = plane.normal;
    const glm::dvec3 other = std::abs(n.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 right = glm::normalize(glm::cross(other, n));
    const std::vector<glm::dvec3> outline =
        scene::outlineMm(box, {.centreMm = plane.offsetMm * n, .right = right, .down = glm::cross(n, right)});
    for (std::size_t i = 0; i < outline.size(); ++i)
        addEdge(marks, rays, outline[i], outline[(i + 1) % outline.size()]);
}

void addBall(std::vector<ToolMark>& marks, const scene::PictureRays& rays, const Ball& ball) {
    for (int i = 0; i < kDotsOfBall; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / kDotsOfBall;
        addDot(marks, rays,
               ball.centreMm +
                   ball.radiusMm * (std::cos(turn) * rays.axes().right + std::sin(turn) * rays.axes().up));
    }
}

bool movesAnywhere(const scene::PlacedHandle& handle) {
    return handle.along == glm::dvec3(0.0);
}

}  // namespace

std::vector<scene::PlacedHandle> ClipHandlesTool::handles(const scene::PictureRays& rays) const {
    const scene::StudyState& state = session_.state();
    const Volume& volume = *session_.study().volume;
    std::vector<scene::PlacedHandle> all = scene::handlesOf(state.clip, state.cuts, volume);
    glm::dvec3 ballCentre(0.0);
    for (scene::PlacedHandle& handle : all) {
        if (handle.handle.kind == Kind::ballCentre) ballCentre = handle.atMm;
        if (handle.handle.kind != Kind::ballRadius) continue;
        const double radiusMm = glm::length(handle.atMm - ballCentre);
        handle.along = rays.axes().right;
        handle.atMm = ballCentre + radiusMm * handle.along;
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
    if (movesAnywhere(handle) || handle.handle.kind == Kind::ballRadius)
        return scene::meets(ray, handle.atMm, rays->axes().forward);
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
    if (const Result<Box> kept = scene::keptBox(state.clip, volume)) addBox(marks, rays, *kept);
    if (!state.clip) return;
    const Clip clip = clipFor(*state.clip, volume);
    const Box all = volume.worldBox();
    if (clip.box && clip.ofBox == Keep::outside && clip.box->axes == glm::dmat3(1.0))
        addBox(marks, rays,
               {glm::max(clip.box->centreMm - clip.box->halfSizeMm, all.low),
                glm::min(clip.box->centreMm + clip.box->halfSizeMm, all.high)});
    for (const HalfSpace& plane : clip.planes) {
        if (!scene::isAlongAxis(plane)) addPlane(marks, rays, plane, all);
    }
    if (clip.ball) addBall(marks, rays, *clip.ball);
}

}  // namespace macula::viewer
