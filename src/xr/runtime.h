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
    Result<XrPath> path(const std::string& text) const;
    // Of an extension that is enabled; null where the runtime has it not.
    PFN_xrVoidFunction function(const char* name) const;

  private:
    Runtime() = default;

    Loader loader_;
    Functions call_;
    XrInstance instance_ = XR_NULL_HANDLE;
    XrSystemId system_ = XR_NULL_SYSTEM_ID;
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
Result<HeadsetDevice> openDevice(const Runtime& runtime, gpu::Validation validation = gpu::Validation::off);

}  // namespace macula::xr
