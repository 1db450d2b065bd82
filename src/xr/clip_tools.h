// The tools that a hand cuts with: a knife, or a shape that it removes (scene/clip/clip_shapes.h). Knows no
// OpenXR.
//
// While the trigger is held, an outline shows in each frame what the tool would remove. Where the hand rests,
// that part is hidden as a preview; when the trigger is released, it is removed.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "pipeline/volume/clip.h"
#include "scene/clip/clip_shapes.h"
#include "xr/grasp.h"

namespace macula::xr {

struct ClipTool {
    std::string_view key;  // of a scene::HandTool, or one of these two

    static const ClipTool none;
    static const ClipTool knife;

    bool operator==(const ClipTool&) const = default;
};
inline constexpr ClipTool ClipTool::none{};
inline constexpr ClipTool ClipTool::knife{"knife"};

// The tool that a person is offered after this one: a shape; none after the last.
ClipTool toolAfter(ClipTool tool);
// Null for a tool that is no shape.
const scene::HandTool* shapeOf(ClipTool tool);

// In metres of the room, whatever the scale of the anatomy: 6 cm around a point 10 cm ahead of the hand.
inline constexpr double kToolReachM = 0.10;
inline constexpr double kToolHalfM = 0.06;

// The clip `before` with this cut added. A shape replaces the earlier one of its kind. Nothing for
// ClipTool::none, or if there is no room for another plane. `before` may be null.
std::optional<Clip> withTool(const Clip* before, ClipTool tool, const Pose& hand,
                             const glm::dmat4& stageFromWorld);

// A flat picture of the outline, with its middle; x to the right, y up, seen from +z.
struct OutlinePart {
    bool isRound = false;
    Pose pose;
    glm::dvec2 sizeM{0.0};
};
// What is round is drawn as a ring that faces `headM`.
std::vector<OutlinePart> outlineOf(ClipTool tool, const Pose& hand, const glm::dvec3& headM,
                                   const glm::dmat4& stageFromWorld);

// Follows the tool of one hand from frame to frame.
class HeldTool {
  public:
    enum class Event {
        nothing,
        begun,      // the trigger was pulled
        rested,     // the trigger is held, and the hand has come to rest
        letGo,      // the trigger was released: the cut stays
        abandoned,  // the hand was lost, or the trigger serves something else
    };
    static constexpr double kRestsWithinM = 0.004;
    static constexpr double kRestsAfterS = 0.25;

    Event follow(double seconds, const Hand& hand);
    bool isHeld() const { return isHeld_; }
    // Ignores the trigger until it is released, because it serves something else, or nobody saw the hand for
    // a while. A held tool is abandoned at the next call.
    void waitForRelease() { mustBeLetGo_ = true; }

  private:
    bool isHeld_ = false;
    bool mustBeLetGo_ = false;
    bool hasRested_ = false;  // since the hand last moved
    double restsSince_ = 0.0;
    Pose restsAt_;
};

}  // namespace macula::xr
