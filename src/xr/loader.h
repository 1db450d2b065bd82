// The OpenXR loader, which finds the software of the headset.
#pragma once

#include "base/result.h"
#include "xr/openxr.h"

namespace macula::xr {

inline constexpr const char* kLoaderLibrary = "libopenxr_loader.so.1";

// The functions of an instance, by their names without xr.
#define MACULA_XR_FUNCTIONS(X)                                                                            \
    X(DestroyInstance)                                                                                    \
    X(GetInstanceProperties)                                                                              \
    X(PollEvent) X(ResultToString) X(StringToPath) X(GetSystem) X(GetSystemProperties)                    \
        X(EnumerateViewConfigurationViews) X(EnumerateEnvironmentBlendModes) X(CreateSession)             \
            X(DestroySession) X(BeginSession) X(EndSession) X(RequestExitSession)                         \
                X(EnumerateReferenceSpaces) X(CreateReferenceSpace) X(CreateActionSpace) X(DestroySpace)  \
                    X(LocateSpace) X(WaitFrame) X(BeginFrame) X(EndFrame) X(LocateViews)                  \
                        X(EnumerateSwapchainFormats) X(CreateSwapchain) X(DestroySwapchain)               \
                            X(EnumerateSwapchainImages) X(AcquireSwapchainImage) X(WaitSwapchainImage)    \
                                X(ReleaseSwapchainImage) X(CreateActionSet) X(DestroyActionSet)           \
                                    X(CreateAction) X(SuggestInteractionProfileBindings)                  \
                                        X(AttachSessionActionSets) X(SyncActions) X(GetActionStateFloat)  \
                                            X(GetVulkanGraphicsRequirements2KHR)                          \
                                                X(GetVulkanGraphicsDevice2KHR) X(CreateVulkanInstanceKHR) \
                                                    X(CreateVulkanDeviceKHR)

struct Functions {
#define MACULA_XR_DECLARE(name) PFN_xr##name name = nullptr;
    MACULA_XR_FUNCTIONS(MACULA_XR_DECLARE)
#undef MACULA_XR_DECLARE
};

// Stays in memory until the program ends, as it keeps what it has found.
struct Loader {
    PFN_xrGetInstanceProcAddr getInstanceProcAddr = nullptr;
    PFN_xrEnumerateInstanceExtensionProperties enumerateExtensions = nullptr;
    PFN_xrCreateInstance createInstance = nullptr;

    // deviceNotUsable when it is not installed.
    static Result<Loader> open(const char* library = kLoaderLibrary);

    // deviceNotUsable when one is missing.
    Result<Functions> functionsOf(XrInstance instance) const;
};

}  // namespace macula::xr
