// XR_EXT_hand_tracking: two bare hands, of which palm, knuckle of the index finger and three tips are known.
#include <cmath>

#include "xr/runtime/state.h"

namespace macula::xr_script {

namespace {

XrHandTrackerEXT trackerOf(int hand) {
    return reinterpret_cast<XrHandTrackerEXT>(std::uintptr_t(0x4a00 + hand));
}

XrResult XRAPI_CALL create(XrSession session, const XrHandTrackerCreateInfoEXT* info,
                           XrHandTrackerEXT* tracker) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (const XrResult lost = enteredSession("xrCreateHandTrackerEXT", session); lost != XR_SUCCESS)
        return lost;
    if (info->type != XR_TYPE_HAND_TRACKER_CREATE_INFO_EXT ||
        info->handJointSet != XR_HAND_JOINT_SET_DEFAULT_EXT)
        return wrong(XR_ERROR_VALIDATION_FAILURE, "xrCreateHandTrackerEXT: the structure");
    *tracker = trackerOf(info->hand == XR_HAND_LEFT_EXT ? 0 : 1);
    ++s.record.handTrackers;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL destroy(XrHandTrackerEXT) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (s.record.handTrackers <= 0) return wrong(XR_ERROR_HANDLE_INVALID, "xrDestroyHandTrackerEXT");
    --s.record.handTrackers;
    return XR_SUCCESS;
}

void put(XrHandJointLocationsEXT* locations, XrHandJointEXT joint, const Pose& pose) {
    XrHandJointLocationEXT& location = locations->jointLocations[joint];
    location.locationFlags = XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT |
                             XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT |
                             XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
    location.pose = fromPose(pose);
    location.radius = 0.008f;
}

XrResult XRAPI_CALL locate(XrHandTrackerEXT tracker, const XrHandJointsLocateInfoEXT* info,
                           XrHandJointLocationsEXT* locations) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (const XrResult lost = entered("xrLocateHandJointsEXT"); lost != XR_SUCCESS) return lost;
    if (s.session && s.session->isLost) return XR_ERROR_SESSION_LOST;
    const auto base = s.spaces.find(info->baseSpace);
    if (base == s.spaces.end() || locations->jointCount != XR_HAND_JOINT_COUNT_EXT)
        return wrong(XR_ERROR_VALIDATION_FAILURE, "xrLocateHandJointsEXT: space or joints");
    const double seconds = secondsOf(info->time);
    const int hand = tracker == trackerOf(0) ? 0 : 1;
    const auto bare = s.script.bareHand ? s.script.bareHand(seconds, hand) : std::optional<BareHand>();
    const auto from = placeOf(*base->second, seconds);
    locations->isActive = bare && from ? XR_TRUE : XR_FALSE;
    for (std::uint32_t i = 0; i < locations->jointCount; ++i) locations->jointLocations[i].locationFlags = 0;
    if (!bare || !from) return XR_SUCCESS;
    const auto at = [&](const glm::dvec3& inPalmM) {
        return combined(inverse(*from), combined(bare->palm, {inPalmM, glm::dquat(1.0, 0.0, 0.0, 0.0)}));
    };
    const glm::dvec3 thumb(0.0, 0.0, -0.08);
    put(locations, XR_HAND_JOINT_PALM_EXT, at({0.0, 0.0, 0.0}));
    put(locations, XR_HAND_JOINT_INDEX_PROXIMAL_EXT, at({0.0, 0.0, -0.04}));
    put(locations, XR_HAND_JOINT_THUMB_TIP_EXT, at(thumb));
    put(locations, XR_HAND_JOINT_INDEX_TIP_EXT, at(thumb + glm::dvec3(bare->indexApartM, 0.0, 0.0)));
    put(locations, XR_HAND_JOINT_MIDDLE_TIP_EXT, at(thumb + glm::dvec3(0.0, bare->middleApartM, 0.0)));
    return XR_SUCCESS;
}

}  // namespace

PFN_xrVoidFunction handFunction(std::string_view name) {
    if (!state().extensions.contains(XR_EXT_HAND_TRACKING_EXTENSION_NAME)) return nullptr;
    if (name == "xrCreateHandTrackerEXT") return reinterpret_cast<PFN_xrVoidFunction>(create);
    if (name == "xrDestroyHandTrackerEXT") return reinterpret_cast<PFN_xrVoidFunction>(destroy);
    if (name == "xrLocateHandJointsEXT") return reinterpret_cast<PFN_xrVoidFunction>(locate);
    return nullptr;
}

}  // namespace macula::xr_script
