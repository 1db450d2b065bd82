#include "pipeline/splat/native/native_raster.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/splat/native/native_raster.cpp"
#include <hwy/foreach_target.h>  // first
#include <hwy/highway.h>

#include <vector>

#include "base/parallel.h"
#include "pipeline/splat/native/native_tiles.h"
#include "pipeline/splat/native/vector_splats.h"

#ifndef MACULA_SPLAT_NATIVE_RASTER_PICTURE
#define MACULA_SPLAT_NATIVE_RASTER_PICTURE
namespace macula::splat {

// What the kernel writes.
struct NativePicture {
    glm::vec4* picture;
    float* depths;
};

}  // namespace macula::splat
#endif

HWY_BEFORE_NAMESPACE();
namespace macula::splat::HWY_NAMESPACE {
namespace {

// The numbers of a pixel in a PixelBlock.
enum Plane : std::size_t { kX, kY, kTransmittance, kRed, kGreen, kBlue, kDepth, kPlanes };

void begin(OpenPixels& tile, const glm::ivec2& firstPixel) {
    tile.moveTo(firstPixel);
    for (std::size_t v = 0; v < tile.open.size(); ++v) {
        float* pixel = tile.block.at(v * kLanes);
        store(1.0f, pixel, kTransmittance);
        for (const Plane plane : {kRed, kGreen, kBlue, kDepth}) store(0.0f, pixel, plane);
    }
}

HWY_INLINE void blend(OpenPixels& tile, const VectorRange& vectors, const ShownSplat& shown,
                      const VectorBlend::SplatView& view) {
    VectorBlend maths;
    for (auto v = std::size_t(vectors.first); v < std::size_t(vectors.end); ++v) {
        if (tile.open[v] == 0) continue;
        float* pixel = tile.block.at(v * kLanes);
        Float transmittance = loaded(pixel, kTransmittance);
        const Float raw = maths.rawAlphaAt(shown.screen, Vec2(loaded(pixel, kX), loaded(pixel, kY)));
        const Float weight = maths.takeWeight(transmittance, maths.limitedAlpha(raw, view), view);
        store(transmittance, pixel, kTransmittance);
        store(loaded(pixel, kRed) + shown.colour.x * weight, pixel, kRed);
        store(loaded(pixel, kGreen) + shown.colour.y * weight, pixel, kGreen);
        store(loaded(pixel, kBlue) + shown.colour.z * weight, pixel, kBlue);
        store(loaded(pixel, kDepth) + shown.screen.depthMm * weight, pixel, kDepth);
        if (!(transmittance >= view.minTransmittance).none()) continue;
        tile.close(v);
    }
}

// Writes those of the tile's pixels that are in the picture.
void write(OpenPixels& tile, const glm::ivec2& sizePx, const NativePicture& to) {
    const RowTag tag;
    const glm::ivec2 firstPixel = tile.firstPixel;
    const int columns = std::min(shared::kTileColumns, sizePx.x - firstPixel.x);
    const int rows = std::min(tile.rows, sizePx.y - firstPixel.y);
    for (int row = 0; row < rows; ++row) {
        const std::size_t first = static_cast<std::size_t>(firstPixel.y + row) * std::size_t(sizePx.x) +
                                  static_cast<std::size_t>(firstPixel.x);
        const float* pixel = tile.block.at(static_cast<std::size_t>(row) * shared::kTileColumns);
        const auto number = [&](Plane plane, int column) {
            return pixel[plane * kLinePixels + static_cast<std::size_t>(column)];
        };
        int column = 0;
        for (; columns == shared::kTileColumns && column < columns; column += int(hn::Lanes(tag))) {
            const float* from = pixel + column;
            float* rgba = &to.picture[first + static_cast<std::size_t>(column)].x;
            hn::StoreInterleaved4(
                hn::LoadU(tag, from + kRed * kLinePixels), hn::LoadU(tag, from + kGreen * kLinePixels),
                hn::LoadU(tag, from + kBlue * kLinePixels),
                hn::Sub(hn::Set(tag, 1.0f), hn::LoadU(tag, from + kTransmittance * kLinePixels)), tag, rgba);
        }
        for (; column < columns; ++column)
            to.picture[first + static_cast<std::size_t>(column)] = {
                number(kRed, column), number(kGreen, column), number(kBlue, column),
                1.0f - number(kTransmittance, column)};
        std::copy_n(pixel + kDepth * kLinePixels, columns, to.depths + first);
    }
}

}  // namespace

// Draws the tiles of a part.
void drawTiles(const NativeTiles& tiles, std::size_t part, const NativePicture& to) {
    const VectorBlend::SplatView view = viewOf(tiles.frame.view);
    OpenPixels tile(tiles.frame.tileRows, kPlanes);
    ShownVectors shown;
    const std::size_t end = std::min(tiles.count, (part + 1) * NativeTiles::kAtOnce);
    for (std::size_t n = part * NativeTiles::kAtOnce; n < end; ++n) {
        const glm::ivec2 at = tiles.tileOf(n);
        const glm::ivec2 firstPixel = at * glm::ivec2(shared::kTileColumns, tile.rows);
        begin(tile, firstPixel);
        const glm::uvec2 range = tiles.entriesOf(at);
        for (std::uint32_t i = range.x; i < range.y && tile.openCount > 0; ++i) {
            const std::size_t lane = (i - range.x) % kLanes;
            if (lane == 0) shown.find(tiles, i, range.y, firstPixel, tile.rows);
            const float* texels = tiles.screenOf(tiles.entries[i].x);
            blend(tile, shown.of(lane), ShownSplat(texels), view);
        }
        write(tile, tiles.frame.view.sizePx, to);
    }
}

}  // namespace macula::splat::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace macula::splat {

HWY_EXPORT(drawTiles);

gpu::NativeKernel nativeRaster() {
    return [](const gpu::NativeDispatch& dispatch) {
        const NativeTiles tiles(dispatch);
        const NativePicture to{dispatch.binding<glm::vec4>(4).data(), dispatch.binding<float>(5).data()};
        parallelFor(tiles.parts(), [&](std::size_t part) {
            HWY_DYNAMIC_DISPATCH(drawTiles)(tiles, part, to);
        });
    };
}

}  // namespace macula::splat
#endif
