// shaders/lib/splat_blend.glsl as C++ for a vector of pixels, for native kernels. Compiled once for each
// instruction set.
#if defined(MACULA_SPLAT_VECTOR_SPLATS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MACULA_SPLAT_VECTOR_SPLATS_H
#undef MACULA_SPLAT_VECTOR_SPLATS_H
#else
#define MACULA_SPLAT_VECTOR_SPLATS_H
#endif

#include <algorithm>
#include <vector>

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

// A number, by its place, of the pixels of a vector in a PixelBlock.
HWY_INLINE Float loaded(const float* pixel, std::size_t plane) {
    return Float::load(pixel + plane * kLinePixels);
}
HWY_INLINE void store(Float value, float* pixel, std::size_t plane) {
    value.store(pixel + plane * kLinePixels);
}

// The vectors of pixels of a tile, or of a part of its rows, and which of them are not finished.
struct OpenPixels {
    OpenPixels(int rows_, std::size_t numbers)
        : rows(rows_), block(rows_, numbers), open(block.pixels() / kLanes) {
        writeCentres(block);
    }

    // Begins another tile: all vectors are open, and their centres are there.
    void moveTo(const glm::ivec2& to) {
        moveCentres(block, to - firstPixel);
        firstPixel = to;
        std::fill(open.begin(), open.end(), char(1));
        openCount = open.size();
    }
    void close(std::size_t vector) {
        open[vector] = 0;
        --openCount;
    }

    int rows;
    glm::ivec2 firstPixel{0};
    PixelBlock block;
    std::vector<char> open;
    std::size_t openCount = 0;
};

// A row of a tile.
using RowTag = hn::CappedTag<float, shared::kTileColumns>;

}  // namespace macula::splat::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
