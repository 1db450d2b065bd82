// Hands without controllers, if the headset tracks them (XR_EXT_hand_tracking): thumb and index finger
// together grab and press, thumb and middle finger cut.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "base/result.h"
#include "xr/grasp.h"
#include "xr/session.h"

namespace macula::xr {

// 1 if two finger tips touch, 0 if they are clearly apart.
float pinchOf(double apartM);

// The hand from XR_HAND_JOINT_COUNT_EXT joints in the stage; nothing for a joint whose position is unknown.
Hand handOf(std::span<const std::optional<Pose>> joints);

// The hand trackers of a session. Must not outlive it.
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

}  // namespace macula::xr
