#include "xr/runtime.h"

#include <fmt/format.h>
#include <vulkan/vulkan.h>

#include <dlfcn.h>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "live/device/open_device.h"
#include "xr/xr_error.h"

namespace macula::xr {

namespace {

Error brokenRuntime() {
    return {ErrorCode::deviceNotUsable,
            Text("The software of the headset does not answer as OpenXR 1.0 demands."), "",
            Text("Update or reinstall it.")};
}

template <class Function>
bool findOne(const Loader& loader, XrInstance instance, const char* name, Function& function) {
    PFN_xrVoidFunction found = nullptr;
    if (loader.getInstanceProcAddr(instance, name, &found) != XR_SUCCESS) return false;
    function = reinterpret_cast<Function>(found);
    return function != nullptr;
}

// If a person has chosen a runtime, it exists but does not work.
Error noRuntime() {
    const char* chosen = std::getenv("XR_RUNTIME_JSON");
    if (chosen && *chosen)
        return {ErrorCode::deviceNotUsable,
                Text("The OpenXR runtime that XR_RUNTIME_JSON names cannot be loaded."), chosen,
                Text("Correct or unset XR_RUNTIME_JSON.")};
    return xrError(XR_ERROR_RUNTIME_UNAVAILABLE, Text("answer"));
}

Result<std::vector<std::string>> extensionsOf(const Loader& loader) {
    std::uint32_t count = 0;
    const XrResult asked = loader.enumerateExtensions(nullptr, 0, &count, nullptr);
    if (asked == XR_ERROR_RUNTIME_UNAVAILABLE || asked == XR_ERROR_FILE_ACCESS_ERROR ||
        asked == XR_ERROR_FILE_CONTENTS_INVALID || asked == XR_ERROR_INSTANCE_LOST)
        return noRuntime();
    MACULA_XR_TRY(asked, Text("tell what it offers"));
    std::vector<XrExtensionProperties> properties(count, {XR_TYPE_EXTENSION_PROPERTIES});
    MACULA_XR_TRY(loader.enumerateExtensions(nullptr, count, &count, properties.data()),
                  Text("tell what it offers"));
    std::vector<std::string> names;
    for (const XrExtensionProperties& property : properties) names.emplace_back(property.extensionName);
    return names;
}

// Extensions that Macula uses if the runtime offers them.
constexpr const char* kOptional[] = {
    XR_EXT_EYE_GAZE_INTERACTION_EXTENSION_NAME, XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME,
    XR_KHR_VISIBILITY_MASK_EXTENSION_NAME,      XR_VARJO_QUAD_VIEWS_EXTENSION_NAME,
    XR_EXT_HAND_TRACKING_EXTENSION_NAME,        XR_EXT_HP_MIXED_REALITY_CONTROLLER_EXTENSION_NAME};

bool contains(const std::vector<std::string>& names, const char* wanted) {
    return std::find(names.begin(), names.end(), wanted) != names.end();
}

std::string versionText(XrVersion version) {
    return fmt::format("{}.{}.{}", XR_VERSION_MAJOR(version), XR_VERSION_MINOR(version),
                       XR_VERSION_PATCH(version));
}

}  // namespace

Result<Loader> Loader::open(const char* library) {
    // Silences the loader: Macula reports its errors itself.
    setenv("XR_LOADER_DEBUG", "none", 0);
    void* opened = dlopen(library, RTLD_NOW | RTLD_LOCAL);
    Loader loader;
    if (opened)
        loader.getInstanceProcAddr =
            reinterpret_cast<PFN_xrGetInstanceProcAddr>(dlsym(opened, "xrGetInstanceProcAddr"));
    if (!loader.getInstanceProcAddr ||
        !findOne(loader, XR_NULL_HANDLE, "xrEnumerateInstanceExtensionProperties",
                 loader.enumerateExtensions) ||
        !findOne(loader, XR_NULL_HANDLE, "xrCreateInstance", loader.createInstance))
        return Error{ErrorCode::deviceNotUsable,
                     Text("The OpenXR loader is not installed, so no headset can be found."), "",
                     Text("Install it (Debian/Ubuntu: sudo apt install libopenxr-loader1).")};
    return loader;
}

Result<void> Loader::find(XrInstance instance, Functions& functions) const {
    bool hasAll = true;
#define MACULA_XR_FUNCTION(name) hasAll = findOne(*this, instance, "xr" #name, functions.name) && hasAll;
#include "xr/functions.inl"
#undef MACULA_XR_FUNCTION
    return hasAll ? Result<void>() : brokenRuntime();
}

Result<std::shared_ptr<Runtime>> Runtime::connect(const char* loaderLibrary) {
    std::shared_ptr<Runtime> runtime(new Runtime());
    MACULA_TRY(runtime->loader_, Loader::open(loaderLibrary));
    MACULA_TRY(runtime->offer_.extensions, extensionsOf(runtime->loader_));
    if (!contains(runtime->offer_.extensions, XR_KHR_VULKAN_ENABLE2_EXTENSION_NAME))
        return Error{ErrorCode::deviceNotUsable,
                     Text("The software of the headset cannot show pictures made with Vulkan "
                          "(XR_KHR_vulkan_enable2)."),
                     "", Text("Update it, or use another OpenXR runtime.")};
    std::vector<const char*> extensions{XR_KHR_VULKAN_ENABLE2_EXTENSION_NAME};
    for (const char* name : kOptional)
        if (runtime->isOn(name)) extensions.push_back(name);

    XrInstanceCreateInfo info{XR_TYPE_INSTANCE_CREATE_INFO};
    std::snprintf(info.applicationInfo.applicationName, XR_MAX_APPLICATION_NAME_SIZE, "Macula");
    std::snprintf(info.applicationInfo.engineName, XR_MAX_ENGINE_NAME_SIZE, "Macula");
    info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0);
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.enabledExtensionNames = extensions.data();
    const XrResult created = runtime->loader_.createInstance(&info, &runtime->instance_);
    if (created == XR_ERROR_RUNTIME_UNAVAILABLE) return noRuntime();
    MACULA_XR_TRY(created, Text("be reached through its software"));
    MACULA_TRY_VOID(runtime->loader_.find(runtime->instance_, runtime->call_));
    if (runtime->isOn(XR_KHR_VISIBILITY_MASK_EXTENSION_NAME))
        runtime->call_.GetVisibilityMaskKHR =
            reinterpret_cast<PFN_xrGetVisibilityMaskKHR>(runtime->function("xrGetVisibilityMaskKHR"));

    XrInstanceProperties properties{XR_TYPE_INSTANCE_PROPERTIES};
    MACULA_XR_TRY(runtime->call_.GetInstanceProperties(runtime->instance_, &properties),
                  Text("tell the name of its software"));
    runtime->offer_.runtime =
        fmt::format("{} {}", properties.runtimeName, versionText(properties.runtimeVersion));
    return runtime;
}

Runtime::~Runtime() {
    if (instance_ && call_.DestroyInstance) call_.DestroyInstance(instance_);
}

Result<void> Runtime::findHeadset() {
    XrSystemGetInfo info{XR_TYPE_SYSTEM_GET_INFO};
    info.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
    MACULA_XR_TRY(call_.GetSystem(instance_, &info, &system_), Text("be found"));
    XrSystemEyeGazeInteractionPropertiesEXT gaze{XR_TYPE_SYSTEM_EYE_GAZE_INTERACTION_PROPERTIES_EXT};
    XrSystemProperties properties{XR_TYPE_SYSTEM_PROPERTIES};
    const bool mayFollowEyes = isOn(XR_EXT_EYE_GAZE_INTERACTION_EXTENSION_NAME);
    if (mayFollowEyes) properties.next = &gaze;
    MACULA_XR_TRY(call_.GetSystemProperties(instance_, system_, &properties), Text("tell its name"));
    offer_.headset = properties.systemName;
    offer_.hasGaze = mayFollowEyes && gaze.supportsEyeGazeInteraction == XR_TRUE;
    offer_.takesDepth = isOn(XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME);
    offer_.hasMask = isOn(XR_KHR_VISIBILITY_MASK_EXTENSION_NAME) && call_.GetVisibilityMaskKHR != nullptr;
    MACULA_TRY_VOID(askForViews());
    return askForBlendModes();
}

bool Runtime::isOn(const char* extension) const {
    return contains(offer_.extensions, extension);
}

XrViewConfigurationType Runtime::viewConfiguration() const {
    return offer_.hasInsets ? XR_VIEW_CONFIGURATION_TYPE_PRIMARY_QUAD_VARJO
                            : XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
}

Result<void> Runtime::askForViews() {
    std::uint32_t count = 0;
    MACULA_XR_TRY(call_.EnumerateViewConfigurations(instance_, system_, 0, &count, nullptr),
                  Text("show a picture to each eye"));
    std::vector<XrViewConfigurationType> types(count);
    MACULA_XR_TRY(call_.EnumerateViewConfigurations(instance_, system_, count, &count, types.data()),
                  Text("show a picture to each eye"));
    offer_.hasInsets =
        isOn(XR_VARJO_QUAD_VIEWS_EXTENSION_NAME) &&
        std::find(types.begin(), types.end(), XR_VIEW_CONFIGURATION_TYPE_PRIMARY_QUAD_VARJO) != types.end();
    std::vector<XrViewConfigurationView> views(viewCount(), {XR_TYPE_VIEW_CONFIGURATION_VIEW});
    MACULA_XR_TRY(call_.EnumerateViewConfigurationViews(instance_, system_, viewConfiguration(), viewCount(),
                                                        &count, views.data()),
                  Text("show a picture to each eye"));
    offer_.eyePx = offer_.insetPx = {0, 0};
    for (std::size_t i = 0; i < views.size(); ++i) {
        glm::ivec2& sizePx = i < 2 ? offer_.eyePx : offer_.insetPx;
        sizePx.x = std::max(sizePx.x, static_cast<int>(views[i].recommendedImageRectWidth));
        sizePx.y = std::max(sizePx.y, static_cast<int>(views[i].recommendedImageRectHeight));
    }
    const auto isPicture = [](const glm::ivec2& sizePx) { return sizePx.x >= 2 && sizePx.y >= 2; };
    if (count != viewCount() || !isPicture(offer_.eyePx) || (offer_.hasInsets && !isPicture(offer_.insetPx)))
        return Error{ErrorCode::deviceNotUsable, Text("The headset does not say how large its pictures are."),
                     "", Text("Update the software of the headset.")};
    return {};
}

Result<void> Runtime::askForBlendModes() {
    std::uint32_t count = 0;
    MACULA_XR_TRY(
        call_.EnumerateEnvironmentBlendModes(instance_, system_, viewConfiguration(), 0, &count, nullptr),
        Text("tell how it shows pictures"));
    blendModes_.resize(count);
    MACULA_XR_TRY(call_.EnumerateEnvironmentBlendModes(instance_, system_, viewConfiguration(), count, &count,
                                                       blendModes_.data()),
                  Text("tell how it shows pictures"));
    const auto offers = [&](XrEnvironmentBlendMode mode) {
        return std::find(blendModes_.begin(), blendModes_.end(), mode) != blendModes_.end();
    };
    offer_.showsRoom =
        offers(XR_ENVIRONMENT_BLEND_MODE_ALPHA_BLEND) || offers(XR_ENVIRONMENT_BLEND_MODE_ADDITIVE);
    offer_.isSeeThrough = offer_.showsRoom && !offers(XR_ENVIRONMENT_BLEND_MODE_OPAQUE);
    return {};
}

Result<XrPath> Runtime::path(const std::string& text) const {
    XrPath path = XR_NULL_PATH;
    MACULA_XR_TRY(call_.StringToPath(instance_, text.c_str(), &path), Text("name its controls"));
    return path;
}

PFN_xrVoidFunction Runtime::function(const char* name) const {
    PFN_xrVoidFunction found = nullptr;
    return loader_.getInstanceProcAddr(instance_, name, &found) == XR_SUCCESS ? found : nullptr;
}

Check checkHeadset(const char* loaderLibrary) {
    const auto runtime = Runtime::connect(loaderLibrary);
    if (!runtime) return {.offer = {}, .missing = runtime.error()};
    const Result<void> found = (*runtime)->findHeadset();
    Check check{.offer = (*runtime)->offer(), .missing = {}};
    if (!found) {
        check.missing = found.error();
    } else if (const auto device = openDevice(**runtime, gpu::Validation::off, false); !device) {
        check.missing = device.error();
    }
    return check;
}

Result<HeadsetDevice> openDevice(const Runtime& runtime, gpu::Validation validation, bool isAnnounced) {
    const Functions& call = runtime.call();
    XrGraphicsRequirementsVulkan2KHR needs{XR_TYPE_GRAPHICS_REQUIREMENTS_VULKAN2_KHR};
    MACULA_XR_TRY(call.GetVulkanGraphicsRequirements2KHR(runtime.instance(), runtime.system(), &needs),
                  Text("tell which Vulkan it needs"));
    // The highest version tested with a runtime is not a limit: Vulkan 1.3 includes 1.1.
    if (needs.minApiVersionSupported > XR_MAKE_VERSION(1, 3, 0xffff))
        return Error{ErrorCode::deviceNotUsable, Text("The headset needs another version of Vulkan."), "",
                     Text("Update the software of the headset.")};

    XrResult answer = XR_SUCCESS;
    const auto asVulkan = [&answer](XrResult result, VkResult vulkan) {
        answer = result;
        return XR_FAILED(result) ? VK_ERROR_INITIALIZATION_FAILED : vulkan;
    };
    auto instance = gpu::Instance::create(
        {.extensions = {},
         .validation = validation,
         .createInstance = [&](const VkInstanceCreateInfo& info, VkInstance* made) {
             XrVulkanInstanceCreateInfoKHR wanted{XR_TYPE_VULKAN_INSTANCE_CREATE_INFO_KHR};
             wanted.systemId = runtime.system();
             wanted.pfnGetInstanceProcAddr = &vkGetInstanceProcAddr;
             wanted.vulkanCreateInfo = &info;
             VkResult vulkan = VK_SUCCESS;
             return asVulkan(call.CreateVulkanInstanceKHR(runtime.instance(), &wanted, made, &vulkan),
                             vulkan);
         }});
    if (XR_FAILED(answer)) return xrError(answer, Text("start Vulkan"));
    if (!instance) return instance.error();

    gpu::DeviceOptions options = live::deviceOptions({});
    options.isAnnounced = isAnnounced;
    XrVulkanGraphicsDeviceGetInfoKHR which{XR_TYPE_VULKAN_GRAPHICS_DEVICE_GET_INFO_KHR};
    which.systemId = runtime.system();
    which.vulkanInstance = instance->handle();
    MACULA_XR_TRY(call.GetVulkanGraphicsDevice2KHR(runtime.instance(), &which, &options.physical),
                  Text("tell which graphics device it is connected to"));
    options.createDevice = [&](VkPhysicalDevice physical, const VkDeviceCreateInfo& info, VkDevice* made) {
        XrVulkanDeviceCreateInfoKHR wanted{XR_TYPE_VULKAN_DEVICE_CREATE_INFO_KHR};
        wanted.systemId = runtime.system();
        wanted.pfnGetInstanceProcAddr = &vkGetInstanceProcAddr;
        wanted.vulkanPhysicalDevice = physical;
        wanted.vulkanCreateInfo = &info;
        VkResult vulkan = VK_SUCCESS;
        return asVulkan(call.CreateVulkanDeviceKHR(runtime.instance(), &wanted, made, &vulkan), vulkan);
    };
    auto device = gpu::Device::create(*instance, options);
    if (XR_FAILED(answer)) return xrError(answer, Text("open its graphics device"));
    if (!device) return device.error();
    return HeadsetDevice{std::move(*instance), std::move(*device)};
}

}  // namespace macula::xr
