// Hands without controllers, where the headset sees them (XR_EXT_hand_tracking): thumb and index finger
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

// 1 where two finger tips touch, 0 where they are clearly apart.
float pinchOf(double apartM);

// From the joints, XR_HAND_JOINT_COUNT_EXT of them, in the stage: those whose place is known.
Hand handOf(std::span<const std::optional<Pose>> joints);

// Of a session. Must not outlive it.
class TrackedHands {
  public:
    // Nothing where the headset does not see hands.
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
