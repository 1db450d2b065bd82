// Sessions, their states, and spaces.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

#include "xr/runtime/state.h"

namespace macula::xr_script {

namespace {

// To be looked at: eye-0.ppm, eye-1.ppm and so on into the folder MACULA_XR_PICTURES, of the last frame that
// showed anything.
void writeLastPictures() {
    const char* folder = std::getenv("MACULA_XR_PICTURES");
    const auto& frames = state().record.frames;
    const auto last = std::find_if(frames.rbegin(), frames.rend(),
                                   [](const SubmittedFrame& frame) { return !frame.views.empty(); });
    if (!folder || last == frames.rend()) return;
    for (std::size_t i = 0; i < last->views.size(); ++i) {
        const SubmittedView& view = last->views[i];
        std::ofstream file(std::string(folder) + "/eye-" + std::to_string(i) + ".ppm", std::ios::binary);
        file << "P6 " << view.sizePx.x << " " << view.sizePx.y << " 255\n";
        for (const glm::u8vec4& p : view.rgba) file << char(p.x) << char(p.y) << char(p.z);
    }
}

const XrSession kSession = reinterpret_cast<XrSession>(std::uintptr_t(0x5e55));

XrResult XRAPI_CALL createSession(XrInstance, const XrSessionCreateInfo* info, XrSession* session) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (const XrResult lost = entered("xrCreateSession"); lost != XR_SUCCESS) return lost;
    if (!s.requirementsAsked)
        return wrong(XR_ERROR_GRAPHICS_REQUIREMENTS_CALL_MISSING, "xrCreateSession before the requirements");
    const auto* binding = static_cast<const XrGraphicsBindingVulkan2KHR*>(info->next);
    if (info->type != XR_TYPE_SESSION_CREATE_INFO || !binding ||
        binding->type != XR_TYPE_GRAPHICS_BINDING_VULKAN2_KHR || binding->instance != s.vulkan ||
        !binding->device)
        return wrong(XR_ERROR_GRAPHICS_DEVICE_INVALID, "xrCreateSession: the graphics binding");
    if (s.session) return wrong(XR_ERROR_LIMIT_REACHED, "xrCreateSession: there is one already");
    auto made = std::make_unique<SessionState>();
    made->physical = binding->physicalDevice;
    made->device = binding->device;
    vkGetDeviceQueue(made->device, binding->queueFamilyIndex, binding->queueIndex, &made->queue);
    VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool.queueFamilyIndex = binding->queueFamilyIndex;
    if (vkCreateCommandPool(made->device, &pool, nullptr, &made->pool) != VK_SUCCESS)
        return XR_ERROR_RUNTIME_FAILURE;
    s.session = std::move(made);
    s.record.sessions = 1;
    *session = kSession;
    goTo(XR_SESSION_STATE_IDLE);
    goTo(XR_SESSION_STATE_READY);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL destroySession(XrSession) {
    const std::lock_guard lock(state().mutex);
    if (!state().session) return wrong(XR_ERROR_HANDLE_INVALID, "xrDestroySession: there is none");
    writeLastPictures();
    endSession();
    return XR_SUCCESS;
}

XrResult XRAPI_CALL beginSession(XrSession session, const XrSessionBeginInfo* info) {
    const std::lock_guard lock(state().mutex);
    if (const XrResult lost = enteredSession("xrBeginSession", session); lost != XR_SUCCESS) return lost;
    SessionState& s = *state().session;
    if (s.state != XR_SESSION_STATE_READY)
        return wrong(XR_ERROR_SESSION_NOT_READY, "xrBeginSession: not ready");
    if (s.isRunning) return wrong(XR_ERROR_SESSION_RUNNING, "xrBeginSession: it runs");
    if (info->primaryViewConfigurationType != viewConfiguration())
        return wrong(XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED, "xrBeginSession: the views");
    s.isRunning = true;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL endRunning(XrSession session) {
    const std::lock_guard lock(state().mutex);
    if (const XrResult lost = enteredSession("xrEndSession", session); lost != XR_SUCCESS) return lost;
    SessionState& s = *state().session;
    if (!s.isRunning) return wrong(XR_ERROR_SESSION_NOT_RUNNING, "xrEndSession: it does not run");
    if (s.state != XR_SESSION_STATE_STOPPING)
        return wrong(XR_ERROR_SESSION_NOT_STOPPING, "xrEndSession: it is not stopping");
    s.isRunning = false;
    goTo(XR_SESSION_STATE_IDLE);
    goTo(XR_SESSION_STATE_EXITING);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL requestExit(XrSession session) {
    const std::lock_guard lock(state().mutex);
    if (const XrResult lost = enteredSession("xrRequestExitSession", session); lost != XR_SUCCESS)
        return lost;
    if (!state().session->isRunning)
        return wrong(XR_ERROR_SESSION_NOT_RUNNING, "xrRequestExitSession: it does not run");
    requestEnd();
    return XR_SUCCESS;
}

XrResult XRAPI_CALL enumerateSpaces(XrSession, std::uint32_t capacity, std::uint32_t* count,
                                    XrReferenceSpaceType* types) {
    std::vector<XrReferenceSpaceType> offered{XR_REFERENCE_SPACE_TYPE_VIEW, XR_REFERENCE_SPACE_TYPE_LOCAL};
    if (state().script.hasStage) offered.push_back(XR_REFERENCE_SPACE_TYPE_STAGE);
    *count = std::uint32_t(offered.size());
    if (capacity == 0) return XR_SUCCESS;
    if (capacity < offered.size()) return XR_ERROR_SIZE_INSUFFICIENT;
    std::copy(offered.begin(), offered.end(), types);
    return XR_SUCCESS;
}

XrResult addSpace(SpaceState made, XrSpace* space) {
    *space = nextHandle<XrSpace>();
    state().spaces[*space] = std::make_unique<SpaceState>(std::move(made));
    ++state().record.spaces;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL createReferenceSpace(XrSession session, const XrReferenceSpaceCreateInfo* info,
                                         XrSpace* space) {
    const std::lock_guard lock(state().mutex);
    if (const XrResult lost = enteredSession("xrCreateReferenceSpace", session); lost != XR_SUCCESS)
        return lost;
    SpaceState made;
    made.offset = toPose(info->poseInReferenceSpace);
    if (std::abs(glm::length(made.offset.orientation) - 1.0) > 0.01)
        return wrong(XR_ERROR_POSE_INVALID, "xrCreateReferenceSpace: the pose");
    switch (info->referenceSpaceType) {
        case XR_REFERENCE_SPACE_TYPE_VIEW:
            made.kind = SpaceState::Kind::view;
            break;
        case XR_REFERENCE_SPACE_TYPE_LOCAL:
            made.kind = SpaceState::Kind::local;
            break;
        case XR_REFERENCE_SPACE_TYPE_STAGE:
            if (!state().script.hasStage) return XR_ERROR_REFERENCE_SPACE_UNSUPPORTED;
            made.kind = SpaceState::Kind::stage;
            break;
        default:
            return XR_ERROR_REFERENCE_SPACE_UNSUPPORTED;
    }
    return addSpace(made, space);
}

XrResult XRAPI_CALL createActionSpace(XrSession session, const XrActionSpaceCreateInfo* info,
                                      XrSpace* space) {
    const std::lock_guard lock(state().mutex);
    if (const XrResult lost = enteredSession("xrCreateActionSpace", session); lost != XR_SUCCESS) return lost;
    const auto action = state().actions.find(info->action);
    if (action == state().actions.end() || action->second->type != XR_ACTION_TYPE_POSE_INPUT)
        return wrong(XR_ERROR_ACTION_TYPE_MISMATCH, "xrCreateActionSpace: no pose action");
    SpaceState made;
    made.kind = SpaceState::Kind::action;
    made.offset = toPose(info->poseInActionSpace);
    made.action = info->action;
    made.hand = info->subactionPath;
    return addSpace(made, space);
}

XrResult XRAPI_CALL destroySpace(XrSpace space) {
    const std::lock_guard lock(state().mutex);
    if (state().spaces.erase(space) == 0) return wrong(XR_ERROR_HANDLE_INVALID, "xrDestroySpace");
    --state().record.spaces;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL locateSpace(XrSpace space, XrSpace base, XrTime time, XrSpaceLocation* location) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (const XrResult lost = enteredSession("xrLocateSpace", kSession); lost != XR_SUCCESS) return lost;
    if (!s.spaces.contains(space) || !s.spaces.contains(base))
        return wrong(XR_ERROR_HANDLE_INVALID, "xrLocateSpace: a space that is not there");
    if (time < kFirstTime) return wrong(XR_ERROR_TIME_INVALID, "xrLocateSpace: the time");
    const auto at = placeOf(*s.spaces[space], secondsOf(time));
    const auto from = placeOf(*s.spaces[base], secondsOf(time));
    location->locationFlags = 0;
    location->pose = fromPose({});
    if (!at || !from) return XR_SUCCESS;
    location->pose = fromPose(combined(inverse(*from), *at));
    location->locationFlags = XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT |
                              XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT |
                              XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
    return XR_SUCCESS;
}

}  // namespace

PFN_xrVoidFunction sessionFunction(std::string_view name) {
#define MACULA_XR_IS(xrName, function) \
    if (name == xrName) return reinterpret_cast<PFN_xrVoidFunction>(function)
    MACULA_XR_IS("xrCreateSession", createSession);
    MACULA_XR_IS("xrDestroySession", destroySession);
    MACULA_XR_IS("xrBeginSession", beginSession);
    MACULA_XR_IS("xrEndSession", endRunning);
    MACULA_XR_IS("xrRequestExitSession", requestExit);
    MACULA_XR_IS("xrEnumerateReferenceSpaces", enumerateSpaces);
    MACULA_XR_IS("xrCreateReferenceSpace", createReferenceSpace);
    MACULA_XR_IS("xrCreateActionSpace", createActionSpace);
    MACULA_XR_IS("xrDestroySpace", destroySpace);
    MACULA_XR_IS("xrLocateSpace", locateSpace);
#undef MACULA_XR_IS
    return nullptr;
}

XrResult enteredSession(const char* function, XrSession session) {
    if (const XrResult lost = entered(function); lost != XR_SUCCESS) return lost;
    if (!state().session || session != kSession)
        return wrong(XR_ERROR_HANDLE_INVALID, std::string(function) + ": no session");
    return state().session->isLost ? XR_ERROR_SESSION_LOST : XR_SUCCESS;
}

void goTo(XrSessionState to) {
    State& s = state();
    if (!s.session || s.session->state == to) return;
    s.session->state = to;
    XrEventDataBuffer buffer{XR_TYPE_EVENT_DATA_BUFFER};
    XrEventDataSessionStateChanged event{XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED};
    event.session = kSession;
    event.state = to;
    event.time = s.session->predicted;
    std::memcpy(&buffer, &event, sizeof(event));
    s.events.push_back(buffer);
}

XrSession sessionHandle() {
    return kSession;
}

void requestEnd() {
    const std::lock_guard lock(state().mutex);
    goTo(XR_SESSION_STATE_STOPPING);
}

void recentre(double inSeconds) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (!s.session) return;
    XrEventDataBuffer buffer{XR_TYPE_EVENT_DATA_BUFFER};
    XrEventDataReferenceSpaceChangePending event{XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING};
    event.session = kSession;
    event.referenceSpaceType =
        s.script.hasStage ? XR_REFERENCE_SPACE_TYPE_STAGE : XR_REFERENCE_SPACE_TYPE_LOCAL;
    event.changeTime = s.session->predicted + XrTime(inSeconds * 1e9);
    event.poseInPreviousSpace = fromPose({});
    std::memcpy(&buffer, &event, sizeof(event));
    s.events.push_back(buffer);
}

void endSession() {
    State& s = state();
    if (!s.session) return;
    for (auto& [handle, swapchain] : s.swapchains) destroySwapchainNow(*swapchain);
    s.swapchains.clear();
    s.spaces.clear();
    vkDestroyCommandPool(s.session->device, s.session->pool, nullptr);
    s.session.reset();
    s.events.clear();
    s.record.sessions = 0;
    s.record.swapchains = 0;
    s.record.spaces = 0;
    s.record.handTrackers = 0;
}

Pose toPose(const XrPosef& pose) {
    return {{pose.position.x, pose.position.y, pose.position.z},
            glm::dquat(pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z)};
}

XrPosef fromPose(const Pose& pose) {
    const glm::quat q(pose.orientation);
    const glm::vec3 p(pose.positionM);
    return {{q.x, q.y, q.z, q.w}, {p.x, p.y, p.z}};
}

Pose combined(const Pose& a, const Pose& b) {
    return {a.positionM + a.orientation * b.positionM, a.orientation * b.orientation};
}

Pose inverse(const Pose& pose) {
    const glm::dquat back = glm::inverse(pose.orientation);
    return {-(back * pose.positionM), back};
}

Pose headAt(double seconds) {
    const auto& head = state().script.head;
    return head ? head(seconds) : Pose{{0.0, 1.6, 0.0}, glm::dquat(1.0, 0.0, 0.0, 0.0)};
}

std::optional<Pose> placeOf(const SpaceState& space, double seconds) {
    switch (space.kind) {
        case SpaceState::Kind::view:
            return combined(headAt(seconds), space.offset);
        case SpaceState::Kind::local:  // at the height of the eyes
            return combined({{0.0, 1.6, 0.0}, glm::dquat(1.0, 0.0, 0.0, 0.0)}, space.offset);
        case SpaceState::Kind::stage:
            return space.offset;
        case SpaceState::Kind::action: {
            const auto pose = poseOfAction(space, seconds);
            return pose ? std::optional(combined(*pose, space.offset)) : std::nullopt;
        }
    }
    return std::nullopt;
}

}  // namespace macula::xr_script
