// What keeps people well: turns in steps, and darkness where the headset does not know where it is. Nothing
// here moves anybody who has not asked for it. Knows no OpenXR.
#pragma once

#include <glm/glm.hpp>

#include "xr/grasp.h"

namespace macula::xr {

inline constexpr double kSnapTurnDeg = 30.0;

// Turns who wears the headset, about where they are, to the right; upright stays upright.
glm::dmat4 turnedAround(const glm::dmat4& stageFromWorld, const Pose& head, double toTheRightDeg);

// Makes the anatomy so large, about that point of the stage.
glm::dmat4 scaledAbout(const glm::dmat4& stageFromWorld, const glm::dvec3& pointM, double scale);

// A stick that is pushed aside is one turn; it has to come back before the next.
class SnapTurns {
  public:
    static constexpr float kTurnsFrom = 0.7f;
    static constexpr float kIsBackBelow = 0.3f;

    // Degrees to the right in this frame.
    double follow(const TwoHands& hands);

  private:
    bool isOut_ = false;
};

// How much of the light is seen: it goes while a headset that knew its place does not know it any more, and
// comes back with that.
class Fade {
  public:
    static constexpr double kSeconds = 0.3;  // from all to nothing

    // Each frame. `isTracked`: the headset sees where it is.
    double follow(double seconds, bool isTracked);
    // Nothing could be shown, not even from where the headset guesses to be.
    void goDark(double seconds);
    double light() const { return light_; }  // 0 to 1
    bool isLost() const { return wasTracked_ && !isTracked_; }

  private:
    double light_ = 1.0;
    double seconds_ = 0.0;
    bool hasBegun_ = false;
    // A headset that only turns never knows its place, and is not lost.
    bool wasTracked_ = false;
    bool isTracked_ = false;
};

}  // namespace macula::xr
