#include "xr/tracked_hands.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/check.h"
#include "xr/xr_error.h"

namespace macula::xr {

namespace {

// Joints lie inside the fingers, so tips that touch are about a finger's width apart.
constexpr double kTouchM = 0.018;
constexpr double kApartM = 0.045;

std::optional<double> apart(std::span<const std::optional<Pose>> joints, int a, int b) {
    const auto& from = joints[std::size_t(a)];
    const auto& to = joints[std::size_t(b)];
    if (!from || !to) return std::nullopt;
    return glm::distance(from->positionM, to->positionM);
}

}  // namespace

float pinchOf(double apartM) {
    return float(std::clamp((kApartM - apartM) / (kApartM - kTouchM), 0.0, 1.0));
}

Hand handOf(std::span<const std::optional<Pose>> joints) {
    MACULA_CHECK_EQ(joints.size(), std::size_t(XR_HAND_JOINT_COUNT_EXT));
    Hand hand;
    const auto& palm = joints[XR_HAND_JOINT_PALM_EXT];
    if (!palm) return hand;
    hand.grip = palm;
    if (const auto pinch = apart(joints, XR_HAND_JOINT_THUMB_TIP_EXT, XR_HAND_JOINT_INDEX_TIP_EXT))
        hand.squeeze = hand.press = pinchOf(*pinch);
    // While the index finger pinches, the middle finger is near the thumb, too.
    if (const auto pinch = apart(joints, XR_HAND_JOINT_THUMB_TIP_EXT, XR_HAND_JOINT_MIDDLE_TIP_EXT);
        pinch && hand.squeeze < kLetsGoBelow)
        hand.trigger = pinchOf(*pinch);
    // A pinching finger is bent, so the hand points from the knuckle in the direction of the palm.
    if (const auto& knuckle = joints[XR_HAND_JOINT_INDEX_PROXIMAL_EXT])
        hand.aim = Pose{knuckle->positionM, palm->orientation};
    return hand;
}

Result<std::optional<TrackedHands>> TrackedHands::create(const Session& session) {
    const auto& runtime = session.sharedRuntime();
    if (!runtime->isOn(XR_EXT_HAND_TRACKING_EXTENSION_NAME)) return std::optional<TrackedHands>();
    XrSystemHandTrackingPropertiesEXT hands{XR_TYPE_SYSTEM_HAND_TRACKING_PROPERTIES_EXT};
    XrSystemProperties properties{XR_TYPE_SYSTEM_PROPERTIES, &hands};
    MACULA_XR_TRY(runtime->call().GetSystemProperties(runtime->instance(), runtime->system(), &properties),
                  Text("tell whether it sees hands"));
    if (hands.supportsHandTracking != XR_TRUE) return std::optional<TrackedHands>();

    TrackedHands made(runtime);
    made.make_ = reinterpret_cast<PFN_xrCreateHandTrackerEXT>(runtime->function("xrCreateHandTrackerEXT"));
    made.destroy_ =
        reinterpret_cast<PFN_xrDestroyHandTrackerEXT>(runtime->function("xrDestroyHandTrackerEXT"));
    made.locate_ = reinterpret_cast<PFN_xrLocateHandJointsEXT>(runtime->function("xrLocateHandJointsEXT"));
    if (!made.make_ || !made.destroy_ || !made.locate_) return std::optional<TrackedHands>();
    for (std::size_t hand = 0; hand < made.trackers_.size(); ++hand) {
        XrHandTrackerCreateInfoEXT info{XR_TYPE_HAND_TRACKER_CREATE_INFO_EXT};
        info.hand = hand == 0 ? XR_HAND_LEFT_EXT : XR_HAND_RIGHT_EXT;
        info.handJointSet = XR_HAND_JOINT_SET_DEFAULT_EXT;
        const XrResult asked = made.make_(session.handle(), &info, &made.trackers_[hand]);
        if (asked == XR_ERROR_SESSION_LOST || asked == XR_ERROR_INSTANCE_LOST)
            return xrError(asked, Text("follow hands"));
        if (XR_FAILED(asked)) return std::optional<TrackedHands>();  // controllers work without it
    }
    return std::optional<TrackedHands>(std::move(made));
}

TrackedHands::TrackedHands(TrackedHands&& other) noexcept
    : runtime_(std::move(other.runtime_)),
      make_(other.make_),
      destroy_(other.destroy_),
      locate_(other.locate_),
      trackers_(std::exchange(other.trackers_, {})) {}

TrackedHands::~TrackedHands() {
    for (const XrHandTrackerEXT tracker : trackers_)
        if (tracker) destroy_(tracker);
}

Result<Hand> TrackedHands::look(const Session& session, std::size_t hand, XrTime time) const {
    std::vector<XrHandJointLocationEXT> joints(XR_HAND_JOINT_COUNT_EXT);
    XrHandJointLocationsEXT locations{XR_TYPE_HAND_JOINT_LOCATIONS_EXT};
    locations.jointCount = XR_HAND_JOINT_COUNT_EXT;
    locations.jointLocations = joints.data();
    XrHandJointsLocateInfoEXT info{XR_TYPE_HAND_JOINTS_LOCATE_INFO_EXT};
    info.baseSpace = session.stage();
    info.time = time;
    MACULA_XR_TRY(locate_(trackers_.at(hand), &info, &locations), Text("tell where hands are"));
    if (locations.isActive != XR_TRUE) return Hand{};
    constexpr XrSpaceLocationFlags kKnown =
        XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT;
    std::vector<std::optional<Pose>> known(joints.size());
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const Pose pose = fromXr(joints[i].pose);
        if ((joints[i].locationFlags & kKnown) == kKnown && isUsable(pose)) known[i] = pose;
    }
    return handOf(known);
}

}  // namespace macula::xr
