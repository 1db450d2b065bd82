// Prevents motion sickness: turns in steps, and darkness while the headset has lost its position. Nothing
// here moves a person who has not asked for it. Knows no OpenXR.
#pragma once

#include <glm/glm.hpp>

#include "xr/grasp.h"

namespace macula::xr {

inline constexpr double kSnapTurnDeg = 30.0;

// Turns the wearer to the right about the head's position; upright stays upright.
glm::dmat4 turnedAround(const glm::dmat4& stageFromWorld, const Pose& head, double toTheRightDeg);

// Scales the anatomy to `scale` about that point of the stage.
glm::dmat4 scaledAbout(const glm::dmat4& stageFromWorld, const glm::dvec3& pointM, double scale);

// Pushing the stick aside makes one turn; the stick must return before the next.
class SnapTurns {
  public:
    static constexpr float kTurnsFrom = 0.7f;
    static constexpr float kIsBackBelow = 0.3f;

    // The turn in this frame, in degrees to the right.
    double follow(const TwoHands& hands);

  private:
    bool isOut_ = false;
};

// The brightness of the pictures: falls to 0 while a headset that knew its position has lost it, and returns
// when the headset finds it again.
class Fade {
  public:
    static constexpr double kSeconds = 0.3;  // from full light to darkness

    // Call it in each frame. `isTracked`: the headset sees where it is. Returns light().
    double follow(double seconds, bool isTracked);
    // Dark at once: nothing can be shown, because the headset cannot even estimate its position.
    void goDark(double seconds);
    double light() const { return light_; }  // 0 to 1
    bool isLost() const { return wasTracked_ && !isTracked_; }

  private:
    double light_ = 1.0;
    double seconds_ = 0.0;
    bool hasBegun_ = false;
    // A headset that tracks only rotation never knows its position, and is not lost.
    bool wasTracked_ = false;
    bool isTracked_ = false;
};

}  // namespace macula::xr
