#include "xr/clip_tools.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "xr/placement.h"

namespace macula::xr {

namespace {

constexpr double kBladeM = 0.24;
constexpr double kRestsWithinCosine = 0.9995;  // of half the turn; the whole is about 3.6 degrees

Pose ahead(const Pose& hand) {
    return {hand.positionM + hand.orientation * glm::dvec3(0.0, 0.0, -kToolReachM), hand.orientation};
}

// The turn of a cube's face: it turns +z to the face's normal.
glm::dquat turnTo(int axis, bool isHigh) {
    const glm::dvec3 up(0.0, 1.0, 0.0);
    const glm::dvec3 right(1.0, 0.0, 0.0);
    if (axis == 0) return glm::angleAxis(glm::radians(isHigh ? 90.0 : -90.0), up);
    if (axis == 1) return glm::angleAxis(glm::radians(isHigh ? -90.0 : 90.0), right);
    return glm::angleAxis(glm::radians(isHigh ? 0.0 : 180.0), up);
}

Pose facing(const glm::dvec3& atM, const glm::dvec3& headM) {
    const glm::dvec3 towards = headM - atM;
    if (!(glm::length(towards) > 1e-6)) return {atM, {1.0, 0.0, 0.0, 0.0}};
    const glm::dvec3 z = glm::normalize(towards);
    const glm::dvec3 helper = std::abs(z.y) < 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
    const glm::dvec3 x = glm::normalize(glm::cross(helper, z));
    return {atM, glm::normalize(glm::quat_cast(glm::dmat3(x, glm::cross(z, x), z)))};
}

// The turn of the patient's axes in the stage.
glm::dquat turnOf(const glm::dmat4& stageFromWorld) {
    glm::dmat3 turn;
    for (int axis = 0; axis < 3; ++axis) turn[axis] = glm::normalize(glm::dvec3(stageFromWorld[axis]));
    return glm::normalize(glm::quat_cast(turn));
}

}  // namespace

ClipTool toolAfter(ClipTool tool) {
    const std::vector<scene::HandTool>& shapes = scene::handTools();
    const auto now = std::ranges::find(shapes, tool.key, &scene::HandTool::key);
    const auto next = now == shapes.end() ? shapes.begin() : std::next(now);
    return next == shapes.end() ? ClipTool::none : ClipTool{next->key};
}

const scene::HandTool* shapeOf(ClipTool tool) {
    const std::vector<scene::HandTool>& shapes = scene::handTools();
    const auto found = std::ranges::find(shapes, tool.key, &scene::HandTool::key);
    return found == shapes.end() ? nullptr : &*found;
}

std::optional<Clip> withTool(const Clip* before, ClipTool tool, const Pose& hand,
                             const glm::dmat4& stageFromWorld) {
    Clip clip = before ? *before : Clip{};
    const glm::dmat4 worldFromStage = glm::inverse(stageFromWorld);
    if (tool == ClipTool::knife) {
        if (clip.planes.size() >= Clip::kMostPlanes) return std::nullopt;
        clip.planes.push_back(keptBeside(hand, worldFromStage));
        return clip;
    }
    const scene::HandTool* shape = shapeOf(tool);
    if (shape == nullptr) return std::nullopt;
    const double halfMm = 1000.0 * kToolHalfM / scaleOf(stageFromWorld);
    shape->remove(clip, transformPoint(worldFromStage, ahead(hand).positionM), halfMm);
    return clip;
}

std::vector<OutlinePart> outlineOf(ClipTool tool, const Pose& hand, const glm::dvec3& headM,
                                   const glm::dmat4& stageFromWorld) {
    const Pose middle = ahead(hand);
    if (tool == ClipTool::knife) {
        // Two pictures, because each is visible from one side only.
        std::vector<OutlinePart> blade;
        for (const bool isHigh : {false, true})
            blade.push_back({.isRound = false,
                             .pose = {middle.positionM, middle.orientation * turnTo(0, isHigh)},
                             .sizeM = glm::dvec2(kBladeM)});
        return blade;
    }
    const scene::HandTool* shape = shapeOf(tool);
    if (shape == nullptr) return {};
    if (shape->isRound)
        return {{.isRound = true,
                 .pose = facing(middle.positionM, headM),
                 .sizeM = glm::dvec2(2.0 * kToolHalfM)}};
    std::vector<OutlinePart> faces;
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool isHigh : {false, true}) {
            const glm::dquat turn = turnOf(stageFromWorld) * turnTo(axis, isHigh);
            faces.push_back({.isRound = false,
                             .pose = {middle.positionM + turn * glm::dvec3(0.0, 0.0, kToolHalfM), turn},
                             .sizeM = glm::dvec2(2.0 * kToolHalfM)});
        }
    }
    return faces;
}

HeldTool::Event HeldTool::follow(double seconds, const Hand& hand) {
    const bool wasHeld = isHeld_;
    const bool mayCut = !mustBeLetGo_;
    mustBeLetGo_ = mustBeLetGo_ && holdsOn(hand.trigger, true);
    isHeld_ = mayCut && hand.grip && holdsOn(hand.trigger, wasHeld);
    if (!isHeld_) {
        if (!wasHeld) return Event::nothing;
        return hand.grip && mayCut ? Event::letGo : Event::abandoned;
    }
    const bool hasMoved =
        !wasHeld || glm::distance(hand.grip->positionM, restsAt_.positionM) > kRestsWithinM ||
        std::abs(glm::dot(hand.grip->orientation, restsAt_.orientation)) < kRestsWithinCosine;
    if (hasMoved) {
        restsAt_ = *hand.grip;
        restsSince_ = seconds;
        hasRested_ = false;
        return wasHeld ? Event::nothing : Event::begun;
    }
    if (hasRested_ || seconds - restsSince_ < kRestsAfterS) return Event::nothing;
    hasRested_ = true;
    return Event::rested;
}

}  // namespace macula::xr
