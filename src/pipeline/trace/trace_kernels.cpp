#include "pipeline/trace/trace_kernels.h"

#include "pipeline/trace/device_scene.h"
#include "pipeline/trace/native_casts.h"
#include "pipeline/trace/native_marches.h"
#include "pipeline/trace/native_paths.h"
#include "pipeline/trace/native_surface_points.h"
#include "shaders/trace.h"
#include "shared/trace_params.h"

namespace macula::trace {

namespace {

constexpr int kMaxRoundsCpu = 16000;    // see path_samples.glsl
constexpr int kMaxRoundsGpu = 1 << 24;  // cards have no known limit: this only ends endless paths

int castOf(Look look) {
    switch (look) {
        case Look::mip:
            return shared::kCastMaximum;
        case Look::minip:
            return shared::kCastMinimum;
        case Look::average:
            return shared::kCastMean;
        case Look::cinematic:
        case Look::clear:
        case Look::dvr:
            break;
    }
    return shared::kCastMatter;
}

const gpu::ShaderCode& samplesCodeOf(const TraceVariant& variant) {
    if (!isPathTraced(variant.look)) return shaders::trace_cast_comp;
    if (variant.isSideBySide) return shaders::trace_path_side_comp;
    return variant.tellsPrimaries ? shaders::trace_path_primaries_comp : shaders::trace_path_comp;
}

}  // namespace

SceneKind kindOf(const DeviceScene& scene) {
    return {.clip = scene.isClipped(),
            .mask = scene.isMasked(),
            .gradientOpacity = scene.hasGradientOpacity(),
            .steep = scene.hasSteep(),
            .steepDensity = scene.hasSteepDensity(),
            .coarse = scene.holdsCoarseBlocks(),
            .surfaces = scene.hasSurfaces(),
            .second = scene.hasSecond(),
            .tints = scene.hasTints(),
            .poolViews = scene.poolViews(),
            .poolViewShift = scene.poolViews() > 1 ? scene.poolViewShift() : 0};
}

TraceVariant variantOf(const Settings& settings, SceneKind scene) {
    if (isPathTraced(settings.look)) return {.filter = settings.filter, .scene = scene};
    scene.surfaces = false;
    scene.gradientOpacity = scene.gradientOpacity && settings.look == Look::dvr;
    scene.steep = scene.steep && settings.look == Look::dvr;
    scene.steepDensity = scene.steepDensity && settings.look == Look::dvr;
    return {.look = settings.look,
            .filter = filterOf(settings.look, settings.filter),
            .shading = settings.look == Look::dvr && settings.shading == Shading::headlight,
            .scene = scene};
}

Result<TraceKernels::Found> TraceKernels::samples(const TraceVariant& variant) {
    if (const auto found = samples_.find(variant); found != samples_.end())
        return Found{&found->second, false};
    gpu::KernelOptions options{
        .specializations = {{"kTrilinear", variant.filter != Filter::stochastic},
                            {"kSmooth", variant.filter == Filter::smooth},
                            {"kSharp", variant.filter == Filter::sharp},
                            {"kMaxRounds", device_->isCpu() ? kMaxRoundsCpu : kMaxRoundsGpu},
                            {"kClip", variant.scene.clip},
                            {"kMask", variant.scene.mask},
                            {"kGradientOpacity", variant.scene.gradientOpacity},
                            {"kSteep", variant.scene.steep},
                            {"kSteepDensity", variant.scene.steepDensity},
                            {"kCoarse", variant.scene.coarse},
                            {"kSecond", variant.scene.second},
                            {"kTints", variant.scene.tints},
                            {"kPoolViews", variant.scene.poolViews},
                            {"kPoolViewShift", variant.scene.poolViewShift},
                            {"kShading", variant.shading},
                            {"kCast", castOf(variant.look)}},
        .subgroupSize = gpu::subgroupSizeForDivergence(device_->info()),
        .native =
            isPathTraced(variant.look) ? nativePaths(variant) : nativeCasts(variant, castOf(variant.look))};
    if (isPathTraced(variant.look)) {
        options.specializations.emplace_back("kIndirect", variant.usesIndirect);
        options.specializations.emplace_back("kSurfaces", variant.scene.surfaces);
    }
    if (variant.isSideBySide) options.specializations.emplace_back("kShares", device_->isCpu());
    MACULA_TRY(gpu::Kernel kernel, gpu::Kernel::create(device_, samplesCodeOf(variant), options));
    return Found{&samples_.emplace(variant, std::move(kernel)).first->second, true};
}

Result<const gpu::Kernel*> TraceKernels::addSamples() {
    if (!addSamples_) {
        MACULA_TRY(addSamples_, gpu::Kernel::create(device_, shaders::trace_add_samples_comp));
    }
    return &*addSamples_;
}

Result<const gpu::Kernel*> TraceKernels::guides(SceneKind scene) {
    scene.surfaces = false;
    return find(guides_, shaders::trace_guides_comp, scene, {}, nativeGuides(scene));
}

Result<const gpu::Kernel*> TraceKernels::layers(SceneKind scene) {
    scene.surfaces = false;
    return find(layers_, shaders::trace_layers_comp, scene, {}, nativeLayers(scene));
}

Result<const gpu::Kernel*> TraceKernels::candidates(SceneKind scene) {
    scene.surfaces = false;
    return find(candidates_, shaders::trace_candidates_comp, scene, {{"kGreyFaces", scene.greyFaces}},
                nativeCandidates(scene));
}

Result<const gpu::Kernel*> TraceKernels::surfacePoints(SceneKind scene) {
    return find(surfacePoints_, shaders::trace_surface_points_comp, scene,
                {{"kMaxRounds", device_->isCpu() ? kMaxRoundsCpu : kMaxRoundsGpu},
                 {"kGreyFaces", scene.greyFaces},
                 {"kSurfaces", scene.surfaces}},
                nativeSurfacePoints(scene));
}

// Finds or compiles the kernel for that kind of scene, with `more` specialization constants and perhaps a
// twin on the host.
Result<const gpu::Kernel*> TraceKernels::find(std::map<SceneKind, gpu::Kernel>& kernels,
                                              const gpu::ShaderCode& code, SceneKind scene,
                                              const std::vector<gpu::Specialization>& more,
                                              gpu::NativeKernel native) {
    if (const auto found = kernels.find(scene); found != kernels.end()) return &found->second;
    gpu::KernelOptions options{.specializations = {{"kClip", scene.clip},
                                                   {"kMask", scene.mask},
                                                   {"kGradientOpacity", scene.gradientOpacity},
                                                   {"kSteep", scene.steep},
                                                   {"kSteepDensity", scene.steepDensity},
                                                   {"kCoarse", scene.coarse},
                                                   {"kSecond", scene.second},
                                                   {"kTints", scene.tints},
                                                   {"kPoolViews", scene.poolViews},
                                                   {"kPoolViewShift", scene.poolViewShift}},
                               .native = std::move(native)};
    options.specializations.insert(options.specializations.end(), more.begin(), more.end());
    MACULA_TRY(gpu::Kernel kernel, gpu::Kernel::create(device_, code, options));
    return &kernels.emplace(scene, std::move(kernel)).first->second;
}

Result<std::shared_ptr<const DenoiseKernels>> TraceKernels::denoising() {
    if (!denoising_) {
        MACULA_TRY(denoising_, DenoiseKernels::create(device_));
    }
    return denoising_;
}

}  // namespace macula::trace
