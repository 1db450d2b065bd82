#include "pipeline/trace/native_marches.h"

#include <algorithm>

#include "base/glsl_in_cpp.h"
#include "base/parallel.h"
#include "pipeline/trace/clip_params.h"
#include "pipeline/trace/native_tables.h"
#include "pipeline/trace/settings.h"
#include "shared/guide_params.h"
#include "shared/indirect_light.h"
#include "shared/pixel_layers.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/trace/native_marches.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace macula::trace {
namespace HWY_NAMESPACE {
namespace {

#define MACULA_HOST NativeHost
#define MACULA_REAL float
#define MACULA_VOXELS PooledVoxels
#include "pipeline/trace/shader_host.inl"
#undef MACULA_HOST
#undef MACULA_REAL
#undef MACULA_VOXELS

// Calls one(host, pixel, index) for each pixel of the dispatch's rows. They are few at a time, so each thread
// takes some columns.
template <class One>
void forEachPixel(const gpu::NativeDispatch& dispatch, const SceneKind& scene, int firstRow, const One& one) {
    constexpr int kColumns = 16;
    const shared::TraceParams& params = dispatch.binding<const shared::TraceParams>(0)[0];
    const NativeHost prototype(nativeTables(dispatch, params, {.scene = scene}), params, Filter::trilinear);
    const glm::ivec2& size = prototype.params.imageSize;
    const int endRow = std::min(size.y, firstRow + shared::kBlockEdge * int(dispatch.groups()[1]));
    parallelFor(std::size_t((size.x + kColumns - 1) / kColumns), [&](std::size_t n) {
        NativeHost host = prototype;
        const int first = int(n) * kColumns;
        for (int y = firstRow; y < endRow; ++y)
            for (int x = first; x < std::min(size.x, first + kColumns); ++x)
                one(host, glm::ivec2(x, y), std::size_t(y) * std::size_t(size.x) + std::size_t(x));
    });
}

}  // namespace

void fillGuides(const gpu::NativeDispatch& dispatch, const SceneKind& scene) {
    const auto push = dispatch.push<shared::GuidePush>();
    const auto surfaces = dispatch.binding<glm::vec4>(16);
    const auto matters = dispatch.binding<glm::vec4>(17);
    const auto motions = dispatch.binding<glm::vec4>(18);
    const NativeHost::Fovea fovea{push.planeHalfSize, push.gaze, push.foveaRadius, push.foveaMagnification};
    const NativeHost::Eye before{push.oursMm, push.right, push.up, push.forward, fovea, push.parallelMm};
    const auto one = [&](NativeHost& host, const glm::ivec2& pixel, std::size_t index) {
        const NativeHost::Guide guide = host.guideOf(glm::vec2(pixel) + 0.5f, before);
        surfaces[index] = {guide.normal, guide.depthMm};
        matters[index] = {guide.albedo, guide.coverage};
        motions[index] = {guide.motion, guide.confidence, guide.beforeMm};
    };
    forEachPixel(dispatch, scene, push.firstRow, one);
}

void fillLayers(const gpu::NativeDispatch& dispatch, const SceneKind& scene) {
    const auto pixels = dispatch.binding<shared::PixelLayers>(16);
    const auto one = [&](NativeHost& host, const glm::ivec2& pixel, std::size_t index) {
        const NativeHost::LayeredRay ray = host.layersOf(glm::vec2(pixel) + 0.5f);
        const auto& mm = host.layerMm;
        pixels[index] = {{mm[0], mm[1], mm[2], mm[3]}, {mm[4], mm[5], mm[6], mm[7]}, ray.coverage, ray.meanMm};
    };
    forEachPixel(dispatch, scene, dispatch.push<shared::LayersPush>().firstRow, one);
}

}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace macula::trace {

HWY_EXPORT(fillGuides);
HWY_EXPORT(fillLayers);

gpu::NativeKernel nativeGuides(const SceneKind& scene) {
    return [scene](const gpu::NativeDispatch& dispatch) {
        HWY_DYNAMIC_DISPATCH(fillGuides)(dispatch, scene);
    };
}

gpu::NativeKernel nativeLayers(const SceneKind& scene) {
    return [scene](const gpu::NativeDispatch& dispatch) {
        HWY_DYNAMIC_DISPATCH(fillLayers)(dispatch, scene);
    };
}

}  // namespace macula::trace
#endif
