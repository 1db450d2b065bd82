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
#include "xr/loader.h"

namespace macula::xr {

// What there is, for a person.
struct Offer {
    std::string runtime;  // "Monado 21.0.0"
    std::string headset;  // empty: none is there
    glm::ivec2 eyePx{0};  // of the picture for each eye, as the headset wants it
    bool hasGaze = false;
    bool takesDepth = false;    // a depth layer (XR_KHR_composition_layer_depth)
    bool hasMask = false;       // says what no lens shows (XR_KHR_visibility_mask)
    bool hasInsets = false;     // two more views, finer and smaller (XR_VARJO_quad_views)
    glm::ivec2 insetPx{0};      // of the picture for each of these
    bool showsRoom = false;     // the room may be seen behind what is shown
    bool isSeeThrough = false;  // and is always seen: what is black is clear
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

    // Again and again, until one is there; deviceNotUsable until then.
    Result<void> findHeadset();

    const Offer& offer() const { return offer_; }
    const Functions& call() const { return call_; }
    XrInstance instance() const { return instance_; }
    XrSystemId system() const { return system_; }  // after findHeadset
    // With insets four views, the two insets last; else one for each eye. After findHeadset.
    XrViewConfigurationType viewConfiguration() const;
    std::uint32_t viewCount() const { return offer_.hasInsets ? 4 : 2; }
    const std::vector<XrEnvironmentBlendMode>& blendModes() const { return blendModes_; }
    Result<XrPath> path(const std::string& text) const;
    // Whether an extension that Macula can use is offered, and so enabled.
    bool isOn(const char* extension) const;
    // Of an extension that is enabled; null where the runtime has it not.
    PFN_xrVoidFunction function(const char* name) const;

  private:
    Runtime() = default;
    Result<void> askForViews();
    Result<void> askForBlendModes();

    Loader loader_;
    Functions call_;
    XrInstance instance_ = XR_NULL_HANDLE;
    XrSystemId system_ = XR_NULL_SYSTEM_ID;
    std::vector<XrEnvironmentBlendMode> blendModes_;  // the first is what the headset likes best
    Offer offer_;
};

// What `macula xr --check` tells; `missing` is the first thing that keeps the headset from being used.
struct Check {
    Offer offer;
    std::optional<Error> missing;
};
Check checkHeadset(const char* loaderLibrary = kLoaderLibrary);

// The device that the headset shows pictures of, made by its runtime.
struct HeadsetDevice {
    gpu::Instance instance;
    std::shared_ptr<gpu::Device> device;
};
// `isAnnounced`: as of gpu::DeviceOptions.
Result<HeadsetDevice> openDevice(const Runtime& runtime, gpu::Validation validation = gpu::Validation::off,
                                 bool isAnnounced = true);

}  // namespace macula::xr
