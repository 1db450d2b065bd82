#include "xr/comfort.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "xr/placement.h"

namespace macula::xr {

namespace {

glm::dmat4 about(const glm::dvec3& pointM, const glm::dmat3& change) {
    return affine(change[0], change[1], change[2], pointM - change * pointM);
}

}  // namespace

glm::dmat4 turnedAround(const glm::dmat4& stageFromWorld, const Pose& head, double toTheRightDeg) {
    // A person who turns to the right sees the room turn to the left.
    const glm::dquat turn = glm::angleAxis(glm::radians(toTheRightDeg), glm::dvec3(0.0, 1.0, 0.0));
    return about(head.positionM, glm::mat3_cast(turn)) * stageFromWorld;
}

glm::dmat4 scaledAbout(const glm::dmat4& stageFromWorld, const glm::dvec3& pointM, double scale) {
    const double factor = std::clamp(scale, kLeastScale, kMostScale) / scaleOf(stageFromWorld);
    return about(pointM, glm::dmat3(factor)) * stageFromWorld;
}

double SnapTurns::follow(const TwoHands& hands) {
    float pushed = 0.0f;
    for (const Hand& hand : hands)
        if (std::abs(hand.turn) > std::abs(pushed)) pushed = hand.turn;
    if (isOut_) {
        isOut_ = std::abs(pushed) >= kIsBackBelow;
        return 0.0;
    }
    if (!(std::abs(pushed) >= kTurnsFrom)) return 0.0;
    isOut_ = true;
    return pushed > 0.0f ? kSnapTurnDeg : -kSnapTurnDeg;
}

double Fade::follow(double seconds, bool isTracked) {
    const double passed = hasBegun_ ? std::max(seconds - seconds_, 0.0) : 0.0;
    hasBegun_ = true;
    seconds_ = seconds;
    wasTracked_ = wasTracked_ || isTracked;
    isTracked_ = isTracked;
    const double step = passed / kSeconds;
    light_ = std::clamp(isLost() ? light_ - step : light_ + step, 0.0, 1.0);
    return light_;
}

void Fade::goDark(double seconds) {
    if (!hasBegun_) return;  // nobody has seen anything yet
    seconds_ = seconds;
    isTracked_ = false;
    light_ = 0.0;
}

}  // namespace macula::xr
