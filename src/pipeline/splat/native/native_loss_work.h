// What the native kernels of the loss (native_loss.h) work on: the bindings of their shaders, and rows of
// pixels of a strip.
#pragma once

#include <hwy/aligned_allocator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <new>

#include "pipeline/gpu/native_kernel.h"
#include "shared/splat_loss_params.h"

namespace macula::splat {

inline constexpr int kLossTile = 16;    // rows and columns of pixels of a part of the loss
inline constexpr int kWindowReach = 5;  // pixels of an SSIM window to each side

// One strip is a row of tiles: a thread does one at a time.
struct LossPicture {
    explicit LossPicture(const gpu::NativeDispatch& dispatch)
        : params(dispatch.binding<const shared::SplatLossParams>(0).front()),
          width(static_cast<std::size_t>(params.imageSize.x)),
          height(static_cast<std::size_t>(params.imageSize.y)) {}

    shared::SplatLossParams params;
    std::size_t width;
    std::size_t height;
    bool display = false;  // how pictures are compared
    bool similar = true;   // the loss includes SSIM

    std::size_t strips() const { return (height + kLossTile - 1) / kLossTile; }
    std::size_t tiles() const { return (width + kLossTile - 1) / kLossTile; }  // of a strip
    std::size_t firstRow(std::size_t strip) const { return strip * kLossTile; }
    std::size_t endRow(std::size_t strip) const { return std::min(height, firstRow(strip) + kLossTile); }
};

// Both pictures, and where they are compared. Four numbers for each pixel, pairs eight.
struct LossCompare {
    LossPicture of;
    const float* rendered;
    const float* targets;
    const float* windows;  // one number for each pixel
    float* pairs;
};

struct LossTerms {
    LossPicture of;
    const float* windows;
    const float* pairs;
    float* terms;  // 12 numbers for each pixel
    float* parts;  // one for each tile
};

struct LossGradient {
    LossPicture of;
    const float* terms;
    const float* pairs;
    const float* windows;
    const float* rendered;
    float* gradients;
    float* parts;  // four for each tile
};

// A row of numbers with zeros on both sides, so that vectors and windows may reach over its ends.
class PaddedRow {
  public:
    // `numbers` of each pixel.
    PaddedRow(std::size_t pixels, std::size_t numbers)
        : numbers_(numbers), values_(hwy::AllocateAligned<float>((pixels + 2 * kPixelsAround) * numbers)) {
        if (!values_) throw std::bad_alloc();
        std::fill_n(values_.get(), (pixels + 2 * kPixelsAround) * numbers, 0.0f);
    }

    float* data() { return values_.get() + kPixelsAround * numbers_; }
    // Of pixels; what is beside them stays 0.
    void read(const float* from, std::size_t pixels) { std::copy_n(from, pixels * numbers_, data()); }

  private:
    static constexpr std::size_t kPixelsAround = 16;  // as many as a vector has lanes, and more than a window

    std::size_t numbers_;
    hwy::AlignedFreeUniquePtr<float[]> values_;
};

// The rows of a window around `row`, of `numbers` each; `zeros` beyond the picture.
using WindowRows = std::array<const float*, 2 * kWindowReach + 1>;
inline WindowRows windowRows(const float* picture, std::size_t numbers, std::size_t row, std::size_t height,
                             const float* zeros) {
    WindowRows rows;
    for (std::size_t n = 0; n < rows.size(); ++n) {
        const std::size_t at = row + n;  // kWindowReach too large
        rows[n] = at >= kWindowReach && at - kWindowReach < height ? picture + (at - kWindowReach) * numbers
                                                                   : zeros;
    }
    return rows;
}

}  // namespace macula::splat
