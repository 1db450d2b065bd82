// The kernels that trace pictures, compiled when they are first needed.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/trace/denoiser.h"
#include "pipeline/trace/settings.h"

namespace macula::trace {

class DeviceScene;

// The features of a scene that a kernel is compiled for.
struct SceneKind {
    bool clip = false;
    bool mask = false;
    bool gradientOpacity = false;
    bool steep = false;         // steep matter has its own curves
    bool steepDensity = false;  // and these change its density, not only its colour
    bool coarse = false;        // some blocks of voxels are kept more coarsely
    bool greyFaces = false;     // a clip has some; counts for surface points only
    bool surfaces = false;      // matter scatters like surfaces; counts where paths are traced
    bool second = false;        // a second volume in the same picture
    bool tints = false;         // segments with colours
    int poolViews = 1;          // views of the voxel pool, each but the last of 2^poolViewShift values
    int poolViewShift = 0;      // counts where there are several

    auto operator<=>(const SceneKind&) const = default;  // NOLINT(modernize-use-nullptr): its mistake
};

// The kind that kernels have to be compiled for, in the look prepared last; without greyFaces.
SceneKind kindOf(const DeviceScene& scene);

// What a kernel is compiled for.
struct TraceVariant {
    Look look = Look::cinematic;
    Filter filter = Filter::trilinear;
    bool shading = false;
    SceneKind scene = {};
    bool tellsPrimaries = false;  // paths keep their primary vertices: path_primaries.comp
    bool isSideBySide = false;    // samples of a pixel are traced side by side: path_side.comp
    bool usesIndirect = false;    // paths end in the cache of indirect light, and fill it

    bool operator<(const TraceVariant& b) const {
        return std::tie(look, filter, shading, scene, tellsPrimaries, isSideBySide, usesIndirect) <
               std::tie(b.look, b.filter, b.shading, b.scene, b.tellsPrimaries, b.isSideBySide,
                        b.usesIndirect);
    }
};

// The same for settings that differ only in parameters, so that no kernel is compiled twice.
TraceVariant variantOf(const Settings& settings, SceneKind scene);

// Used by one thread at a time, the one that uses the device.
class TraceKernels {
  public:
    explicit TraceKernels(std::shared_ptr<gpu::Device> device) : device_(std::move(device)) {}

    struct Found {
        const gpu::Kernel* kernel = nullptr;  // its address stays valid
        bool isNew = false;                   // its first dispatch compiles it
    };
    // path.comp, path_primaries.comp, path_side.comp or cast.comp.
    Result<Found> samples(const TraceVariant& variant);
    Result<const gpu::Kernel*> addSamples();  // add_samples.comp
    Result<const gpu::Kernel*> guides(SceneKind scene);
    Result<const gpu::Kernel*> layers(SceneKind scene);
    Result<const gpu::Kernel*> candidates(SceneKind scene);
    Result<const gpu::Kernel*> surfacePoints(SceneKind scene);
    Result<std::shared_ptr<const DenoiseKernels>> denoising();

  private:
    Result<const gpu::Kernel*> find(std::map<SceneKind, gpu::Kernel>& kernels, const gpu::ShaderCode& code,
                                    SceneKind scene, const std::vector<gpu::Specialization>& more = {},
                                    gpu::NativeKernel native = {});

    std::shared_ptr<gpu::Device> device_;
    std::map<TraceVariant, gpu::Kernel> samples_;
    std::optional<gpu::Kernel> addSamples_;
    std::map<SceneKind, gpu::Kernel> guides_, layers_, candidates_, surfacePoints_;
    std::shared_ptr<const DenoiseKernels> denoising_;
};

}  // namespace macula::trace
