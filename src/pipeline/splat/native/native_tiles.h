// What the native kernels of pictures (native_raster.h, native_raster_back.h) have in common: the lists of
// tiles, and the memory for the pixels of one tile.
#pragma once

#include <hwy/aligned_allocator.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <new>
#include <span>

#include "pipeline/gpu/native_kernel.h"
#include "shared/splat_frame.h"

namespace macula::splat {

// Pixels whose numbers lie together: as many as the longest vector has lanes.
inline constexpr std::size_t kLinePixels = 16;

// Some numbers for each pixel of a block kTileColumns wide, row by row: of each kLinePixels pixels all first
// numbers, then all second numbers and so on. Rows beyond the last fill the last line.
class PixelBlock {
  public:
    PixelBlock(int rows, std::size_t numbers)
        : numbers_(numbers),
          lines_((static_cast<std::size_t>(rows) * shared::kTileColumns + kLinePixels - 1) / kLinePixels),
          values_(hwy::AllocateAligned<float>(lines_ * numbers * kLinePixels)) {
        if (!values_) throw std::bad_alloc();
    }

    std::size_t pixels() const { return lines_ * kLinePixels; }
    // The first number of a pixel; the next is kLinePixels further on.
    float* at(std::size_t pixel) {
        return values_.get() + pixel / kLinePixels * (numbers_ * kLinePixels) + pixel % kLinePixels;
    }

  private:
    std::size_t numbers_;
    std::size_t lines_;
    hwy::AlignedFreeUniquePtr<float[]> values_;
};

// The bindings that raster.comp and raster_back.comp share.
struct NativeTiles {
    explicit NativeTiles(const gpu::NativeDispatch& dispatch)
        : frame(dispatch.binding<const shared::SplatFrame>(0).front()),
          columns(static_cast<int>(dispatch.groups()[0])),
          count(std::size_t(dispatch.groups()[0]) * dispatch.groups()[1]),
          screen(dispatch.binding<const float>(1)),
          ranges(dispatch.binding<const glm::uvec2>(2)),
          entries(dispatch.binding<const glm::uvec2>(3)) {}

    shared::SplatFrame frame;
    int columns;
    std::size_t count;
    std::span<const float> screen;  // of each splat its texels, see screen.glsl
    std::span<const glm::uvec2> ranges;
    std::span<const glm::uvec2> entries;

    // Tiles that are worked on in turns by one thread.
    static constexpr std::size_t kAtOnce = 16;
    std::size_t parts() const { return (count + kAtOnce - 1) / kAtOnce; }

    glm::ivec2 tileOf(std::size_t n) const {
        const auto tile = static_cast<int>(n);
        return {tile % columns, tile / columns};
    }
    glm::uvec2 entriesOf(const glm::ivec2& tile) const {
        return ranges[static_cast<std::size_t>(tile.y * frame.tiles.x + tile.x)];
    }
    const float* screenOf(std::uint32_t splat) const {
        return &screen[std::size_t(splat) * shared::kScreenTexels * 4];
    }
};

}  // namespace macula::splat
