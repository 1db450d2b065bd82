// What a hand holds to cut with: a knife, a ball or a box. Knows no OpenXR.
//
// While the trigger is held, an outline shows at the pace of the headset what would go. Where the hand rests,
// it is gone for a look; when the trigger is let go, it stays gone.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "pipeline/volume/clip.h"
#include "xr/grasp.h"

namespace macula::xr {

enum class ClipTool { none, knife, ball, box };

// In the room, whatever the size of the anatomy: 6 cm around a point 10 cm ahead of the hand.
inline constexpr double kToolReachM = 0.10;
inline constexpr double kToolHalfM = 0.06;

// The clip with what the tool removes there too. A ball takes the place of the ball before, a box that of the
// box; a box lies along the patient's axes, however the hand is turned: so it can be kept with the study.
// Nothing where there is no room for another plane, or the tool is none. `before` may be null.
std::optional<Clip> withTool(const Clip* before, ClipTool tool, const Pose& hand,
                             const glm::dmat4& stageFromWorld);

// Pictures of the outline: flat ones, with their middles; x to the right, y up, seen from +z.
struct OutlinePart {
    bool isRound = false;
    Pose pose;
    glm::dvec2 sizeM{0.0};
};
// `headM`: a ball is a ring that faces it.
std::vector<OutlinePart> outlineOf(ClipTool tool, const Pose& hand, const glm::dvec3& headM,
                                   const glm::dmat4& stageFromWorld);

// One hand's, from frame to frame.
class HeldTool {
  public:
    enum class Event {
        nothing,
        begun,      // the trigger was pulled
        rested,     // it is held, and the hand has come to rest
        letGo,      // it stays cut where the hand is
        abandoned,  // the hand was lost meanwhile, or the trigger is that of something else
    };
    static constexpr double kRestsWithinM = 0.004;
    static constexpr double kRestsAfterS = 0.25;

    Event follow(double seconds, const Hand& hand);
    bool isHeld() const { return isHeld_; }
    // A trigger that is down now is that of something else, or nobody knows what became of it meanwhile: what
    // is held is abandoned at the next call.
    void waitForRelease() { mustBeLetGo_ = true; }

  private:
    bool isHeld_ = false;
    bool mustBeLetGo_ = false;
    bool hasRested_ = false;  // since it moved last
    double restsSince_ = 0.0;
    Pose restsAt_;
};

}  // namespace macula::xr
