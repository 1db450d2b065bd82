#include "pipeline/gpu/instance.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <mutex>

#include "base/log.h"
#include "pipeline/gpu/instance_state.h"
#include "pipeline/gpu/vulkan_error.h"

namespace macula::gpu {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

bool environmentWantsValidation() {
    const char* value = std::getenv("MACULA_VALIDATION");
    return value && *value && std::strcmp(value, "0") != 0;
}

bool layerInstalled(const char* wanted) {
    std::uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    return std::any_of(layers.begin(), layers.end(),
                       [&](const auto& layer) { return std::strcmp(layer.layerName, wanted) == 0; });
}

std::vector<std::string> extensionsOf(const char* layer) {
    std::uint32_t count = 0;
    vkEnumerateInstanceExtensionProperties(layer, &count, nullptr);
    std::vector<VkExtensionProperties> properties(count);
    vkEnumerateInstanceExtensionProperties(layer, &count, properties.data());
    std::vector<std::string> names;
    for (const auto& property : properties) names.emplace_back(property.extensionName);
    return names;
}

bool contains(const std::vector<std::string>& names, const char* wanted) {
    return std::find(names.begin(), names.end(), wanted) != names.end();
}

VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                              VkDebugUtilsMessageTypeFlagsEXT type,
                              const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    // Remarks of the loader itself (say, on a driver without its hardware) are not about Macula's calls.
    if (type == VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT) {
        log::debug("Vulkan: {}", data->pMessage);
        return VK_FALSE;
    }
    const bool isError = (severity & VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT) != 0;
    log::write(isError ? log::Level::error : log::Level::warning, fmt::format("Vulkan: {}", data->pMessage));
    auto& messages = *static_cast<ValidationMessages*>(user);
    const std::lock_guard lock(messages.mutex);
    messages.texts.emplace_back(data->pMessage);
    return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT messengerInfo(ValidationMessages& messages) {
    VkDebugUtilsMessengerCreateInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    // No performance warnings: they would complain about each use of GENERAL, the layout of all our images.
    info.messageType =
        VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
    info.pfnUserCallback = onMessage;
    info.pUserData = &messages;
    return info;
}

// Keeps one instance for ever, because the loader unloads a driver with its last instance, and a process can
// load a driver only so many times: NVIDIA's (580.159) was refused after 37 times, probably for lack of
// static thread-local storage, and then the computer seems to have no driver.
void keepDriversLoaded() {
    [[maybe_unused]] static const VkInstance kept = [] {
        VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
        VkInstance made = VK_NULL_HANDLE;
        return vkCreateInstance(&info, nullptr, &made) == VK_SUCCESS ? made : VK_NULL_HANDLE;
    }();
}

}  // namespace

Instance::State::~State() {
    if (messenger) {
        const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(handle, "vkDestroyDebugUtilsMessengerEXT"));
        destroy(handle, messenger, nullptr);
    }
    if (handle && !isLent) vkDestroyInstance(handle, nullptr);
}

Error noVulkanDriver() {
    return {
        ErrorCode::deviceNotUsable,
        Text("There is no Vulkan driver on this computer, so nothing can be rendered."), "",
        Text("Install the driver of the graphics card, or, to render on the CPU, the Debian/Ubuntu package "
             "mesa-vulkan-drivers: sudo apt install mesa-vulkan-drivers")};
}

Result<Instance> Instance::borrow(const InstanceOptions& options) {
    auto state = std::make_shared<State>();
    state->isLent = true;
    state->handle = options.lent;
    state->debugUtils = std::any_of(
        options.extensions.begin(), options.extensions.end(),
        [](const char* extension) { return std::strcmp(extension, VK_EXT_DEBUG_UTILS_EXTENSION_NAME) == 0; });
    state->validating = options.validation == Validation::on && state->debugUtils;
    return finished(std::move(state));
}

Result<Instance> Instance::create(const InstanceOptions& options) {
    if (options.lent) return borrow(options);
    auto state = std::make_shared<State>();
    state->validating = options.validation == Validation::on || environmentWantsValidation();
    if (state->validating && !layerInstalled(kValidationLayer))
        return Error{ErrorCode::deviceNotUsable,
                     Text("The Vulkan validation layer was asked for, but is not installed."), "",
                     Text("Install it (Debian/Ubuntu: sudo apt install vulkan-validationlayers), or unset "
                          "MACULA_VALIDATION.")};

    auto offered = extensionsOf(nullptr);
    std::vector<const char*> layers;
    if (state->validating) {
        layers.push_back(kValidationLayer);
        const auto more = extensionsOf(kValidationLayer);
        offered.insert(offered.end(), more.begin(), more.end());
    }
    std::vector<const char*> extensions = options.extensions;
    state->debugUtils = contains(offered, VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    if (state->debugUtils) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    const bool checksSynchronization =
        state->validating && contains(offered, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
    if (checksSynchronization) extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);

    VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.pApplicationName = "Macula";
    application.pEngineName = "Macula";
    application.apiVersion = VK_API_VERSION_1_3;

    auto messenger = messengerInfo(state->messages);
    const VkValidationFeatureEnableEXT enables[] = {
        VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
    features.enabledValidationFeatureCount = 1;
    features.pEnabledValidationFeatures = enables;

    VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    info.pApplicationInfo = &application;
    info.enabledLayerCount = static_cast<std::uint32_t>(layers.size());
    info.ppEnabledLayerNames = layers.data();
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    if (state->validating && state->debugUtils) info.pNext = &messenger;  // also for creation
    if (checksSynchronization) {
        features.pNext = info.pNext;
        info.pNext = &features;
    }

    const VkResult result = options.createInstance ? options.createInstance(info, &state->handle)
                                                   : vkCreateInstance(&info, nullptr, &state->handle);
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER) return noVulkanDriver();
    if (result == VK_ERROR_EXTENSION_NOT_PRESENT) {
        std::string missing;
        for (const char* extension : extensions)
            if (!contains(offered, extension))
                missing += fmt::format("{}{}", missing.empty() ? "" : ", ", extension);
        // Without any driver the loader offers no window system extensions.
        if (offered.empty() || !contains(offered, VK_KHR_SURFACE_EXTENSION_NAME)) return noVulkanDriver();
        return Error{ErrorCode::deviceNotUsable,
                     Text("The Vulkan driver of this computer does not offer {}.", missing), "",
                     Text("Update the graphics driver.")};
    }
    if (result != VK_SUCCESS) return vulkanError(result, Text("start Vulkan"));
    keepDriversLoaded();
    return finished(std::move(state));
}

// Completes an instance that has its handle.
Result<Instance> Instance::finished(std::shared_ptr<State> state) {
    if (state->validating && state->debugUtils) {
        const auto createMessenger = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(state->handle, "vkCreateDebugUtilsMessengerEXT"));
        const auto messenger = messengerInfo(state->messages);
        MACULA_VK_TRY(createMessenger(state->handle, &messenger, nullptr, &state->messenger),
                      Text("listen to the Vulkan validation layer"));
    }

    std::uint32_t devices = 0;
    if (vkEnumeratePhysicalDevices(state->handle, &devices, nullptr) != VK_SUCCESS || devices == 0)
        return noVulkanDriver();
    return Instance(std::move(state));
}

VkInstance Instance::handle() const {
    return state_->handle;
}
bool Instance::validating() const {
    return state_->validating;
}
bool Instance::hasDebugUtils() const {
    return state_->debugUtils;
}

std::size_t Instance::validationMessageCount() const {
    const std::lock_guard lock(state_->messages.mutex);
    return state_->messages.texts.size();
}

std::vector<std::string> Instance::validationMessages() const {
    const std::lock_guard lock(state_->messages.mutex);
    return state_->messages.texts;
}

}  // namespace macula::gpu
