// The OpenXR loader, which finds the software of the headset.
#pragma once

#include "base/result.h"
#include "xr/openxr.h"

namespace macula::xr {

inline constexpr const char* kLoaderLibrary = "libopenxr_loader.so.1";

// The functions of an instance, named without the prefix xr.
struct Functions {
#define MACULA_XR_FUNCTION(name) PFN_xr##name name = nullptr;
#include "xr/functions.inl"
#undef MACULA_XR_FUNCTION
    PFN_xrGetVisibilityMaskKHR GetVisibilityMaskKHR = nullptr;  // null without the extension
};

// The library stays loaded until the program ends, because it caches what it has found.
struct Loader {
    PFN_xrGetInstanceProcAddr getInstanceProcAddr = nullptr;
    PFN_xrEnumerateInstanceExtensionProperties enumerateExtensions = nullptr;
    PFN_xrCreateInstance createInstance = nullptr;

    // deviceNotUsable when it is not installed.
    static Result<Loader> open(const char* library = kLoaderLibrary);

    // deviceNotUsable if a function is missing; the others are set nevertheless.
    Result<void> find(XrInstance instance, Functions& functions) const;
};

}  // namespace macula::xr
