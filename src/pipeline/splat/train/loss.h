// How far a drawn model is from what it should show, and how each pixel would have to change: on the device.
// What the loss is exactly: loss_options.h.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <variant>

#include "base/result.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/splat/draw/device_picture.h"
#include "pipeline/splat/train/loss_options.h"
#include "shared/splat_loss_params.h"

namespace macula::splat {

// How SSIM is summed over windows. The gradients differ by rounding.
enum class LossWork {
    byStrips,  // kernels for columns and rows, with their sums in the device's memory
    byTiles,   // in the memory that a group of threads shares
};
// By tiles on graphics cards.
LossWork lossWorkOf(const gpu::Device& device);

// The kernels of the loss, for pictures of any size.
struct LossKernels {
    using ByEncoding = std::array<gpu::Kernel, 2>;
    struct Strips {
        int rowOutputs = 0;  // pixels of a row in one strip
        gpu::Kernel columns;
        gpu::Kernel rows;
        gpu::Kernel backColumns;
    };
    struct Tiles {
        ByEncoding terms;
    };
    using Similarity = std::variant<Strips, Tiles>;
    Similarity similarity;
    gpu::Kernel windows;
    ByEncoding compare;
    std::array<std::array<gpu::Kernel, 2>, 2> gradient;  // by LossEncoding, and whether SSIM takes part
    std::array<gpu::Kernel, 2> total;                    // by whether it does
    gpu::Kernel downsample;

    static Result<std::shared_ptr<const LossKernels>> create(const std::shared_ptr<gpu::Device>& device,
                                                             LossWork work);
    static Result<std::shared_ptr<const LossKernels>> create(const std::shared_ptr<gpu::Device>& device) {
        return create(device, lossWorkOf(*device));
    }
};

// A picture to be compared with, and which of its pixels are known. 20 bytes for each pixel on the device.
class LossTarget {
  public:
    // Submits its work; nobody needs to wait for it.
    static Result<LossTarget> create(const LossKernels& kernels, DevicePicture picture);

    const DevicePicture& picture() const { return picture_; }
    // Float for each pixel: 1 / the taps of the SSIM window that fall on known pixels; 0 for unknown ones.
    const gpu::TexelBuffer& windows() const { return windows_; }
    // Pixels that are not finite. Waits.
    Result<std::uint64_t> unknownPixels() const;

  private:
    LossTarget(DevicePicture picture, gpu::TexelBuffer windows)
        : picture_(std::move(picture)), windows_(std::move(windows)) {}

    DevicePicture picture_;
    gpu::TexelBuffer windows_;
};

// The loss of pictures of any shape with at most mostPixels(). Used by one thread at a time, the one that
// uses the device.
class Loss {
  public:
    // outOfMemory when the device cannot hold 180 bytes for each pixel (by tiles 116), or 64 (48) for each in
    // one buffer (DeviceInfo::maxStorageBufferBytes): more than 1400 x 1400 pixels on lavapipe.
    static Result<Loss> create(const std::shared_ptr<gpu::Device>& device,
                               std::shared_ptr<const LossKernels> kernels, std::uint64_t mostPixels);

    std::uint64_t mostPixels() const { return pairs_.elements() / 2; }

    // Both pictures of the same size. What was recorded before must have drawn `render`.
    void record(gpu::Recorder& recorder, const DevicePicture& render, const LossTarget& target,
                const LossOptions& options, const LossStep& step);

    // The gradient by the render's premultiplied RGBA, of what was recorded last, and of its size.
    const DevicePicture& gradient() const { return gradient_; }
    // SplatLossResult, of what was recorded last; the same bits for the same input on the same device.
    const gpu::Buffer& result() const { return result_; }
    // Waits for all that was submitted.
    Result<shared::SplatLossResult> read() const;

  private:
    Loss(std::shared_ptr<const LossKernels> kernels, gpu::Buffer params,
         std::array<gpu::TexelBuffer, 5> scratch, DevicePicture gradient, gpu::Buffer result);

    std::shared_ptr<const LossKernels> kernels_;
    gpu::Buffer params_;
    gpu::TexelBuffer pairs_;      // 2 vec4 for each pixel: render + target as compared, and render - target
    gpu::TexelBuffer means_;      // of strips: 4 vec4, and then 3
    gpu::TexelBuffer terms_;      // 3 vec4
    gpu::TexelBuffer ssimParts_;  // by strip or tile
    gpu::TexelBuffer differenceParts_;
    DevicePicture gradient_;
    gpu::Buffer result_;
};

// `to` becomes `from` made smaller: each pixel the mean over its area, so that odd sizes, and any others,
// keep the mean of the picture and the scale of each axis is exactly the ratio of the sizes. Pixels that are
// not finite are left out of the mean; where there are no others, neither is the result. `to` is no larger
// than `from` in either direction.
void recordDownsample(gpu::Recorder& recorder, const LossKernels& kernels, const DevicePicture& from,
                      const DevicePicture& to);

}  // namespace macula::splat
