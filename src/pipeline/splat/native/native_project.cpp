#include "pipeline/splat/native/native_project.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/splat/native/native_project.cpp"
#include <hwy/foreach_target.h>  // first
#include <hwy/highway.h>

#include "pipeline/splat/native/vector_projection.h"

HWY_BEFORE_NAMESPACE();
namespace macula::splat::HWY_NAMESPACE {
namespace {

constexpr std::size_t kScreenNumbers = std::size_t(shared::kScreenTexels) * 4;  // of a splat

// The texels of neighbouring splats, in the order of project.comp.
HWY_INLINE void writeTexels(const VectorModel::ColouredSplat& projected, std::size_t count, float* to) {
    const VectorModel::ScreenSplat& s = projected.screen;
    const std::array<Float, kScreenNumbers> numbers{
        s.mean.x,  s.mean.y,   s.conic.x,          s.conic.y,          s.conic.z,          s.opacity,
        s.depthMm, s.extent.x, projected.colour.x, projected.colour.y, projected.colour.z, s.extent.y};
    for (std::size_t texel = 0; texel < kScreenNumbers; texel += 4) {
        std::array<float, 4 * kLanes> texels;
        hn::StoreInterleaved4(numbers[texel].values, numbers[texel + 1].values, numbers[texel + 2].values,
                              numbers[texel + 3].values, FloatTag(), texels.data());
        for (std::size_t lane = 0; lane < count; ++lane)
            std::copy_n(&texels[4 * lane], 4, to + lane * kScreenNumbers + texel);
    }
}

}  // namespace

void projectSplats(const gpu::NativeDispatch& dispatch, int degree) {
    const auto& frame = dispatch.binding<const shared::SplatFrame>(0).front();
    float* const screen = dispatch.binding<float>(1).data();
    const float* const parameters = dispatch.binding<const float>(2).data();
    const VectorModel::SplatView view = projectionOf(frame.view);
    forNeighbours(frame.count, [&](std::size_t first, const Neighbours& splats) {
        VectorModel model({degree, parameters, frame.capacity, splats});
        writeTexels(model.projectColoured(static_cast<int>(first), view), splats.count,
                    screen + first * kScreenNumbers);
    });
}

}  // namespace macula::splat::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace macula::splat {

HWY_EXPORT(projectSplats);

gpu::NativeKernel nativeProject(int degree) {
    return [degree](const gpu::NativeDispatch& dispatch) {
        HWY_DYNAMIC_DISPATCH(projectSplats)(dispatch, degree);
    };
}

}  // namespace macula::splat
#endif
