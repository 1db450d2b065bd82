// Actions: two controllers with what the profile of the script has, and the eyes.
#include <algorithm>
#include <cmath>

#include "xr/runtime/state.h"

namespace macula::xr_script {

namespace {

constexpr const char* kEyesProfile = "/interaction_profiles/ext/eye_gaze_interaction";
constexpr const char* kHands[] = {"/user/hand/left", "/user/hand/right"};

XrResult XRAPI_CALL createSet(XrInstance, const XrActionSetCreateInfo* info, XrActionSet* set) {
    const std::lock_guard lock(state().mutex);
    if (const XrResult lost = entered("xrCreateActionSet"); lost != XR_SUCCESS) return lost;
    if (!info->actionSetName[0] || !info->localizedActionSetName[0])
        return wrong(XR_ERROR_NAME_INVALID, "xrCreateActionSet: no name");
    *set = nextHandle<XrActionSet>();
    state().sets.insert(*set);
    ++state().record.actionSets;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL destroySet(XrActionSet set) {
    const std::lock_guard lock(state().mutex);
    if (state().sets.erase(set) == 0) return wrong(XR_ERROR_HANDLE_INVALID, "xrDestroyActionSet");
    --state().record.actionSets;
    std::erase_if(state().actions, [&](const auto& entry) { return entry.second->set == set; });
    return XR_SUCCESS;
}

XrResult XRAPI_CALL createAction(XrActionSet set, const XrActionCreateInfo* info, XrAction* action) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (const XrResult lost = entered("xrCreateAction"); lost != XR_SUCCESS) return lost;
    if (!s.sets.contains(set)) return wrong(XR_ERROR_HANDLE_INVALID, "xrCreateAction: the set");
    if (s.session && s.session->isAttached)
        return wrong(XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, "xrCreateAction: after the set was attached");
    for (const auto& [handle, other] : s.actions)
        if (other->set == set && other->name == info->actionName)
            return wrong(XR_ERROR_NAME_DUPLICATED, "xrCreateAction: the name");
    auto made = std::make_unique<ActionState>();
    made->set = set;
    made->type = info->actionType;
    made->name = info->actionName;
    made->hands.assign(info->subactionPaths, info->subactionPaths + info->countSubactionPaths);
    *action = nextHandle<XrAction>();
    s.actions[*action] = std::move(made);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL suggest(XrInstance, const XrInteractionProfileSuggestedBinding* suggested) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (const XrResult lost = entered("xrSuggestInteractionProfileBindings"); lost != XR_SUCCESS) return lost;
    if (s.session && s.session->isAttached)
        return wrong(XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, "bindings suggested after the set was attached");
    const std::string profile = pathText(suggested->interactionProfile);
    for (std::uint32_t i = 0; i < suggested->countSuggestedBindings; ++i) {
        const XrActionSuggestedBinding& binding = suggested->suggestedBindings[i];
        const std::string path = pathText(binding.binding);
        const auto action = s.actions.find(binding.action);
        if (action == s.actions.end() || !hasControl(profile, path))
            return wrong(XR_ERROR_PATH_UNSUPPORTED, "a binding of " + profile + ": " + path);
        action->second->bindings[profile].push_back(path);
    }
    s.record.profiles.push_back(profile);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL attach(XrSession session, const XrSessionActionSetsAttachInfo* info) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (const XrResult lost = enteredSession("xrAttachSessionActionSets", session); lost != XR_SUCCESS)
        return lost;
    if (s.session->isAttached)
        return wrong(XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, "xrAttachSessionActionSets twice");
    for (std::uint32_t i = 0; i < info->countActionSets; ++i)
        if (!s.sets.contains(info->actionSets[i]))
            return wrong(XR_ERROR_HANDLE_INVALID, "xrAttachSessionActionSets: a set");
    s.session->isAttached = true;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL sync(XrSession session, const XrActionsSyncInfo* info) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (const XrResult lost = enteredSession("xrSyncActions", session); lost != XR_SUCCESS) return lost;
    if (!s.session->isAttached || info->countActiveActionSets == 0)
        return wrong(XR_ERROR_ACTIONSET_NOT_ATTACHED, "xrSyncActions: no set is attached");
    if (s.session->state != XR_SESSION_STATE_FOCUSED) return XR_SESSION_NOT_FOCUSED;
    s.session->synced = s.session->predicted;
    return XR_SUCCESS;
}

// The paths of an action that belong to that hand, or to any.
std::vector<std::string> pathsOf(const ActionState& action, const std::string& hand) {
    std::vector<std::string> paths;
    for (const std::string& profile : {state().script.controllers, std::string(kEyesProfile)}) {
        const auto found = action.bindings.find(profile);
        if (found == action.bindings.end()) continue;
        for (const std::string& path : found->second)
            if (hand.empty() || path.starts_with(hand + "/")) paths.push_back(path);
    }
    return paths;
}

std::optional<Hand> handAt(double seconds, const std::string& path) {
    if (!state().script.hand) return std::nullopt;
    return state().script.hand(seconds, path.starts_with(kHands[1]) ? 1 : 0);
}

float valueAt(const Hand& hand, const std::string& path) {
    const auto is = [&](const char* part) { return path.find(part) != std::string::npos; };
    if (is("/input/squeeze/") || is("/input/select/")) return hand.squeeze;
    if (is("/input/trigger/") || is("/input/menu/")) return hand.trigger;
    if (is("/input/trackpad/click")) return hand.isPadPressed ? 1.0f : 0.0f;
    if (is("/input/thumbstick/x") || is("/input/trackpad/x")) return hand.stick;
    return 0.0f;
}

struct Value {
    bool isActive = false;
    float value = 0.0f;
};

Value valueOf(XrAction handle, XrPath hand) {
    State& s = state();
    Value value;
    const auto action = s.actions.find(handle);
    if (action == s.actions.end() || !s.session || s.session->state != XR_SESSION_STATE_FOCUSED) return value;
    for (const std::string& path : pathsOf(*action->second, pathText(hand))) {
        const auto scripted = handAt(secondsOf(s.session->synced), path);
        if (!scripted) continue;
        value.isActive = true;
        const float is = valueAt(*scripted, path);
        if (std::abs(is) > std::abs(value.value)) value.value = is;
    }
    return value;
}

XrResult XRAPI_CALL getFloat(XrSession session, const XrActionStateGetInfo* info, XrActionStateFloat* out) {
    const std::lock_guard lock(state().mutex);
    if (const XrResult lost = enteredSession("xrGetActionStateFloat", session); lost != XR_SUCCESS)
        return lost;
    const auto action = state().actions.find(info->action);
    if (action == state().actions.end() || action->second->type != XR_ACTION_TYPE_FLOAT_INPUT)
        return wrong(XR_ERROR_ACTION_TYPE_MISMATCH, "xrGetActionStateFloat: no float action");
    const Value value = valueOf(info->action, info->subactionPath);
    out->currentState = value.value;
    out->isActive = value.isActive ? XR_TRUE : XR_FALSE;
    out->changedSinceLastSync = XR_FALSE;
    out->lastChangeTime = 0;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL getPose(XrSession session, const XrActionStateGetInfo* info, XrActionStatePose* out) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (const XrResult lost = enteredSession("xrGetActionStatePose", session); lost != XR_SUCCESS)
        return lost;
    SpaceState space;
    space.action = info->action;
    space.hand = info->subactionPath;
    out->isActive =
        s.session->state == XR_SESSION_STATE_FOCUSED && poseOfAction(space, secondsOf(s.session->synced))
            ? XR_TRUE
            : XR_FALSE;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL applyHaptic(XrSession session, const XrHapticActionInfo* info,
                                const XrHapticBaseHeader* haptic) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (const XrResult lost = enteredSession("xrApplyHapticFeedback", session); lost != XR_SUCCESS)
        return lost;
    const auto action = s.actions.find(info->action);
    if (action == s.actions.end() || action->second->type != XR_ACTION_TYPE_VIBRATION_OUTPUT)
        return wrong(XR_ERROR_ACTION_TYPE_MISMATCH, "xrApplyHapticFeedback: no vibration action");
    const auto* vibration = reinterpret_cast<const XrHapticVibration*>(haptic);
    if (!vibration || vibration->type != XR_TYPE_HAPTIC_VIBRATION ||
        !(vibration->amplitude >= 0.0f && vibration->amplitude <= 1.0f) || vibration->duration <= 0)
        return wrong(XR_ERROR_VALIDATION_FAILURE, "xrApplyHapticFeedback: the vibration");
    if (s.session->state != XR_SESSION_STATE_FOCUSED) return XR_SESSION_NOT_FOCUSED;
    const std::string hand = pathText(info->subactionPath);
    if (!pathsOf(*action->second, hand).empty())
        s.record.pulses.push_back(
            {hand == kHands[1] ? 1 : 0, vibration->amplitude, double(vibration->duration) * 1e-6});
    return XR_SUCCESS;
}

}  // namespace

std::optional<Pose> poseOfAction(const SpaceState& space, double seconds) {
    State& s = state();
    const auto action = s.actions.find(space.action);
    if (action == s.actions.end() || !s.session || s.session->state != XR_SESSION_STATE_FOCUSED)
        return std::nullopt;
    for (const std::string& path : pathsOf(*action->second, pathText(space.hand))) {
        if (path == "/user/eyes_ext/input/gaze_ext/pose") {
            if (s.script.gaze) return s.script.gaze(seconds);
            return headAt(seconds);
        }
        const auto hand = handAt(seconds, path);
        if (!hand || !hand->isTracked) continue;
        return path.find("/input/aim/") != std::string::npos ? hand->aim.value_or(hand->pose) : hand->pose;
    }
    return std::nullopt;
}

PFN_xrVoidFunction actionFunction(std::string_view name) {
#define MACULA_XR_IS(xrName, function) \
    if (name == xrName) return reinterpret_cast<PFN_xrVoidFunction>(function)
    MACULA_XR_IS("xrCreateActionSet", createSet);
    MACULA_XR_IS("xrDestroyActionSet", destroySet);
    MACULA_XR_IS("xrCreateAction", createAction);
    MACULA_XR_IS("xrSuggestInteractionProfileBindings", suggest);
    MACULA_XR_IS("xrAttachSessionActionSets", attach);
    MACULA_XR_IS("xrSyncActions", sync);
    MACULA_XR_IS("xrGetActionStateFloat", getFloat);
    MACULA_XR_IS("xrGetActionStatePose", getPose);
    MACULA_XR_IS("xrApplyHapticFeedback", applyHaptic);
#undef MACULA_XR_IS
    return nullptr;
}

}  // namespace macula::xr_script
