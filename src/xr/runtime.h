// The software of a headset (an OpenXR runtime), and the headset.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/instance.h"
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

// What runtime and headset offer, for a person.
struct Offer {
    std::string runtime;  // "Monado 21.0.0"
    std::string headset;  // empty: no headset
    glm::ivec2 eyePx{0};  // recommended size of each eye's picture
    bool hasGaze = false;
    bool takesDepth = false;    // a depth layer (XR_KHR_composition_layer_depth)
    bool hasMask = false;       // has a mask of what no lens shows
    bool hasInsets = false;     // two more views, finer and smaller (XR_VARJO_quad_views)
    glm::ivec2 insetPx{0};      // recommended size of each inset's picture
    bool showsRoom = false;     // can show the real room behind the pictures
    bool isSeeThrough = false;  // always shows it: black is transparent
    std::vector<std::string> extensions;
};

// An XrInstance and the headset. Sessions keep it alive. Used by one thread at a time.
class Runtime {
  public:
    // deviceNotUsable: no loader, no runtime, a broken one, or one without XR_KHR_vulkan_enable2.
    static Result<std::shared_ptr<Runtime>> connect(const char* loaderLibrary = kLoaderLibrary);

    Runtime(const Runtime&) = delete;
    Runtime& operator=(const Runtime&) = delete;
    ~Runtime();

    // Call it repeatedly until a headset is there; deviceNotUsable until then.
    Result<void> findHeadset();

    const Offer& offer() const { return offer_; }
    const Functions& call() const { return call_; }
    XrInstance instance() const { return instance_; }
    XrSystemId system() const { return system_; }  // after findHeadset
    // With insets four views, the two insets last; otherwise one for each eye. Call it after findHeadset.
    XrViewConfigurationType viewConfiguration() const;
    std::uint32_t viewCount() const { return offer_.hasInsets ? 4 : 2; }
    const std::vector<XrEnvironmentBlendMode>& blendModes() const { return blendModes_; }
    Result<XrPath> path(const std::string& text) const;
    // Whether the runtime offers this optional extension, which is then enabled.
    bool isOn(const char* extension) const;
    // A function of an enabled extension; null if the runtime lacks it.
    PFN_xrVoidFunction function(const char* name) const;

  private:
    Runtime() = default;
    Result<void> askForViews();
    Result<void> askForBlendModes();

    Loader loader_;
    Functions call_;
    XrInstance instance_ = XR_NULL_HANDLE;
    XrSystemId system_ = XR_NULL_SYSTEM_ID;
    std::vector<XrEnvironmentBlendMode> blendModes_;  // the headset's favourite first
    Offer offer_;
};

// The report of `macula xr --check`; `missing` is the first obstacle to using the headset.
struct Check {
    Offer offer;
    std::optional<Error> missing;
};
Check checkHeadset(const char* loaderLibrary = kLoaderLibrary);

// The device that draws for the headset, created by the runtime.
struct HeadsetDevice {
    gpu::Instance instance;
    std::shared_ptr<gpu::Device> device;
};
// `isAnnounced`: as in gpu::DeviceOptions.
Result<HeadsetDevice> openDevice(const Runtime& runtime, gpu::Validation validation = gpu::Validation::off,
                                 bool isAnnounced = true);

}  // namespace macula::xr
