#include "xr/loader.h"

#include <dlfcn.h>

#include <cstdlib>
#include <string>

namespace macula::xr {

namespace {

Error brokenRuntime() {
    return {ErrorCode::deviceNotUsable, "The software of the headset does not answer as OpenXR 1.0 demands.",
            "", "Update or reinstall it."};
}

template <class Function>
bool find(const Loader& loader, XrInstance instance, const char* name, Function& function) {
    PFN_xrVoidFunction found = nullptr;
    if (loader.getInstanceProcAddr(instance, name, &found) != XR_SUCCESS) return false;
    function = reinterpret_cast<Function>(found);
    return function != nullptr;
}

}  // namespace

Result<Loader> Loader::open(const char* library) {
    // What it has to say, Macula says in words.
    setenv("XR_LOADER_DEBUG", "none", 0);
    void* opened = dlopen(library, RTLD_NOW | RTLD_LOCAL);
    Loader loader;
    if (opened)
        loader.getInstanceProcAddr =
            reinterpret_cast<PFN_xrGetInstanceProcAddr>(dlsym(opened, "xrGetInstanceProcAddr"));
    if (!loader.getInstanceProcAddr ||
        !find(loader, XR_NULL_HANDLE, "xrEnumerateInstanceExtensionProperties", loader.enumerateExtensions) ||
        !find(loader, XR_NULL_HANDLE, "xrCreateInstance", loader.createInstance))
        return Error{ErrorCode::deviceNotUsable,
                     "The OpenXR loader is not installed, so no headset can be found.", "",
                     "Install it (Debian/Ubuntu: sudo apt install libopenxr-loader1)."};
    return loader;
}

Result<Functions> Loader::functionsOf(XrInstance instance) const {
    Functions functions;
#define MACULA_XR_FUNCTION(name) \
    if (!find(*this, instance, "xr" #name, functions.name)) return brokenRuntime();
#include "xr/functions.inl"
#undef MACULA_XR_FUNCTION
    return functions;
}

PFN_xrGetVisibilityMaskKHR Loader::maskFunctionOf(XrInstance instance) const {
    PFN_xrGetVisibilityMaskKHR function = nullptr;
    find(*this, instance, "xrGetVisibilityMaskKHR", function);
    return function;
}

}  // namespace macula::xr
