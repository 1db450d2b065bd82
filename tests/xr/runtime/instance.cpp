// The loader's way in, the instance, the headset and events.
#include <cstdlib>
#include <cstring>
#include <utility>

#include "xr/runtime/state.h"

// As in the OpenXR loader's own documentation ("Loader Design"); libopenxr-dev has no header for it.
extern "C" {
struct XrNegotiateLoaderInfo {
    std::uint32_t structType;  // 1
    std::uint32_t structVersion;
    std::size_t structSize;
    std::uint32_t minInterfaceVersion;
    std::uint32_t maxInterfaceVersion;
    XrVersion minApiVersion;
    XrVersion maxApiVersion;
};
struct XrNegotiateRuntimeRequest {
    std::uint32_t structType;  // 3
    std::uint32_t structVersion;
    std::size_t structSize;
    std::uint32_t runtimeInterfaceVersion;
    XrVersion runtimeApiVersion;
    PFN_xrGetInstanceProcAddr getInstanceProcAddr;
};
}

namespace macula::xr_script {

namespace {

constexpr XrSystemId kSystem = 1;

void followEnvironment(Script& script) {
    const char* value = std::getenv("MACULA_XR_SCRIPT");
    const std::string words = value ? "," + std::string(value) + "," : "";
    const auto says = [&](const char* word) {
        return words.find("," + std::string(word) + ",") != std::string::npos;
    };
    script.hasHeadset = script.hasHeadset && !says("no-headset");
    script.offersVulkan2 = script.offersVulkan2 && !says("no-vulkan2");
    script.needsNewerVulkan = script.needsNewerVulkan || says("newer-vulkan");
    script.offersGaze = script.offersGaze && !says("no-gaze");
    script.takesLayers = script.takesLayers && !says("no-layers");
    script.offersDepth = script.offersDepth || says("depth");
    script.offersInsets = script.offersInsets || says("insets");
    script.isPaced = script.isPaced || says("paced");
    script.keepsPictures = script.keepsPictures && !says("no-pictures");
    if (says("room")) script.blendModes = {1, 3};
    if (says("see-through")) script.blendModes = {2};
    if (says("mask")) {
        script.offersMask = true;
        script.hidden = {{-1.0, 1.0}, {-0.3, 1.0}, {-1.0, 0.3}};
    }
    const auto after = [&](const char* word) {
        const std::size_t at = words.find("," + std::string(word) + "=");
        return at == std::string::npos ? std::string() : words.substr(words.find('=', at) + 1);
    };
    double rate = 0.0;
    if (std::sscanf(after("rate").c_str(), "%lf", &rate) == 1 && rate > 0.0) script.framesPerS = rate;
    glm::uvec2 eyePx(0);
    if (std::sscanf(after("eye").c_str(), "%ux%u", &eyePx.x, &eyePx.y) == 2) script.eyePx = eyePx;
}

std::vector<const char*> offeredExtensions() {
    std::vector<const char*> names;
    if (state().script.offersVulkan2) names.push_back(XR_KHR_VULKAN_ENABLE2_EXTENSION_NAME);
    if (state().script.offersGaze) names.push_back(XR_EXT_EYE_GAZE_INTERACTION_EXTENSION_NAME);
    if (state().script.offersDepth) names.push_back(XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME);
    if (state().script.offersMask) names.push_back(XR_KHR_VISIBILITY_MASK_EXTENSION_NAME);
    if (state().script.offersInsets) names.push_back(XR_VARJO_QUAD_VIEWS_EXTENSION_NAME);
    if (state().script.offersHands) names.push_back(XR_EXT_HAND_TRACKING_EXTENSION_NAME);
    if (state().script.offersReverb) names.push_back(XR_EXT_HP_MIXED_REALITY_CONTROLLER_EXTENSION_NAME);
    return names;
}

void copyText(char* to, std::size_t size, const std::string& text) {
    std::snprintf(to, size, "%s", text.c_str());
}

XrResult XRAPI_CALL enumerateExtensions(const char* layer, std::uint32_t capacity, std::uint32_t* count,
                                        XrExtensionProperties* properties) {
    const std::lock_guard lock(state().mutex);
    if (layer) return XR_ERROR_API_LAYER_NOT_PRESENT;
    if (!state().isScriptSet) followEnvironment(state().script);
    const auto names = offeredExtensions();
    *count = std::uint32_t(names.size());
    if (capacity == 0) return XR_SUCCESS;
    if (capacity < names.size()) return XR_ERROR_SIZE_INSUFFICIENT;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (properties[i].type != XR_TYPE_EXTENSION_PROPERTIES)
            return wrong(XR_ERROR_VALIDATION_FAILURE, "xrEnumerateInstanceExtensionProperties: type");
        copyText(properties[i].extensionName, XR_MAX_EXTENSION_NAME_SIZE, names[i]);
        properties[i].extensionVersion = 1;
    }
    return XR_SUCCESS;
}

XrResult XRAPI_CALL createInstance(const XrInstanceCreateInfo* info, XrInstance* instance) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (!s.isScriptSet) followEnvironment(s.script);
    if (info->type != XR_TYPE_INSTANCE_CREATE_INFO)
        return wrong(XR_ERROR_VALIDATION_FAILURE, "xrCreateInstance: type");
    if (s.hasInstance) return wrong(XR_ERROR_LIMIT_REACHED, "xrCreateInstance: there is one already");
    if (XR_VERSION_MAJOR(info->applicationInfo.apiVersion) != 1 ||
        XR_VERSION_MINOR(info->applicationInfo.apiVersion) != 0)
        return wrong(XR_ERROR_API_VERSION_UNSUPPORTED, "xrCreateInstance: a version that is not 1.0");
    s.extensions.clear();
    for (std::uint32_t i = 0; i < info->enabledExtensionCount; ++i) {
        bool isOffered = false;
        for (const char* name : offeredExtensions())
            isOffered = isOffered || std::strcmp(name, info->enabledExtensionNames[i]) == 0;
        if (!isOffered) return XR_ERROR_EXTENSION_NOT_PRESENT;
        s.extensions.insert(info->enabledExtensionNames[i]);
    }
    s.hasInstance = true;
    s.isInstanceLost = false;
    s.requirementsAsked = false;
    s.paths.clear();
    s.events.clear();
    s.record.instances = 1;
    *instance = nextHandle<XrInstance>();
    return XR_SUCCESS;
}

XrResult XRAPI_CALL destroyInstance(XrInstance) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (!s.hasInstance) return wrong(XR_ERROR_HANDLE_INVALID, "xrDestroyInstance: there is none");
    endSession();
    s.sets.clear();
    s.record.actionSets = 0;
    s.actions.clear();
    s.hasInstance = false;
    s.record.instances = 0;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL getInstanceProperties(XrInstance, XrInstanceProperties* properties) {
    const std::lock_guard lock(state().mutex);
    properties->runtimeVersion = XR_MAKE_VERSION(1, 2, 3);
    copyText(properties->runtimeName, XR_MAX_RUNTIME_NAME_SIZE, "Scripted runtime");
    return XR_SUCCESS;
}

XrResult XRAPI_CALL getSystem(XrInstance, const XrSystemGetInfo* info, XrSystemId* system) {
    const std::lock_guard lock(state().mutex);
    if (const XrResult lost = entered("xrGetSystem"); lost != XR_SUCCESS) return lost;
    if (info->formFactor != XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY) return XR_ERROR_FORM_FACTOR_UNSUPPORTED;
    if (!state().script.hasHeadset) return XR_ERROR_FORM_FACTOR_UNAVAILABLE;
    *system = kSystem;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL getSystemProperties(XrInstance, XrSystemId system, XrSystemProperties* properties) {
    const std::lock_guard lock(state().mutex);
    if (system != kSystem) return wrong(XR_ERROR_SYSTEM_INVALID, "xrGetSystemProperties: the system");
    properties->systemId = kSystem;
    properties->vendorId = 1;
    copyText(properties->systemName, XR_MAX_SYSTEM_NAME_SIZE, "Scripted headset");
    properties->graphicsProperties = {4096, 4096, 16};
    properties->trackingProperties = {XR_TRUE, XR_TRUE};
    for (auto* next = static_cast<XrBaseOutStructure*>(properties->next); next; next = next->next) {
        if (next->type == XR_TYPE_SYSTEM_HAND_TRACKING_PROPERTIES_EXT)
            reinterpret_cast<XrSystemHandTrackingPropertiesEXT*>(next)->supportsHandTracking =
                state().script.offersHands ? XR_TRUE : XR_FALSE;
        if (next->type == XR_TYPE_SYSTEM_EYE_GAZE_INTERACTION_PROPERTIES_EXT)
            reinterpret_cast<XrSystemEyeGazeInteractionPropertiesEXT*>(next)->supportsEyeGazeInteraction =
                state().script.offersGaze ? XR_TRUE : XR_FALSE;
    }
    return XR_SUCCESS;
}

XrResult XRAPI_CALL enumerateViews(XrInstance, XrSystemId, XrViewConfigurationType type,
                                   std::uint32_t capacity, std::uint32_t* count,
                                   XrViewConfigurationView* views) {
    const std::lock_guard lock(state().mutex);
    if (type != viewConfiguration())
        return wrong(XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED, "xrEnumerateViewConfigurationViews: type");
    *count = viewCount();
    if (capacity == 0) return XR_SUCCESS;
    if (capacity < *count) return XR_ERROR_SIZE_INSUFFICIENT;
    for (std::uint32_t i = 0; i < *count; ++i) {
        const glm::uvec2 size = i < 2 ? state().script.eyePx : state().script.insetPx;
        if (views[i].type != XR_TYPE_VIEW_CONFIGURATION_VIEW)
            return wrong(XR_ERROR_VALIDATION_FAILURE, "xrEnumerateViewConfigurationViews: type");
        views[i].recommendedImageRectWidth = size.x;
        views[i].maxImageRectWidth = 4096;
        views[i].recommendedImageRectHeight = size.y;
        views[i].maxImageRectHeight = 4096;
        views[i].recommendedSwapchainSampleCount = 1;
        views[i].maxSwapchainSampleCount = 1;
    }
    return XR_SUCCESS;
}

XrResult XRAPI_CALL enumerateConfigurations(XrInstance, XrSystemId, std::uint32_t capacity,
                                            std::uint32_t* count, XrViewConfigurationType* types) {
    const std::lock_guard lock(state().mutex);
    *count = state().script.offersInsets ? 2 : 1;
    if (capacity == 0) return XR_SUCCESS;
    if (capacity < *count) return XR_ERROR_SIZE_INSUFFICIENT;
    types[0] = viewConfiguration();
    if (*count > 1) types[1] = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL enumerateBlendModes(XrInstance, XrSystemId, XrViewConfigurationType,
                                        std::uint32_t capacity, std::uint32_t* count,
                                        XrEnvironmentBlendMode* modes) {
    const std::lock_guard lock(state().mutex);
    const std::vector<int>& offered = state().script.blendModes;
    *count = std::uint32_t(offered.size());
    if (capacity == 0) return XR_SUCCESS;
    if (capacity < *count) return XR_ERROR_SIZE_INSUFFICIENT;
    for (std::size_t i = 0; i < offered.size(); ++i) modes[i] = XrEnvironmentBlendMode(offered[i]);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL pollEvent(XrInstance, XrEventDataBuffer* event) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (const XrResult lost = entered("xrPollEvent"); lost != XR_SUCCESS) return lost;
    if (event->type != XR_TYPE_EVENT_DATA_BUFFER)
        return wrong(XR_ERROR_VALIDATION_FAILURE, "xrPollEvent: type");
    if (s.events.empty()) return XR_EVENT_UNAVAILABLE;
    *event = s.events.front();
    s.events.pop_front();
    return XR_SUCCESS;
}

XrResult XRAPI_CALL stringToPath(XrInstance, const char* text, XrPath* path) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (text[0] != '/') return wrong(XR_ERROR_PATH_FORMAT_INVALID, "xrStringToPath: " + std::string(text));
    for (std::size_t i = 0; i < s.paths.size(); ++i)
        if (s.paths[i] == text) return *path = XrPath(i + 1), XR_SUCCESS;
    s.paths.emplace_back(text);
    *path = XrPath(s.paths.size());
    return XR_SUCCESS;
}

XrResult XRAPI_CALL resultToString(XrInstance, XrResult value, char* text) {
    copyText(text, XR_MAX_RESULT_STRING_SIZE, "XR_RESULT_" + std::to_string(int(value)));
    return XR_SUCCESS;
}

XrResult XRAPI_CALL getInstanceProcAddr(XrInstance, const char* name, PFN_xrVoidFunction* function) {
    using Part = PFN_xrVoidFunction (*)(std::string_view);
    constexpr Part kParts[] = {instanceFunction,  vulkanFunction, sessionFunction, frameFunction,
                               swapchainFunction, actionFunction, maskFunction,    handFunction};
    {
        const std::lock_guard lock(state().mutex);
        if (state().script.lacks == name) return XR_ERROR_FUNCTION_UNSUPPORTED;
    }
    for (const Part part : kParts)
        if ((*function = part(name))) return XR_SUCCESS;
    return XR_ERROR_FUNCTION_UNSUPPORTED;
}

}  // namespace

PFN_xrVoidFunction instanceFunction(std::string_view name) {
#define MACULA_XR_IS(xrName, function) \
    if (name == xrName) return reinterpret_cast<PFN_xrVoidFunction>(function)
    MACULA_XR_IS("xrGetInstanceProcAddr", getInstanceProcAddr);
    MACULA_XR_IS("xrEnumerateInstanceExtensionProperties", enumerateExtensions);
    MACULA_XR_IS("xrCreateInstance", createInstance);
    MACULA_XR_IS("xrDestroyInstance", destroyInstance);
    MACULA_XR_IS("xrGetInstanceProperties", getInstanceProperties);
    MACULA_XR_IS("xrGetSystem", getSystem);
    MACULA_XR_IS("xrGetSystemProperties", getSystemProperties);
    MACULA_XR_IS("xrEnumerateViewConfigurations", enumerateConfigurations);
    MACULA_XR_IS("xrEnumerateViewConfigurationViews", enumerateViews);
    MACULA_XR_IS("xrEnumerateEnvironmentBlendModes", enumerateBlendModes);
    MACULA_XR_IS("xrPollEvent", pollEvent);
    MACULA_XR_IS("xrStringToPath", stringToPath);
    MACULA_XR_IS("xrResultToString", resultToString);
#undef MACULA_XR_IS
    return nullptr;
}

State& state() {
    static State state;
    return state;
}

XrResult wrong(XrResult result, const std::string& what) {
    state().record.violations.push_back(what);
    return result;
}

XrResult entered(const char* function) {
    State& s = state();
    if (!s.hasInstance) return wrong(XR_ERROR_HANDLE_INVALID, std::string(function) + ": no instance");
    if (s.isInstanceLost) return XR_ERROR_INSTANCE_LOST;
    if (s.script.loseAt == function && ++s.calls[function] == s.script.loseNth) {
        const auto answer = XrResult(s.script.answer);
        if (answer == XR_ERROR_INSTANCE_LOST) s.isInstanceLost = true;
        if (s.session) s.session->isLost = true;
        return answer;
    }
    return XR_SUCCESS;
}

// Extensions count once they are enabled.
std::uint32_t viewCount() {
    return viewConfiguration() == XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO ? 2 : 4;
}

XrViewConfigurationType viewConfiguration() {
    return state().extensions.contains(XR_VARJO_QUAD_VIEWS_EXTENSION_NAME)
               ? XR_VIEW_CONFIGURATION_TYPE_PRIMARY_QUAD_VARJO
               : XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
}

std::string pathText(XrPath path) {
    const auto& paths = state().paths;
    return path >= 1 && path <= paths.size() ? paths[path - 1] : std::string();
}

void follow(Script script) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    s.script = std::move(script);
    s.isScriptSet = true;
    s.calls.clear();
    const Record before = std::exchange(s.record, {});
    s.record.instances = before.instances;
    s.record.sessions = before.sessions;
    s.record.swapchains = before.swapchains;
    s.record.spaces = before.spaces;
    s.record.actionSets = before.actionSets;
    s.record.handTrackers = before.handTrackers;
}

Record record() {
    const std::lock_guard lock(state().mutex);
    return state().record;
}

}  // namespace macula::xr_script

extern "C" MACULA_XR_SCRIPT_EXPORT XrResult
xrNegotiateLoaderRuntimeInterface(const XrNegotiateLoaderInfo* loader, XrNegotiateRuntimeRequest* request) {
    if (!loader || !request || loader->structType != 1 || request->structType != 3 ||
        loader->minInterfaceVersion > 1 || loader->maxInterfaceVersion < 1)
        return XR_ERROR_INITIALIZATION_FAILED;
    request->runtimeInterfaceVersion = 1;
    request->runtimeApiVersion = XR_MAKE_VERSION(1, 0, 20);
    request->getInstanceProcAddr = &macula::xr_script::getInstanceProcAddr;
    return XR_SUCCESS;
}
