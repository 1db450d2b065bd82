// A training picture on the device, in all sizes in which it is compared.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/splat/train/loss.h"
#include "pipeline/splat/train/training_view.h"

namespace macula::splat {

struct PictureLevel {
    RasterView view;
    LossTarget target;
};

// Used by one thread at a time, the one that uses the device.
class PicturePyramid {
  public:
    // usage as validate(RasterView); inputNotUsable when the picture is not of the view's size, has no finite
    // pixel, or its weight is not above 0 and at most kMaxViewWeight; outOfMemory.
    static Result<PicturePyramid> upload(const std::shared_ptr<gpu::Device>& device,
                                         const LossKernels& kernels, const TrainingView& given);

    const PictureLevel& whole() const { return levels_.front(); }
    // The picture with each side halved `times` times (0: full size), or as often as no side falls below 16
    // pixels. Made on first use; valid until the next call.
    Result<const PictureLevel*> halved(int times, const LossKernels& kernels);

  private:
    PicturePyramid(std::shared_ptr<gpu::Device> device, PictureLevel whole) : device_(std::move(device)) {
        levels_.push_back(std::move(whole));
    }

    std::shared_ptr<gpu::Device> device_;
    std::vector<PictureLevel> levels_;
};

}  // namespace macula::splat
