#include "viewer/lights/lights_tool.h"

#include <cmath>
#include <numbers>

namespace macula::viewer {

namespace {

constexpr double kHitPx = 12.0;  // logical
constexpr int kDotsOfCircle = 60;
constexpr double kSidesDeg = 90.0;
constexpr double kStrongerPerNotch = 1.1;

}  // namespace

std::vector<glm::dvec2> LightsTool::places(const PictureGeometry& picture) const {
    std::vector<glm::dvec2> places;
    const auto stand = editing_.stand(picture.camera);
    if (!stand || !editing_.hasHandles()) return places;
    for (const trace::SoftLight& light : editing_.rig()->lights)
        places.push_back(scene::placeOnDome(scene::directionTo(light, *stand), stand->eye, picture.aspect));
    return places;
}

std::optional<std::size_t> LightsTool::lightAt(const PicturePlace& place) const {
    const std::vector<glm::dvec2> all = places(place.picture);
    std::optional<std::size_t> nearest;
    double least = kHitPx;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double away = glm::length(0.5 * (all[i] - place.at) * place.picture.sizePx);
        if (!(away <= least)) continue;
        least = away;
        nearest = i;
    }
    return nearest;
}

bool LightsTool::press(const PicturePlace& place) {
    if (place.withShift) return false;
    const auto light = lightAt(place);
    if (!light) return false;
    session_.endDrag();  // ends the undo step of an earlier drag
    editing_.choose(*light);
    grabbed_ = place.at - places(place.picture)[*light];
    pressedAt_ = place.at;
    return true;
}

void LightsTool::move(const PicturePlace& place) {
    const trace::SoftLight* light = editing_.light();
    const auto stand = editing_.stand(place.picture.camera);
    if (!grabbed_ || light == nullptr || !stand) return;
    const glm::dvec3 direction =
        scene::directionOnDome(place.at - *grabbed_, stand->eye, place.picture.aspect);
    // A refused move leaves the light where it is.
    [[maybe_unused]] const Result<void> moved = editing_.drag(scene::shiningFrom(*light, direction, *stand));
}

// A click that only chooses a light must not move it.
void LightsTool::release(const PicturePlace& place) {
    if (place.at != pressedAt_) move(place);
    giveUp();
}

// Keeps the drag so far: a person can undo it.
void LightsTool::giveUp() {
    grabbed_.reset();
    session_.endDrag();
}

std::optional<Qt::CursorShape> LightsTool::point(const PicturePlace& place) {
    return lightAt(place) ? std::optional(Qt::SizeAllCursor) : std::nullopt;
}

bool LightsTool::turnWheel(double notches, const PictureGeometry& /*picture*/) {
    if (!editing_.hasHandles() || editing_.light() == nullptr) return false;
    editing_.strengthen(std::pow(kStrongerPerNotch, notches));
    return true;
}

std::vector<ToolMark> LightsTool::marks(const PictureGeometry& picture) const {
    std::vector<ToolMark> marks;
    if (!editing_.hasHandles()) return marks;
    for (int i = 0; i < kDotsOfCircle; ++i)
        marks.push_back({.kind = MarkKind::dot,
                         .place = scene::circleOnDome(kSidesDeg, 2.0 * std::numbers::pi * i / kDotsOfCircle,
                                                      picture.aspect)});
    const std::vector<glm::dvec2> all = places(picture);
    for (std::size_t i = 0; i < all.size(); ++i)
        marks.push_back(
            {.kind = i == editing_.chosen() ? MarkKind::heldHandle : MarkKind::freeHandle, .place = all[i]});
    return marks;
}

}  // namespace macula::viewer
