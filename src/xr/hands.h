// What is in the hands of who wears the headset, and where the eyes look.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "base/result.h"
#include "pipeline/volume/clip.h"
#include "xr/eyes.h"
#include "xr/session.h"

namespace macula::xr {

struct Hand {
    std::optional<Pose> grip;  // where it holds; nothing while nobody knows
    float squeeze = 0.0f;      // 0 to 1: grabs
    float trigger = 0.0f;      // 0 to 1: cuts
};

// The left one first.
using TwoHands = std::array<Hand, 2>;

// The actions of a session. Must not outlive it.
class Hands {
  public:
    static Result<Hands> create(const Session& session);

    Hands(Hands&& other) noexcept;
    Hands& operator=(Hands&&) = delete;
    ~Hands();

    struct Seen {
        TwoHands hands;
        std::optional<Pose> gaze;  // nothing where eyes are not followed, or not now
    };
    // At that time. Hands lie still while the session has not the focus.
    Result<Seen> look(const Session& session, XrTime time);

  private:
    explicit Hands(std::shared_ptr<Runtime> runtime) : runtime_(std::move(runtime)) {}
    Result<void> makeActions(const Session& session);
    Result<XrAction> makeAction(const char* name, const char* title, XrActionType type, bool isOfHands);
    Result<void> suggest(const char* profile, const char* grab, const char* cut);
    Result<void> suggestAll();
    Result<void> makeSpaces(const Session& session);
    Result<float> value(const Session& session, XrAction action, XrPath hand) const;

    std::shared_ptr<Runtime> runtime_;
    XrActionSet set_ = XR_NULL_HANDLE;
    std::array<XrPath, 2> paths_{};
    XrAction grab_ = XR_NULL_HANDLE;
    XrAction cut_ = XR_NULL_HANDLE;
    XrAction grip_ = XR_NULL_HANDLE;
    XrAction gaze_ = XR_NULL_HANDLE;
    std::array<XrSpace, 2> grips_{};
    XrSpace gazeSpace_ = XR_NULL_HANDLE;
};

// What hands do to the anatomy, from frame to frame. Knows no OpenXR call.
class Grasp {
  public:
    // A hand that squeezes holds on until it clearly lets go.
    static constexpr float kTakesFrom = 0.6f;
    static constexpr float kLetsGoBelow = 0.4f;

    // Where the anatomy is now that the hands are there: one that squeezes takes it along, two turn and scale
    // it too.
    glm::dmat4 follow(const glm::dmat4& stageFromWorld, const TwoHands& hands);
    // What is kept beside a knife whose trigger was let go in this frame, of whichever hand; nothing else.
    std::optional<HalfSpace> cut(const glm::dmat4& stageFromWorld, const TwoHands& hands);
    bool isHolding() const { return holds_[0] || holds_[1]; }

  private:
    std::array<bool, 2> holds_{};
    std::array<bool, 2> cuts_{};
    std::array<Pose, 2> then_{};
    glm::dmat4 stageFromWorldThen_{1.0};
};

}  // namespace macula::xr
