#include "pipeline/splat/native/native_raster_back.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/splat/native/native_raster_back.cpp"
#include <hwy/foreach_target.h>  // first
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/parallel.h"
#include "pipeline/splat/native/native_tiles.h"
#include "pipeline/splat/native/vector_splats.h"

#ifndef MACULA_SPLAT_NATIVE_RASTER_BACK
#define MACULA_SPLAT_NATIVE_RASTER_BACK
namespace macula::splat {

struct NativeBack {
    BackSlots slots;
    const glm::vec4* picture;
    const glm::vec4* gradient;
    float* pairs;

    float* sumsOf(std::uint32_t pair, int slot) const {
        return pairs + (std::size_t(pair) * std::size_t(slots.slots) + std::size_t(slot)) *
                           std::size_t(shared::kPairValues);
    }
};

}  // namespace macula::splat
#endif

HWY_BEFORE_NAMESPACE();
namespace macula::splat::HWY_NAMESPACE {
namespace {

// The numbers of a pixel in a PixelBlock: see addPixelGradient.
enum Plane : std::size_t { kX, kY, kTransmittance, kRemaining, kRed, kGreen, kBlue, kCoverage, kPlanes };

// A row of pixels of which `columns` are in the picture; those beside it have no transmittance and no
// gradient.
HWY_INLINE void beginRow(float* to, int columns, const glm::vec4* picture, const glm::vec4* gradient) {
    std::array<glm::vec4, 2 * shared::kTileColumns> copies{};
    if (columns < shared::kTileColumns) {
        std::copy_n(picture, columns, copies.data());
        std::copy_n(gradient, columns, copies.data() + shared::kTileColumns);
        picture = copies.data();
        gradient = copies.data() + shared::kTileColumns;
    }
    const RowTag tag;
    for (int column = 0; column < shared::kTileColumns; column += static_cast<int>(hn::Lanes(tag))) {
        hn::Vec<RowTag> red, green, blue, coverage;
        hn::LoadInterleaved4(tag, &picture[column].x, red, green, blue, coverage);
        hn::Vec<RowTag> gRed, gGreen, gBlue, gCoverage;
        hn::LoadInterleaved4(tag, &gradient[column].x, gRed, gGreen, gBlue, gCoverage);
        const auto remaining = hn::MulAdd(
            red, gRed, hn::MulAdd(green, gGreen, hn::MulAdd(blue, gBlue, hn::Mul(coverage, gCoverage))));
        float* pixel = to + column;
        hn::StoreU(remaining, tag, pixel + kRemaining * kLinePixels);
        hn::StoreU(gRed, tag, pixel + kRed * kLinePixels);
        hn::StoreU(gGreen, tag, pixel + kGreen * kLinePixels);
        hn::StoreU(gBlue, tag, pixel + kBlue * kLinePixels);
        hn::StoreU(gCoverage, tag, pixel + kCoverage * kLinePixels);
    }
    for (int column = 0; column < shared::kTileColumns; ++column)
        to[kTransmittance * kLinePixels + static_cast<std::size_t>(column)] = column < columns ? 1.0f : 0.0f;
}

void begin(OpenPixels& slot, const glm::ivec2& firstPixel, const glm::ivec2& sizePx, const NativeBack& back) {
    slot.moveTo(firstPixel);
    const int columns = std::min(shared::kTileColumns, sizePx.x - firstPixel.x);
    const int rows = std::min(slot.rows, sizePx.y - firstPixel.y);
    const auto blockRows = static_cast<int>(slot.block.pixels() / shared::kTileColumns);
    for (int row = 0; row < blockRows; ++row) {
        float* to = slot.block.at(static_cast<std::size_t>(row * shared::kTileColumns));
        const std::size_t pixel =
            row < rows ? std::size_t(firstPixel.y + row) * std::size_t(sizePx.x) + std::size_t(firstPixel.x)
                       : 0;
        beginRow(to, row < rows ? columns : 0, back.picture + pixel, back.gradient + pixel);
    }
}

// The sums of a pair, still by lane.
struct LaneSums {
    VectorBlend::ScreenGradient gradient;
    Float weight;
    Float pull;
};

HWY_INLINE void addVector(float* pixel, const ShownSplat& shown, const VectorBlend::SplatView& view,
                          Float& transmittance, LaneSums& sums) {
    VectorBlend maths;
    // Number by number: GCC copies a struct of vectors by way of memory, which takes a sixth of the time.
    VectorBlend::PixelGradient g;
    g.rgba.x = loaded(pixel, kRed);
    g.rgba.y = loaded(pixel, kGreen);
    g.rgba.z = loaded(pixel, kBlue);
    g.rgba.w = loaded(pixel, kCoverage);
    g.depth = 0.0f;
    Float remaining = loaded(pixel, kRemaining);
    const Float before = transmittance;
    const Vec2 meanBefore = sums.gradient.mean;
    maths.addPixelGradient(shown.screen, shown.colour, Vec2(loaded(pixel, kX), loaded(pixel, kY)), g, view,
                           transmittance, remaining, sums.gradient);
    sums.weight += before - transmittance;
    sums.pull +=
        maths.abs(sums.gradient.mean.x - meanBefore.x) + maths.abs(sums.gradient.mean.y - meanBefore.y);
    store(remaining, pixel, kRemaining);
}

HWY_INLINE LaneSums sumsOver(OpenPixels& slot, const VectorRange& vectors, const ShownSplat& shown,
                             const VectorBlend::SplatView& view) {
    LaneSums sums{VectorBlend().noGradient(), 0.0f, 0.0f};
    for (auto v = std::size_t(vectors.first); v < std::size_t(vectors.end); ++v) {
        if (slot.open[v] == 0) continue;
        float* pixel = slot.block.at(v * kLanes);
        Float transmittance = loaded(pixel, kTransmittance);
        addVector(pixel, shown, view, transmittance, sums);
        store(transmittance, pixel, kTransmittance);
        if (!(transmittance >= view.minTransmittance).none()) continue;
        slot.close(v);
    }
    return sums;
}

#if HWY_TARGET != HWY_SCALAR
template <class Tag>
HWY_INLINE void storeSumOfBlocks(Tag tag, hn::Vec<Tag> blocksOfFour, float* to) {
    if constexpr (hn::MaxLanes(Tag()) > 4) {
        const hn::Half<Tag> half;
        storeSumOfBlocks(half, hn::Add(hn::LowerHalf(half, blocksOfFour), hn::UpperHalf(half, blocksOfFour)),
                         to);
    } else {
        hn::StoreU(blocksOfFour, tag, to);
    }
}
#endif

// Writes the four sums over all lanes.
HWY_INLINE void writeSums(Float a, Float b, Float c, Float d, float* to) {
#if HWY_TARGET == HWY_SCALAR
    to[0] = hn::GetLane(a.values);
    to[1] = hn::GetLane(b.values);
    to[2] = hn::GetLane(c.values);
    to[3] = hn::GetLane(d.values);
#else
    // In each block of four lanes first the sums of two lanes, then those of all four: a, b, c, d.
    const FloatTag tag;
    const hn::Repartition<std::uint64_t, FloatTag> pairs;
    const auto ab = hn::BitCast(pairs, hn::Add(hn::InterleaveLower(tag, a.values, b.values),
                                               hn::InterleaveUpper(tag, a.values, b.values)));
    const auto cd = hn::BitCast(pairs, hn::Add(hn::InterleaveLower(tag, c.values, d.values),
                                               hn::InterleaveUpper(tag, c.values, d.values)));
    const auto blocks = hn::Add(hn::BitCast(tag, hn::InterleaveLower(pairs, ab, cd)),
                                hn::BitCast(tag, hn::InterleaveUpper(pairs, ab, cd)));
    storeSumOfBlocks(tag, blocks, to);
#endif
}

HWY_INLINE void write(const LaneSums& sums, float* to) {
    const VectorBlend::ScreenGradient& g = sums.gradient;
    std::array<float, 12> values;
    static_assert(values.size() >= shared::kPairValues);
    writeSums(g.mean.x, g.mean.y, g.conic.x, g.conic.y, values.data());
    writeSums(g.conic.z, g.opacity, g.colour.x, g.colour.y, values.data() + 4);
    writeSums(g.colour.z, sums.weight, sums.pull, 0.0f, values.data() + 8);
    std::copy_n(values.data(), shared::kPairValues, to);
}

}  // namespace

// Writes the sums of all pairs of the tiles of a part.
void sumTiles(const NativeTiles& tiles, std::size_t part, const NativeBack& back) {
    const VectorBlend::SplatView view = viewOf(tiles.frame.view);
    OpenPixels slot(std::min(back.slots.rowsOfSlot, tiles.frame.tileRows), kPlanes);
    ShownVectors shown;
    constexpr std::uint32_t kAhead = 3;
    const std::size_t end = std::min(tiles.count, (part + 1) * NativeTiles::kAtOnce);
    for (std::size_t n = part * NativeTiles::kAtOnce; n < end; ++n) {
        const glm::ivec2 at = tiles.tileOf(n);
        const glm::uvec2 range = tiles.entriesOf(at);
        for (int s = 0; range.x < range.y && s < back.slots.slots; ++s) {
            const int firstRow = s * back.slots.rowsOfSlot;
            const glm::ivec2 firstPixel(at.x * shared::kTileColumns, at.y * tiles.frame.tileRows + firstRow);
            slot.rows = std::min(back.slots.rowsOfSlot, tiles.frame.tileRows - firstRow);
            begin(slot, firstPixel, tiles.frame.view.sizePx, back);
            std::uint32_t i = range.x;
            for (; i < range.y && slot.openCount > 0; ++i) {
                const std::size_t lane = (i - range.x) % kLanes;
                if (lane == 0) shown.find(tiles, i, range.y, firstPixel, slot.rows);
                // The sums of neighbouring entries may be anywhere.
                if (i + kAhead < range.y) __builtin_prefetch(back.sumsOf(tiles.entries[i + kAhead].y, s), 1);
                const float* texels = tiles.screenOf(tiles.entries[i].x);
                write(sumsOver(slot, shown.of(lane), ShownSplat(texels), view),
                      back.sumsOf(tiles.entries[i].y, s));
            }
            for (; i < range.y; ++i)
                std::fill_n(back.sumsOf(tiles.entries[i].y, s), shared::kPairValues, 0.0f);
        }
    }
}

}  // namespace macula::splat::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace macula::splat {

HWY_EXPORT(sumTiles);

gpu::NativeKernel nativeRasterBack(const BackSlots& slots) {
    return [slots](const gpu::NativeDispatch& dispatch) {
        const NativeTiles tiles(dispatch);
        const NativeBack back{slots, dispatch.binding<const glm::vec4>(4).data(),
                              dispatch.binding<const glm::vec4>(5).data(), dispatch.binding<float>(6).data()};
        parallelFor(tiles.parts(), [&](std::size_t part) {
            HWY_DYNAMIC_DISPATCH(sumTiles)(tiles, part, back);
        });
    };
}

}  // namespace macula::splat
#endif
