// Computes on the device how far a drawn model is from its target, and the gradient by each pixel.
// loss_options.h defines the loss exactly.
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

// How SSIM is summed over windows. The gradients of both ways differ by rounding.
enum class LossWork {
    byStrips,  // kernels for columns and rows, with their sums in the device's memory
    byTiles,   // in the shared memory of a workgroup
};
// byTiles on graphics cards with enough shared memory, and where kernels run natively; else byStrips.
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
    std::array<std::array<gpu::Kernel, 2>, 2> gradient;  // by LossEncoding, and by whether the loss has SSIM
    std::array<gpu::Kernel, 2> total;                    // by whether the loss has SSIM
    gpu::Kernel downsample;

    static Result<std::shared_ptr<const LossKernels>> create(const std::shared_ptr<gpu::Device>& device,
                                                             LossWork work);
    static Result<std::shared_ptr<const LossKernels>> create(const std::shared_ptr<gpu::Device>& device) {
        return create(device, lossWorkOf(*device));
    }
};

// A target picture, and which of its pixels are known. Takes 20 bytes for each pixel on the device.
class LossTarget {
  public:
    // Submits its work; nobody needs to wait for it.
    static Result<LossTarget> create(const LossKernels& kernels, DevicePicture picture);

    const DevicePicture& picture() const { return picture_; }
    // Float for each pixel: 1 / the sum of the taps of its SSIM window that fall on known pixels; 0 for
    // unknown pixels.
    const gpu::TexelBuffer& windows() const { return windows_; }
    // The number of pixels that are not finite. Waits.
    Result<std::uint64_t> unknownPixels() const;

  private:
    LossTarget(DevicePicture picture, gpu::TexelBuffer windows)
        : picture_(std::move(picture)), windows_(std::move(windows)) {}

    DevicePicture picture_;
    gpu::TexelBuffer windows_;
};

// Computes the loss of pictures of any shape with at most mostPixels() pixels. Used by one thread at a time,
// the one that uses the device.
class Loss {
  public:
    // outOfMemory when the device cannot hold 180 bytes for each pixel (by tiles 116), or 64 (48) for each in
    // one buffer (DeviceInfo::maxStorageBufferBytes): more than 1400 x 1400 pixels on lavapipe.
    static Result<Loss> create(const std::shared_ptr<gpu::Device>& device,
                               std::shared_ptr<const LossKernels> kernels, std::uint64_t mostPixels);

    std::uint64_t mostPixels() const { return pairs_.elements() / 2; }

    // Records the loss. Both pictures must have the same size, and earlier work must draw `render`.
    void record(gpu::Recorder& recorder, const DevicePicture& render, const LossTarget& target,
                const LossOptions& options, const LossStep& step);

    // The gradient by the render's premultiplied RGBA, from the last record(), in its size.
    const DevicePicture& gradient() const { return gradient_; }
    // The SplatLossResult of the last record(); the same bits for the same input on the same device.
    const gpu::Buffer& result() const { return result_; }
    // Waits for all submitted work.
    Result<shared::SplatLossResult> read() const;

  private:
    Loss(std::shared_ptr<const LossKernels> kernels, gpu::Buffer params,
         std::array<gpu::TexelBuffer, 5> scratch, DevicePicture gradient, gpu::Buffer result);

    std::shared_ptr<const LossKernels> kernels_;
    gpu::Buffer params_;
    gpu::TexelBuffer pairs_;  // 2 vec4 for each pixel: sum and difference of render and target, as compared
    gpu::TexelBuffer means_;  // for strips: first 4 vec4 for each pixel, then 3
    gpu::TexelBuffer terms_;  // 3 vec4 for each pixel
    gpu::TexelBuffer ssimParts_;  // a part for each strip or tile
    gpu::TexelBuffer differenceParts_;
    DevicePicture gradient_;
    gpu::Buffer result_;
};

// Downsamples `from` into `to`, which must not be larger in either direction: each pixel becomes the mean
// over its area, so that any sizes, odd ones too, keep the mean of the picture, and the scale of each axis is
// exactly the ratio of the sizes. Pixels that are not finite are left out of the mean; if there are no
// others, the result is not finite.
void recordDownsample(gpu::Recorder& recorder, const LossKernels& kernels, const DevicePicture& from,
                      const DevicePicture& to);

}  // namespace macula::splat
