#include "xr/loader.h"

#include <dlfcn.h>

#include <cstdlib>
#include <string>

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

}  // namespace macula::xr
