#include "xr/hands.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "base/check.h"
#include "xr/openxr.h"
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

constexpr InteractionProfile kProfiles[] = {
    {.name = "/interaction_profiles/khr/simple_controller",
     .grab = "select/click",
     .cut = "menu/click",
     .press = "select/click"},
    {.name = "/interaction_profiles/oculus/touch_controller",
     .grab = "squeeze/value",
     .cut = "trigger/value",
     .press = "trigger/value",
     .turn = "thumbstick/x"},
    {.name = "/interaction_profiles/valve/index_controller",
     .grab = "squeeze/value",
     .cut = "trigger/value",
     .press = "trigger/value",
     .turn = "thumbstick/x"},
    {.name = "/interaction_profiles/htc/vive_controller",
     .grab = "squeeze/click",
     .cut = "trigger/value",
     .press = "trigger/value",
     .turn = "trackpad/x",
     .turnsWhile = "trackpad/click"},
    {.name = "/interaction_profiles/microsoft/motion_controller",
     .grab = "squeeze/click",
     .cut = "trigger/value",
     .press = "trigger/value",
     .turn = "thumbstick/x"},
    {.name = "/interaction_profiles/hp/mixed_reality_controller",
     .extension = XR_EXT_HP_MIXED_REALITY_CONTROLLER_EXTENSION_NAME,
     .grab = "squeeze/value",
     .cut = "trigger/value",
     .press = "trigger/value",
     .turn = "thumbstick/x"},
};

constexpr const char* kHands[] = {"/user/hand/left", "/user/hand/right"};
constexpr const char* kGazePath = "/user/eyes_ext/input/gaze_ext/pose";

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

std::span<const InteractionProfile> interactionProfiles() {
    return kProfiles;
}

Result<Hands> Hands::create(const Session& session) {
    MACULA_TRY(std::optional<TrackedHands> tracked, TrackedHands::create(session));
    Hands hands(session.sharedRuntime(), std::move(tracked));
    MACULA_TRY_VOID(hands.makeActions(session));
    MACULA_TRY_VOID(hands.suggestAll());
    MACULA_TRY_VOID(hands.makeSpaces(session));
    return hands;
}

Hands::Hands(Hands&& other) noexcept
    : runtime_(std::move(other.runtime_)),
      tracked_(std::move(other.tracked_)),
      set_(std::exchange(other.set_, XR_NULL_HANDLE)),
      paths_(other.paths_),
      grab_(other.grab_),
      cut_(other.cut_),
      press_(other.press_),
      turn_(other.turn_),
      turnsWhile_(other.turnsWhile_),
      grip_(other.grip_),
      aim_(other.aim_),
      pulse_(other.pulse_),
      gaze_(other.gaze_),
      grips_(std::exchange(other.grips_, {})),
      aims_(std::exchange(other.aims_, {})),
      gazeSpace_(std::exchange(other.gazeSpace_, XR_NULL_HANDLE)) {}

Hands::~Hands() {
    if (!set_) return;
    for (const XrSpace space : {grips_[0], grips_[1], aims_[0], aims_[1], gazeSpace_})
        if (space) runtime_->call().DestroySpace(space);
    runtime_->call().DestroyActionSet(set_);  // and its actions
}

Result<void> Hands::makeActions(const Session& session) {
    XrActionSetCreateInfo info{XR_TYPE_ACTION_SET_CREATE_INFO};
    std::snprintf(info.actionSetName, sizeof(info.actionSetName), "anatomy");
    std::snprintf(info.localizedActionSetName, sizeof(info.localizedActionSetName), "Anatomy");
    MACULA_XR_TRY(runtime_->call().CreateActionSet(runtime_->instance(), &info, &set_),
                  Text("use controllers"));
    for (std::size_t hand = 0; hand < paths_.size(); ++hand) {
        MACULA_TRY(paths_[hand], runtime_->path(kHands[hand]));
    }
    MACULA_TRY(grab_, makeAction("grab", "Grab, turn and scale", XR_ACTION_TYPE_FLOAT_INPUT, true));
    MACULA_TRY(cut_, makeAction("cut", "Cut", XR_ACTION_TYPE_FLOAT_INPUT, true));
    MACULA_TRY(press_, makeAction("press", "Press a button of the panel", XR_ACTION_TYPE_FLOAT_INPUT, true));
    MACULA_TRY(turn_, makeAction("turn", "Turn around in steps", XR_ACTION_TYPE_FLOAT_INPUT, true));
    MACULA_TRY(turnsWhile_, makeAction("turns_while", "Turn now", XR_ACTION_TYPE_FLOAT_INPUT, true));
    MACULA_TRY(grip_, makeAction("grip", "Hand", XR_ACTION_TYPE_POSE_INPUT, true));
    MACULA_TRY(aim_, makeAction("aim", "Point", XR_ACTION_TYPE_POSE_INPUT, true));
    MACULA_TRY(pulse_, makeAction("pulse", "Feel", XR_ACTION_TYPE_VIBRATION_OUTPUT, true));
    if (session.runtime().offer().hasGaze) {
        MACULA_TRY(gaze_, makeAction("gaze", "Gaze", XR_ACTION_TYPE_POSE_INPUT, false));
    }
    return {};
}

Result<XrAction> Hands::makeAction(const char* name, const char* title, XrActionType type, bool isOfHands) {
    XrActionCreateInfo info{XR_TYPE_ACTION_CREATE_INFO};
    info.actionType = type;
    std::snprintf(info.actionName, sizeof(info.actionName), "%s", name);
    std::snprintf(info.localizedActionName, sizeof(info.localizedActionName), "%s", title);
    if (isOfHands) {
        info.countSubactionPaths = static_cast<std::uint32_t>(paths_.size());
        info.subactionPaths = paths_.data();
    }
    XrAction action = XR_NULL_HANDLE;
    MACULA_XR_TRY(runtime_->call().CreateAction(set_, &info, &action), Text("use controllers"));
    return action;
}

Result<void> Hands::suggest(const InteractionProfile& profile) {
    struct Wanted {
        XrAction action;
        const char* below;
        const char* control;
    };
    const Wanted all[] = {{grab_, "/input/", profile.grab},
                          {cut_, "/input/", profile.cut},
                          {press_, "/input/", profile.press},
                          {turn_, "/input/", profile.turn},
                          {turnsWhile_, "/input/", profile.turnsWhile},
                          {grip_, "/input/", "grip/pose"},
                          {aim_, "/input/", "aim/pose"},
                          {pulse_, "/output/", "haptic"}};
    std::vector<XrActionSuggestedBinding> bindings;
    for (const char* hand : kHands) {
        for (const Wanted& wanted : all) {
            if (!wanted.control) continue;
            MACULA_TRY(const XrPath path, runtime_->path(std::string(hand) + wanted.below + wanted.control));
            bindings.push_back({wanted.action, path});
        }
    }
    XrInteractionProfileSuggestedBinding info{XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING};
    MACULA_TRY(info.interactionProfile, runtime_->path(profile.name));
    info.countSuggestedBindings = static_cast<std::uint32_t>(bindings.size());
    info.suggestedBindings = bindings.data();
    const XrResult suggested =
        runtime_->call().SuggestInteractionProfileBindings(runtime_->instance(), &info);
    if (suggested == XR_ERROR_PATH_UNSUPPORTED) return {};  // this runtime does not know the controller
    MACULA_XR_TRY(suggested, Text("use controllers"));
    return {};
}

Result<void> Hands::suggestAll() {
    for (const InteractionProfile& profile : interactionProfiles()) {
        if (profile.extension && !runtime_->isOn(profile.extension)) continue;
        MACULA_TRY_VOID(suggest(profile));
    }
    if (!gaze_) return {};
    XrActionSuggestedBinding binding{gaze_, XR_NULL_PATH};
    MACULA_TRY(binding.binding, runtime_->path(kGazePath));
    XrInteractionProfileSuggestedBinding info{XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING};
    MACULA_TRY(info.interactionProfile, runtime_->path("/interaction_profiles/ext/eye_gaze_interaction"));
    info.countSuggestedBindings = 1;
    info.suggestedBindings = &binding;
    MACULA_XR_TRY(runtime_->call().SuggestInteractionProfileBindings(runtime_->instance(), &info),
                  Text("follow the eyes"));
    return {};
}

Result<void> Hands::makeSpaces(const Session& session) {
    XrSessionActionSetsAttachInfo attach{XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO};
    attach.countActionSets = 1;
    attach.actionSets = &set_;
    MACULA_XR_TRY(runtime_->call().AttachSessionActionSets(session.handle(), &attach),
                  Text("use controllers"));
    XrActionSpaceCreateInfo info{XR_TYPE_ACTION_SPACE_CREATE_INFO};
    info.poseInActionSpace = toXr({});
    for (std::size_t hand = 0; hand < grips_.size(); ++hand) {
        info.subactionPath = paths_[hand];
        info.action = grip_;
        MACULA_XR_TRY(runtime_->call().CreateActionSpace(session.handle(), &info, &grips_[hand]),
                      Text("tell where hands are"));
        info.action = aim_;
        MACULA_XR_TRY(runtime_->call().CreateActionSpace(session.handle(), &info, &aims_[hand]),
                      Text("tell where hands point"));
    }
    if (!gaze_) return {};
    info.action = gaze_;
    info.subactionPath = XR_NULL_PATH;
    MACULA_XR_TRY(runtime_->call().CreateActionSpace(session.handle(), &info, &gazeSpace_),
                  Text("follow the eyes"));
    return {};
}

Result<Hands::Control> Hands::value(const Session& session, XrAction action, XrPath hand) const {
    XrActionStateGetInfo info{XR_TYPE_ACTION_STATE_GET_INFO};
    info.action = action;
    info.subactionPath = hand;
    XrActionStateFloat state{XR_TYPE_ACTION_STATE_FLOAT};
    MACULA_XR_TRY(runtime_->call().GetActionStateFloat(session.handle(), &info, &state),
                  Text("tell what hands do"));
    if (state.isActive != XR_TRUE) return Control{};
    return Control{.isThere = true, .value = state.currentState};
}

Result<Hand> Hands::controller(const Session& session, std::size_t hand, XrTime time) const {
    Hand seen;
    MACULA_TRY(seen.grip, session.locate(grips_[hand], time));
    MACULA_TRY(seen.aim, session.locate(aims_[hand], time));
    MACULA_TRY(const Control grab, value(session, grab_, paths_[hand]));
    MACULA_TRY(const Control cut, value(session, cut_, paths_[hand]));
    MACULA_TRY(const Control press, value(session, press_, paths_[hand]));
    MACULA_TRY(const Control turn, value(session, turn_, paths_[hand]));
    MACULA_TRY(const Control turnsWhile, value(session, turnsWhile_, paths_[hand]));
    seen.squeeze = grab.value;
    seen.trigger = cut.value;
    seen.press = press.value;
    const bool isHeldBack = turnsWhile.isThere && turnsWhile.value < kTakesFrom;
    seen.turn = isHeldBack ? 0.0f : turn.value;
    return seen;
}

Result<Hands::Seen> Hands::look(const Session& session, XrTime time) {
    const XrActiveActionSet active{set_, XR_NULL_PATH};
    XrActionsSyncInfo info{XR_TYPE_ACTIONS_SYNC_INFO};
    info.countActiveActionSets = 1;
    info.activeActionSets = &active;
    const XrResult synced = runtime_->call().SyncActions(session.handle(), &info);
    if (synced == XR_SESSION_NOT_FOCUSED) return Seen{};
    MACULA_XR_TRY(synced, Text("tell what hands do"));
    Seen seen;
    for (std::size_t hand = 0; hand < seen.hands.size(); ++hand) {
        MACULA_TRY(seen.hands[hand], controller(session, hand, time));
        if (seen.hands[hand].grip || !tracked_) continue;
        MACULA_TRY(seen.hands[hand], tracked_->look(session, hand, time));
    }
    if (gazeSpace_) {
        MACULA_TRY(seen.gaze, session.locate(gazeSpace_, time));
    }
    return seen;
}

Result<void> Hands::pulse(const Session& session, std::size_t hand, float strength, double ms) const {
    XrHapticActionInfo info{XR_TYPE_HAPTIC_ACTION_INFO};
    info.action = pulse_;
    info.subactionPath = paths_.at(hand);
    XrHapticVibration vibration{XR_TYPE_HAPTIC_VIBRATION};
    vibration.duration = static_cast<XrDuration>(ms * 1e6);
    vibration.frequency = XR_FREQUENCY_UNSPECIFIED;
    vibration.amplitude = std::clamp(strength, 0.0f, 1.0f);
    const XrResult felt = runtime_->call().ApplyHapticFeedback(
        session.handle(), &info, reinterpret_cast<const XrHapticBaseHeader*>(&vibration));
    // Only the loss of the session is an error, not a missing vibration.
    if (felt == XR_ERROR_SESSION_LOST || felt == XR_ERROR_INSTANCE_LOST)
        return xrError(felt, Text("be felt in a hand"));
    return {};
}

}  // namespace macula::xr
