// What the scripted runtime knows. One lock around all of it: what an application calls is short.
#pragma once

#include <vulkan/vulkan.h>

#define XR_USE_GRAPHICS_API_VULKAN
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "xr/runtime/script.h"

namespace macula::xr_script {

struct SpaceState {
    enum class Kind { view, local, stage, action } kind = Kind::local;
    Pose offset;
    XrAction action = XR_NULL_HANDLE;
    XrPath hand = XR_NULL_PATH;
};

struct SwapchainState {
    XrSwapchainCreateInfo info{};
    std::vector<VkImage> images;
    std::vector<VkDeviceMemory> memories;
    std::deque<std::uint32_t> acquired;  // in order; the first may be waited for
    bool isWaited = false;               // for the first of these
    std::uint32_t next = 0;
    std::optional<std::uint32_t> released;  // the last one
};

struct ActionState {
    XrActionSet set = XR_NULL_HANDLE;
    XrActionType type = XR_ACTION_TYPE_BOOLEAN_INPUT;
    std::string name;
    std::vector<XrPath> hands;
    std::map<std::string, std::vector<std::string>> bindings;  // of each profile: paths
};

struct SessionState {
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    VkCommandPool pool = VK_NULL_HANDLE;
    XrSessionState state = XR_SESSION_STATE_UNKNOWN;
    bool isRunning = false;
    bool isWaited = false;  // a frame was waited for and not begun
    bool isBegun = false;
    XrTime predicted = 0;
    std::uint64_t frame = 0;
    bool isAttached = false;
    XrTime synced = 0;
    bool isLost = false;
    std::uint64_t slot = 0;     // of a paced one: at which of its times this frame is begun
    std::uint64_t shownAt = 0;  // and at which the one before was shown
    int located = 0;            // how often views were asked for in this frame
    std::optional<std::chrono::steady_clock::time_point> begunAt;  // of a paced one: its first frame
};

struct State {
    std::recursive_mutex mutex;
    Script script;
    Record record;
    bool isScriptSet = false;

    bool hasInstance = false;
    bool isInstanceLost = false;
    bool requirementsAsked = false;
    std::set<std::string> extensions;  // enabled
    VkInstance vulkan = VK_NULL_HANDLE;
    PFN_vkGetInstanceProcAddr vulkanProcAddr = nullptr;
    std::vector<std::string> paths;  // XrPath is index + 1
    std::deque<XrEventDataBuffer> events;
    std::unique_ptr<SessionState> session;
    std::map<XrSpace, std::unique_ptr<SpaceState>> spaces;
    std::map<XrSwapchain, std::unique_ptr<SwapchainState>> swapchains;
    std::set<XrActionSet> sets;
    std::map<XrAction, std::unique_ptr<ActionState>> actions;
    std::uint64_t handles = 0;  // given so far
    std::map<std::string, int> calls;
};

State& state();

template <class Handle>
Handle nextHandle() {
    return reinterpret_cast<Handle>(++state().handles);
}

inline constexpr XrTime kFirstTime = 1'000'000'000;
inline double secondsOf(XrTime time) {
    return double(time - kFirstTime) * 1e-9;
}

// Begins each function: counts the call, and says what a loss answers.
XrResult entered(const char* function);
XrResult enteredSession(const char* function, XrSession session);
XrResult wrong(XrResult result, const std::string& what);  // notes it as a violation

void goTo(XrSessionState to);  // and tells the application
XrSession sessionHandle();
void endSession();  // all that belongs to it is gone
std::string pathText(XrPath path);
std::optional<Pose> poseOfAction(const SpaceState& space, double seconds);
Pose toPose(const XrPosef& pose);
XrPosef fromPose(const Pose& pose);
Pose combined(const Pose& a, const Pose& b);  // b in the frame of a
Pose inverse(const Pose& pose);
Pose headAt(double seconds);
std::optional<Pose> placeOf(const SpaceState& space, double seconds);  // in the stage
// Whether a profile has that control: "/user/hand/left/input/trigger/value".
bool hasControl(const std::string& profile, const std::string& path);
XrResult takeQuad(const XrCompositionLayerQuad& quad, SubmittedFrame& frame);
void destroySwapchainNow(SwapchainState& swapchain);
// What lies in a part of a released image.
std::vector<glm::u8vec4> readImage(const SwapchainState& swapchain, std::uint32_t layer,
                                   const XrRect2Di& rect);
std::vector<float> readDepths(const SwapchainState& swapchain, std::uint32_t layer, const XrRect2Di& rect);
void waitForDevice();  // until all that was submitted is done
std::uint32_t viewCount();
XrViewConfigurationType viewConfiguration();  // the one that this headset is to be used with
bool isDepth(const SwapchainState& swapchain);

// The function of that name, of each part; null where it has none.
PFN_xrVoidFunction instanceFunction(std::string_view name);
PFN_xrVoidFunction vulkanFunction(std::string_view name);
PFN_xrVoidFunction sessionFunction(std::string_view name);
PFN_xrVoidFunction frameFunction(std::string_view name);
PFN_xrVoidFunction swapchainFunction(std::string_view name);
PFN_xrVoidFunction actionFunction(std::string_view name);
PFN_xrVoidFunction maskFunction(std::string_view name);
PFN_xrVoidFunction handFunction(std::string_view name);

}  // namespace macula::xr_script
