// shaders/lib/splat_blend.glsl as C++ for a vector of pixels, for native kernels. Compiled once for each
// instruction set.
#if defined(MACULA_SPLAT_VECTOR_SPLATS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MACULA_SPLAT_VECTOR_SPLATS_H
#undef MACULA_SPLAT_VECTOR_SPLATS_H
#else
#define MACULA_SPLAT_VECTOR_SPLATS_H
#endif

#include <algorithm>
#include <array>
#include <cstdint>
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
    std::int32_t first;
    std::int32_t end;
};

// The vectors of the block of a tile, or of a part of its rows, in which splats may show, for as many splats
// as a vector has lanes.
class ShownVectors {
  public:
    // Of the entries of a tile from `entry` on, before `end`.
    HWY_INLINE void find(const NativeTiles& tiles, std::uint32_t entry, std::uint32_t end,
                         const glm::ivec2& firstPixel, int rows) {
        const std::size_t count = std::min<std::size_t>(kLanes, end - entry);
        std::array<std::array<float, kLanes>, 6> numbers{};
        for (std::size_t lane = 0; lane < count; ++lane) {
            const float* const texels = tiles.screenOf(tiles.entries[entry + lane].x);
            for (std::size_t k = 0; k < 5; ++k) numbers[k][lane] = texels[k];
            numbers[5][lane] = texels[11];
        }
        const auto number = [&](std::size_t k) { return Float::load(numbers[k].data()); };
        const Vec2 mean = Vec2(number(0), number(1)) - Vec2(Float(firstPixel.x), Float(firstPixel.y));
        find(mean, Vec3(number(2), number(3), number(4)), number(5), Float(rows));
    }

    HWY_INLINE VectorRange of(std::size_t n) const { return {firsts_[n], ends_[n]}; }

  private:
    // A splat shows where cx (x + cy y)^2 + cz y^2 <= s, at offsets from its mean: an ellipse, as high as the
    // extent, whose top and bottom lie at x = -cy y. If a column of the tile goes through the top, the top is
    // the highest place; else it is where the side of the tile that is nearer to the top crosses the ellipse.
    // The extent is larger than it need be (projectSplat), and so is s, by more than all rounding here.
    HWY_INLINE void find(Vec2 mean, Vec3 conic, Float extent, Float rows) {
        using Glsl = GlslInVectors;
        const Float low = Float(0.5f) - mean.x;
        const Float high = Float(shared::kTileColumns - 0.5f) - mean.x;
        const Float s = conic.z * extent * extent;
        const Float a = conic.x * conic.y * conic.y + conic.z;
        const Float perA = Float(1.0f) / a;
        // With y < 0 and `sign` -1, or y > 0 and 1. Not a number where rounding leaves nothing of an ellipse,
        // and then all rows are taken, as for a splat with such numbers.
        const auto highest = [&](Float sign) {
            const Float x = Glsl::clamp(-conic.y * extent * sign, low, high);
            return (sign * Glsl::sqrt(a * s - conic.x * conic.z * x * x) - conic.x * conic.y * x) * perA;
        };
        const Float top = mean.y + highest(Float(-1.0f)) - Float(0.5f);
        const Float bottom = mean.y + highest(Float(1.0f)) + Float(0.5f);
        constexpr auto kPerRow = static_cast<float>(shared::kTileColumns) / static_cast<float>(kLanes);
        const Float first =
            Glsl::mix(Float(0.0f), Glsl::min(Float(hn::Ceil(top.values)), rows), top > Float(0.0f));
        const Float end =
            Glsl::mix(rows, Glsl::max(Float(hn::Floor(bottom.values)), Float(0.0f)), bottom < rows);
        store(Float(hn::Floor((first * Float(kPerRow)).values)), firsts_);
        store(Float(hn::Ceil((end * Float(kPerRow)).values)), ends_);
    }
    using Integers = std::array<std::int32_t, kLanes>;
    static HWY_INLINE void store(Float value, Integers& to) {
        const hn::Rebind<std::int32_t, FloatTag> tag;
        hn::StoreU(hn::ConvertTo(tag, value.values), tag, to.data());
    }

    Integers firsts_;
    Integers ends_;
};

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
