// The controllers or hands of the wearer, and where the eyes look.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "xr/grasp.h"
#include "xr/session.h"

namespace macula::xr {

// 1 if two finger tips touch, 0 if they are clearly apart.
float pinchOf(double apartM);

// The hand from XR_HAND_JOINT_COUNT_EXT joints in the stage; nothing for a joint whose position is unknown.
Hand handOf(std::span<const std::optional<Pose>> joints);

// Hands without controllers, if the headset tracks them (XR_EXT_hand_tracking): bringing thumb and
// index finger together grabs and presses, thumb and middle finger cuts. Must not outlive the XR session,
// whose trackers it holds.
class TrackedHands {
  public:
    // Nothing if the headset does not track hands.
    static Result<std::optional<TrackedHands>> create(const Session& session);

    TrackedHands(TrackedHands&& other) noexcept;
    TrackedHands& operator=(TrackedHands&&) = delete;
    ~TrackedHands();

    Result<Hand> look(const Session& session, std::size_t hand, XrTime time) const;

  private:
    explicit TrackedHands(std::shared_ptr<Runtime> runtime) : runtime_(std::move(runtime)) {}

    std::shared_ptr<Runtime> runtime_;
    PFN_xrCreateHandTrackerEXT make_ = nullptr;
    PFN_xrDestroyHandTrackerEXT destroy_ = nullptr;
    PFN_xrLocateHandJointsEXT locate_ = nullptr;
    std::array<XrHandTrackerEXT, 2> trackers_{};
};

// Paths below /user/hand/left/input and right; null: the controller has no such control.
struct InteractionProfile {
    const char* name;
    const char* extension = nullptr;  // the extension that it needs; null: none
    const char* grab;
    const char* cut;
    const char* press;
    const char* turn = nullptr;  // a stick, -1 to 1
    // For a pad, which a thumb always touches: turns only while this is pressed.
    const char* turnsWhile = nullptr;
};

std::span<const InteractionProfile> interactionProfiles();

// The OpenXR actions of a session. Must not outlive it.
class Hands {
  public:
    static Result<Hands> create(const Session& session);

    Hands(Hands&& other) noexcept;
    Hands& operator=(Hands&&) = delete;
    ~Hands();

    struct Seen {
        TwoHands hands;
        std::optional<Pose> gaze;  // nothing: no eye tracking, or not now
    };
    // The state at that time. Hands are idle while the session does not have the focus. Without a controller,
    // a hand is the bare hand if the headset tracks it.
    Result<Seen> look(const Session& session, XrTime time);

    // Vibrates the controller of that hand, if it can.
    Result<void> pulse(const Session& session, std::size_t hand, float strength, double ms) const;

  private:
    struct Control {
        bool isThere = false;
        float value = 0.0f;
    };

    Hands(std::shared_ptr<Runtime> runtime, std::optional<TrackedHands> tracked)
        : runtime_(std::move(runtime)), tracked_(std::move(tracked)) {}
    Result<void> makeActions(const Session& session);
    Result<XrAction> makeAction(const char* name, const char* title, XrActionType type, bool isOfHands);
    Result<void> suggest(const InteractionProfile& profile);
    Result<void> suggestAll();
    Result<void> makeSpaces(const Session& session);
    Result<Control> value(const Session& session, XrAction action, XrPath hand) const;
    Result<Hand> controller(const Session& session, std::size_t hand, XrTime time) const;

    std::shared_ptr<Runtime> runtime_;
    std::optional<TrackedHands> tracked_;  // nothing: the headset sees none
    XrActionSet set_ = XR_NULL_HANDLE;
    std::array<XrPath, 2> paths_{};
    XrAction grab_ = XR_NULL_HANDLE;
    XrAction cut_ = XR_NULL_HANDLE;
    XrAction press_ = XR_NULL_HANDLE;
    XrAction turn_ = XR_NULL_HANDLE;
    XrAction turnsWhile_ = XR_NULL_HANDLE;
    XrAction grip_ = XR_NULL_HANDLE;
    XrAction aim_ = XR_NULL_HANDLE;
    XrAction pulse_ = XR_NULL_HANDLE;
    XrAction gaze_ = XR_NULL_HANDLE;
    std::array<XrSpace, 2> grips_{};
    std::array<XrSpace, 2> aims_{};
    XrSpace gazeSpace_ = XR_NULL_HANDLE;
};

}  // namespace macula::xr
