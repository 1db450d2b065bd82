#include "xr/hands.h"

#include <cstdio>
#include <string>
#include <utility>

#include "xr/placement.h"
#include "xr/xr_error.h"

namespace macula::xr {

namespace {

constexpr const char* kHands[] = {"/user/hand/left", "/user/hand/right"};
constexpr const char* kGazePath = "/user/eyes_ext/input/gaze_ext/pose";

// What there is to hold on to, and to cut with, of each kind of controller.
struct Profile {
    const char* name;
    const char* grab;
    const char* cut;
};
constexpr Profile kProfiles[] = {
    {"/interaction_profiles/khr/simple_controller", "select/click", "menu/click"},
    {"/interaction_profiles/oculus/touch_controller", "squeeze/value", "trigger/value"},
    {"/interaction_profiles/valve/index_controller", "squeeze/value", "trigger/value"},
    {"/interaction_profiles/htc/vive_controller", "squeeze/click", "trigger/value"},
    {"/interaction_profiles/microsoft/motion_controller", "squeeze/click", "trigger/value"},
};

}  // namespace

Result<Hands> Hands::create(const Session& session) {
    Hands hands(session.sharedRuntime());
    MACULA_TRY_VOID(hands.makeActions(session));
    MACULA_TRY_VOID(hands.suggestAll());
    MACULA_TRY_VOID(hands.makeSpaces(session));
    return hands;
}

Hands::Hands(Hands&& other) noexcept
    : runtime_(std::move(other.runtime_)),
      set_(std::exchange(other.set_, XR_NULL_HANDLE)),
      paths_(other.paths_),
      grab_(other.grab_),
      cut_(other.cut_),
      grip_(other.grip_),
      gaze_(other.gaze_),
      grips_(std::exchange(other.grips_, {})),
      gazeSpace_(std::exchange(other.gazeSpace_, XR_NULL_HANDLE)) {}

Hands::~Hands() {
    if (!set_) return;
    for (const XrSpace space : {grips_[0], grips_[1], gazeSpace_})
        if (space) runtime_->call().DestroySpace(space);
    runtime_->call().DestroyActionSet(set_);  // and its actions
}

Result<void> Hands::makeActions(const Session& session) {
    XrActionSetCreateInfo info{XR_TYPE_ACTION_SET_CREATE_INFO};
    std::snprintf(info.actionSetName, sizeof(info.actionSetName), "anatomy");
    std::snprintf(info.localizedActionSetName, sizeof(info.localizedActionSetName), "Anatomy");
    MACULA_XR_TRY(runtime_->call().CreateActionSet(runtime_->instance(), &info, &set_), "use controllers");
    for (std::size_t hand = 0; hand < paths_.size(); ++hand) {
        MACULA_TRY(paths_[hand], runtime_->path(kHands[hand]));
    }
    MACULA_TRY(grab_, makeAction("grab", "Grab, turn and scale", XR_ACTION_TYPE_FLOAT_INPUT, true));
    MACULA_TRY(cut_, makeAction("cut", "Cut", XR_ACTION_TYPE_FLOAT_INPUT, true));
    MACULA_TRY(grip_, makeAction("grip", "Hand", XR_ACTION_TYPE_POSE_INPUT, true));
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
    MACULA_XR_TRY(runtime_->call().CreateAction(set_, &info, &action), "use controllers");
    return action;
}

Result<void> Hands::suggest(const char* profile, const char* grab, const char* cut) {
    std::vector<XrActionSuggestedBinding> bindings;
    for (const char* hand : kHands) {
        const std::string input = std::string(hand) + "/input/";
        MACULA_TRY(const XrPath grabPath, runtime_->path(input + grab));
        MACULA_TRY(const XrPath cutPath, runtime_->path(input + cut));
        MACULA_TRY(const XrPath gripPath, runtime_->path(input + "grip/pose"));
        bindings.insert(bindings.end(), {{grab_, grabPath}, {cut_, cutPath}, {grip_, gripPath}});
    }
    XrInteractionProfileSuggestedBinding info{XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING};
    MACULA_TRY(info.interactionProfile, runtime_->path(profile));
    info.countSuggestedBindings = static_cast<std::uint32_t>(bindings.size());
    info.suggestedBindings = bindings.data();
    const XrResult suggested =
        runtime_->call().SuggestInteractionProfileBindings(runtime_->instance(), &info);
    if (suggested == XR_ERROR_PATH_UNSUPPORTED) return {};  // a kind that this runtime does not know
    MACULA_XR_TRY(suggested, "use controllers");
    return {};
}

Result<void> Hands::suggestAll() {
    for (const Profile& profile : kProfiles)
        MACULA_TRY_VOID(suggest(profile.name, profile.grab, profile.cut));
    if (!gaze_) return {};
    XrActionSuggestedBinding binding{gaze_, XR_NULL_PATH};
    MACULA_TRY(binding.binding, runtime_->path(kGazePath));
    XrInteractionProfileSuggestedBinding info{XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING};
    MACULA_TRY(info.interactionProfile, runtime_->path("/interaction_profiles/ext/eye_gaze_interaction"));
    info.countSuggestedBindings = 1;
    info.suggestedBindings = &binding;
    MACULA_XR_TRY(runtime_->call().SuggestInteractionProfileBindings(runtime_->instance(), &info),
                  "follow the eyes");
    return {};
}

Result<void> Hands::makeSpaces(const Session& session) {
    XrSessionActionSetsAttachInfo attach{XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO};
    attach.countActionSets = 1;
    attach.actionSets = &set_;
    MACULA_XR_TRY(runtime_->call().AttachSessionActionSets(session.handle(), &attach), "use controllers");
    XrActionSpaceCreateInfo info{XR_TYPE_ACTION_SPACE_CREATE_INFO};
    info.poseInActionSpace = toXr({});
    info.action = grip_;
    for (std::size_t hand = 0; hand < grips_.size(); ++hand) {
        info.subactionPath = paths_[hand];
        MACULA_XR_TRY(runtime_->call().CreateActionSpace(session.handle(), &info, &grips_[hand]),
                      "tell where hands are");
    }
    if (!gaze_) return {};
    info.action = gaze_;
    info.subactionPath = XR_NULL_PATH;
    MACULA_XR_TRY(runtime_->call().CreateActionSpace(session.handle(), &info, &gazeSpace_),
                  "follow the eyes");
    return {};
}

Result<float> Hands::value(const Session& session, XrAction action, XrPath hand) const {
    XrActionStateGetInfo info{XR_TYPE_ACTION_STATE_GET_INFO};
    info.action = action;
    info.subactionPath = hand;
    XrActionStateFloat state{XR_TYPE_ACTION_STATE_FLOAT};
    MACULA_XR_TRY(runtime_->call().GetActionStateFloat(session.handle(), &info, &state),
                  "tell what hands do");
    return state.isActive == XR_TRUE ? state.currentState : 0.0f;
}

Result<Hands::Seen> Hands::look(const Session& session, XrTime time) {
    const XrActiveActionSet active{set_, XR_NULL_PATH};
    XrActionsSyncInfo info{XR_TYPE_ACTIONS_SYNC_INFO};
    info.countActiveActionSets = 1;
    info.activeActionSets = &active;
    const XrResult synced = runtime_->call().SyncActions(session.handle(), &info);
    if (synced == XR_SESSION_NOT_FOCUSED) return Seen{};
    MACULA_XR_TRY(synced, "tell what hands do");
    Seen seen;
    for (std::size_t hand = 0; hand < seen.hands.size(); ++hand) {
        MACULA_TRY(seen.hands[hand].grip, session.locate(grips_[hand], time));
        MACULA_TRY(seen.hands[hand].squeeze, value(session, grab_, paths_[hand]));
        MACULA_TRY(seen.hands[hand].trigger, value(session, cut_, paths_[hand]));
    }
    if (gazeSpace_) {
        MACULA_TRY(seen.gaze, session.locate(gazeSpace_, time));
    }
    return seen;
}

glm::dmat4 Grasp::follow(const glm::dmat4& stageFromWorld, const TwoHands& hands) {
    std::array<bool, 2> holds{};
    for (std::size_t i = 0; i < hands.size(); ++i)
        holds[i] = hands[i].grip && hands[i].squeeze >= (holds_[i] ? kLetsGoBelow : kTakesFrom);
    if (holds != holds_) {  // it begins anew from where it is
        holds_ = holds;
        stageFromWorldThen_ = stageFromWorld;
        for (std::size_t i = 0; i < hands.size(); ++i) then_[i] = hands[i].grip.value_or(Pose{});
        return stageFromWorld;
    }
    if (holds[0] && holds[1])
        return followingHands(stageFromWorldThen_, then_, {*hands[0].grip, *hands[1].grip});
    for (std::size_t i = 0; i < hands.size(); ++i)
        if (holds[i]) return followingHand(stageFromWorldThen_, then_[i], *hands[i].grip);
    return stageFromWorld;
}

std::optional<HalfSpace> Grasp::cut(const glm::dmat4& stageFromWorld, const TwoHands& hands) {
    std::optional<HalfSpace> kept;
    for (std::size_t i = 0; i < hands.size(); ++i) {
        const bool cuts = hands[i].grip && hands[i].trigger >= (cuts_[i] ? kLetsGoBelow : kTakesFrom);
        if (cuts_[i] && !cuts && hands[i].grip)
            kept = keptBeside(*hands[i].grip, glm::inverse(stageFromWorld));
        cuts_[i] = cuts;
    }
    return kept;
}

}  // namespace macula::xr
