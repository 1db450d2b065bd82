// The OpenXR loader, which finds the software of the headset.
#pragma once

#include "base/result.h"
#include "xr/openxr.h"

namespace macula::xr {

inline constexpr const char* kLoaderLibrary = "libopenxr_loader.so.1";

// Of an instance, by their names without xr.
struct Functions {
#define MACULA_XR_FUNCTION(name) PFN_xr##name name = nullptr;
#include "xr/functions.inl"
#undef MACULA_XR_FUNCTION
    PFN_xrGetVisibilityMaskKHR GetVisibilityMaskKHR = nullptr;  // null where the extension is not on
};

// Stays in memory until the program ends, as it keeps what it has found.
struct Loader {
    PFN_xrGetInstanceProcAddr getInstanceProcAddr = nullptr;
    PFN_xrEnumerateInstanceExtensionProperties enumerateExtensions = nullptr;
    PFN_xrCreateInstance createInstance = nullptr;

    // deviceNotUsable when it is not installed.
    static Result<Loader> open(const char* library = kLoaderLibrary);

    // deviceNotUsable when one is missing; those that there are, are found all the same.
    Result<void> find(XrInstance instance, Functions& functions) const;
};

}  // namespace macula::xr
