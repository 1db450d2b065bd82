#include "xr/placement.h"

#include <algorithm>
#include <cmath>

namespace macula::xr {

namespace {

constexpr double kReachM = 0.35;       // least distance from the eyes to the visible anatomy
constexpr double kLeastApartM = 0.02;  // between two hands, to define their direction

glm::dmat4 shift(const glm::dvec3& by) {
    glm::dmat4 matrix(1.0);
    matrix[3] = glm::dvec4(by, 1.0);
    return matrix;
}

// The shortest turn from one direction to another.
glm::dquat turnBetween(const glm::dvec3& from, const glm::dvec3& to) {
    const double cosine = glm::dot(from, to);
    if (cosine < -1.0 + 1e-9) {  // half a turn, about any perpendicular axis
        const glm::dvec3 helper = std::abs(from.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
        return glm::dquat(0.0, glm::normalize(glm::cross(from, helper)));
    }
    return glm::normalize(glm::dquat(1.0 + cosine, glm::cross(from, to)));
}

}  // namespace

glm::dmat4 stageFromWorldBefore(const Pose& head, const Box& seenMm) {
    const glm::dvec3 look = head.orientation * glm::dvec3(0.0, 0.0, -1.0);
    glm::dvec3 ahead(look.x, 0.0, look.z);
    // If the wearer looks straight down, ahead is where the top of the head points; straight up, the
    // opposite.
    if (glm::length(ahead) < 1e-3) {
        const glm::dvec3 top = head.orientation * glm::dvec3(0.0, look.y < 0.0 ? 1.0 : -1.0, 0.0);
        ahead = {top.x, 0.0, top.z};
    }
    ahead = glm::normalize(ahead);
    const glm::dvec3 right = glm::cross(ahead, glm::dvec3(0.0, 1.0, 0.0));
    // The patient's left is on the right of a viewer in front.
    const glm::dmat3 turn(right, ahead, glm::dvec3(0.0, 1.0, 0.0));
    const glm::dmat3 scaled = kMetresPerMm * turn;
    const double radiusM = 0.5 * kMetresPerMm * std::max(seenMm.diagonal(), 0.0);
    const glm::dvec3 middleM = head.positionM + (kReachM + radiusM) * ahead;
    return affine(scaled[0], scaled[1], scaled[2], middleM - scaled * seenMm.centre());
}

double scaleOf(const glm::dmat4& stageFromWorld) {
    return std::cbrt(glm::determinant(glm::dmat3(stageFromWorld))) / kMetresPerMm;
}

double nearMmOf(const glm::dmat4& stageFromWorld) {
    return kNearM / kMetresPerMm / scaleOf(stageFromWorld);
}

glm::dmat4 followingHand(const glm::dmat4& stageFromWorldThen, const Pose& then, const Pose& now) {
    return stageFromPose(now) * glm::inverse(stageFromPose(then)) * stageFromWorldThen;
}

glm::dmat4 followingHands(const glm::dmat4& stageFromWorldThen, const std::array<Pose, 2>& then,
                          const std::array<Pose, 2>& now) {
    const glm::dvec3 acrossThen = then[1].positionM - then[0].positionM;
    const glm::dvec3 acrossNow = now[1].positionM - now[0].positionM;
    const glm::dvec3 middleThen = 0.5 * (then[0].positionM + then[1].positionM);
    const glm::dvec3 middleNow = 0.5 * (now[0].positionM + now[1].positionM);
    glm::dmat4 change(1.0);
    const double apartThen = glm::length(acrossThen);
    const double apartNow = glm::length(acrossNow);
    if (apartThen > kLeastApartM && apartNow > kLeastApartM) {
        const double before = scaleOf(stageFromWorldThen);
        const double scale = std::clamp(before * apartNow / apartThen, kLeastScale, kMostScale) / before;
        change =
            glm::dmat4(scale * glm::mat3_cast(turnBetween(acrossThen / apartThen, acrossNow / apartNow)));
        change[3] = glm::dvec4(0.0, 0.0, 0.0, 1.0);
    }
    return shift(middleNow) * change * shift(-middleThen) * stageFromWorldThen;
}

HalfSpace keptBeside(const Pose& knife, const glm::dmat4& worldFromStage) {
    const glm::dmat4 worldFromKnife = worldFromStage * stageFromPose(knife);
    HalfSpace kept;
    kept.normal = glm::normalize(transformVector(worldFromKnife, {-1.0, 0.0, 0.0}));
    kept.offsetMm = glm::dot(kept.normal, transformPoint(worldFromKnife, glm::dvec3(0.0)));
    return kept;
}

}  // namespace macula::xr
