// shaders/lib/splat_blend.glsl as C++ for a vector of pixels, for native kernels. Compiled once for each
// instruction set.
#if defined(MACULA_SPLAT_VECTOR_SPLATS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MACULA_SPLAT_VECTOR_SPLATS_H
#undef MACULA_SPLAT_VECTOR_SPLATS_H
#else
#define MACULA_SPLAT_VECTOR_SPLATS_H
#endif

#include "base/vector_in_glsl.h"
#include "pipeline/splat/native/native_tiles.h"
#include "shared/splat_view.h"

HWY_BEFORE_NAMESPACE();
namespace macula::splat::HWY_NAMESPACE {

using namespace macula::HWY_NAMESPACE;

#define INOUT(type) type&
#define float Float
#define bool Mask

struct VectorBlend : GlslInVectors {
    // What splat_blend.glsl needs of shared::SplatView.
    struct SplatView {
        Float maxAlpha, minAlpha, fringe, minTransmittance;
    };

#include "lib/splat_types.glsl"

#include "lib/splat_blend.glsl"
};

#undef HARD_EDGE
#undef INOUT
#undef float
#undef bool

HWY_INLINE VectorBlend::SplatView viewOf(const shared::SplatView& view) {
    return {view.maxAlpha, view.minAlpha, view.fringe, view.minTransmittance};
}

// One splat, the same for all pixels.
struct ShownSplat {
    // From its texels, see shaders/splat/screen.glsl.
    HWY_INLINE explicit ShownSplat(const float* texels) : colour(texels[8], texels[9], texels[10]) {
        screen.mean = Vec2(texels[0], texels[1]);
        screen.conic = Vec3(texels[2], texels[3], texels[4]);
        screen.opacity = texels[5];
        screen.depthMm = texels[6];
        screen.extent = Vec2(texels[7], texels[11]);
    }

    VectorBlend::ScreenSplat screen;
    Vec3 colour;
};

// The vectors of a block in which a splat may show, first <= vector < end.
struct VectorRange {
    std::size_t first;
    std::size_t end;
};
HWY_INLINE VectorRange vectorsOf(const RowRange& rows) {
    constexpr std::size_t kColumns = shared::kTileColumns;
    return {static_cast<std::size_t>(rows.first) * kColumns / kLanes,
            (static_cast<std::size_t>(rows.end) * kColumns + kLanes - 1) / kLanes};
}

// The centres of a block's pixels, px: the first two of their numbers. A block goes from tile to tile.
inline void writeCentres(PixelBlock& block) {
    for (std::size_t pixel = 0; pixel < block.pixels(); ++pixel) {
        block.at(pixel)[0] = static_cast<float>(pixel % shared::kTileColumns) + 0.5f;
        block.at(pixel)[kLinePixels] = static_cast<float>(pixel / shared::kTileColumns) + 0.5f;
    }
}
HWY_INLINE void moveCentres(PixelBlock& block, const glm::ivec2& byPixels) {
    for (std::size_t pixel = 0; pixel < block.pixels(); pixel += kLanes) {
        float* x = block.at(pixel);
        (Float::load(x) + Float(byPixels.x)).store(x);
        (Float::load(x + kLinePixels) + Float(byPixels.y)).store(x + kLinePixels);
    }
}

// A row of a tile.
using RowTag = hn::CappedTag<float, shared::kTileColumns>;

}  // namespace macula::splat::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
