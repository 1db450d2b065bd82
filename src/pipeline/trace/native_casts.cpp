#include "pipeline/trace/native_casts.h"

#include <atomic>

#include "base/glsl_in_cpp.h"
#include "base/parallel.h"
#include "pipeline/trace/clip_params.h"
#include "pipeline/trace/native_film.h"
#include "pipeline/trace/native_tables.h"
#include "shared/indirect_light.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/trace/native_casts.cpp"
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

// Adds samples to a pixel, as cast.comp does.
void castPixel(NativeHost& host, const NativeFilm& film, const shared::PlannedBlock& planned,
               glm::ivec2 pixel) {
    const std::size_t index =
        std::size_t(pixel.y) * std::size_t(host.params.imageSize.x) + std::size_t(pixel.x);
    glm::vec4& sum = film.sums[index];
    std::uint32_t finite = 0;
    int rounds = 0;
    for (std::uint32_t n = 0; n < planned.sampleCount; ++n) {
        const glm::vec4 value = host.castSample(pixel, planned.firstSample + n, rounds);
        if (!host.isFinite(value) || !host.isFinite(sum + value)) continue;
        host.accumulate(sum, film.lost[index], value);
        host.accumulate(film.squares[index], host.squareOfLuminance(glm::vec3(value)));
        ++finite;
    }
    film.counts[index] += finite;
    if (finite < planned.sampleCount) std::atomic_ref(film.faults[0]) += planned.sampleCount - finite;
}

}  // namespace

void castRays(const gpu::NativeDispatch& dispatch, const TraceVariant& variant, int mode) {
    const shared::TraceParams& params = dispatch.binding<const shared::TraceParams>(0)[0];
    NativeHost prototype(nativeTables(dispatch, params, variant), params, variant.filter);
    prototype.cast = {mode, variant.shading};
    const NativeFilm film(dispatch);
    const int columns = (params.imageSize.x + shared::kBlockEdge - 1) / shared::kBlockEdge;
    parallelFor(film.plan.size(), [&](std::size_t n) {
        NativeHost host = prototype;  // a copy, because a ray writes to it
        const int block = int(film.plan[n].block);
        const glm::ivec2 first = shared::kBlockEdge * glm::ivec2(block % columns, block / columns);
        const glm::ivec2 end = glm::min(first + shared::kBlockEdge, params.imageSize);
        for (int y = first.y; y < end.y; ++y)
            for (int x = first.x; x < end.x; ++x) castPixel(host, film, film.plan[n], {x, y});
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace macula::trace {

HWY_EXPORT(castRays);

gpu::NativeKernel nativeCasts(const TraceVariant& variant, int mode) {
    return [variant, mode](const gpu::NativeDispatch& dispatch) {
        HWY_DYNAMIC_DISPATCH(castRays)(dispatch, variant, mode);
    };
}

}  // namespace macula::trace
#endif
