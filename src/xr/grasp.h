// The state of the hands, and how they move the anatomy. Knows no OpenXR.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>

#include "xr/eyes.h"

namespace macula::xr {

struct Hand {
    std::optional<Pose> grip = {};  // where it holds; nothing while it is not tracked
    float squeeze = 0.0f;           // 0 to 1: grabs
    float trigger = 0.0f;           // 0 to 1: cuts
    std::optional<Pose> aim = {};   // points along its own -z
    float press = 0.0f;             // 0 to 1: presses the button that it points at
    float turn = 0.0f;              // -1 to 1: to the left, to the right
};

// The left one first.
using TwoHands = std::array<Hand, 2>;

// With hysteresis: a value from 0 to 1 counts as held until it is clearly released.
inline constexpr float kTakesFrom = 0.6f;
inline constexpr float kLetsGoBelow = 0.4f;
constexpr bool holdsOn(float value, bool held) {
    return value >= (held ? kLetsGoBelow : kTakesFrom);
}

// Moves the anatomy with the hands, from frame to frame.
class Grasp {
  public:
    // The placement that follows the hands: one hand that squeezes moves and turns the anatomy, two also
    // scale it.
    glm::dmat4 follow(const glm::dmat4& stageFromWorld, const TwoHands& hands);
    // Something else has moved the anatomy: the hands hold it from its present placement on.
    void takeAnew() { holds_ = {}; }
    bool isHolding() const { return holds_[0] || holds_[1]; }
    bool holds(std::size_t hand) const { return holds_.at(hand); }

  private:
    std::array<bool, 2> holds_{};
    std::array<Pose, 2> then_{};
    glm::dmat4 stageFromWorldThen_{1.0};
};

}  // namespace macula::xr
