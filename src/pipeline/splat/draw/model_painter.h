// Draws pictures of any size of one model that does not change: for viewing, not for training.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "pipeline/splat/draw/rasterizer.h"
#include "pipeline/splat/model/splats.h"

namespace macula::splat {

// Row 0 on top.
struct SplatPicture {
    glm::ivec2 sizePx{0};
    std::vector<glm::vec4> rgba;   // premultiplied, in the model's colour space; a is the coverage
    std::vector<float> depthSums;  // sum of weight times depth of the centre in mm
};

// Keeps a model that fits the device's buffers there; of a larger one (on lavapipe more than 2.3 million
// splats of degree 0, 0.5 of degree 3), the host projects the splats that each view shows. The two pictures
// differ only by rounding.
class ModelPainter {
  public:
    // `splats` must be valid, and outlive the painter unchanged; it may be empty.
    enum class Projection { wherever, onHost };
    static Result<ModelPainter> create(const std::shared_ptr<gpu::Device>& device, const Splats& splats,
                                       Projection projection = Projection::wherever);

    // Draws a picture that stays on the device, in the model's colour space, until the next one is drawn; it
    // is done when the submitted work is. The view must be valid. outOfMemory when the picture, or the
    // visible part of the model, is too large for the device.
    Result<const DevicePicture*> drawOnDevice(const RasterView& view);
    // The depths of that picture: see Rasterizer::depths.
    const gpu::Buffer& depthsOnDevice() const { return rasterizer_.depths(); }
    // Draws a picture of any size and reads it back: one of more than `mostPixels` is drawn in bands of whole
    // rows, from top to bottom, and only one band is in memory at a time. An error from `take` ends this.
    // outOfMemory when the visible part of a band is too large for the device.
    using Take = std::function<Result<void>(const SplatPicture& band)>;
    Result<void> drawBands(const RasterView& view, const Take& take,
                           std::uint64_t mostPixels = kMostPixelsAtOnce);
    // Draws the whole picture at once.
    Result<SplatPicture> draw(const RasterView& view);

    // The number of pixels that fit the smallest buffers that Vulkan allows, 128 MiB; more than a row of
    // kMaxRasterSide.
    static constexpr std::uint64_t kMostPixelsAtOnce = (std::uint64_t(1) << 27) / sizeof(glm::vec4);

    bool projectsOnHost() const { return !parameters_.has_value(); }

  private:
    ModelPainter(const Splats* splats, std::optional<SplatBuffer> parameters, Rasterizer rasterizer)
        : splats_(splats), parameters_(std::move(parameters)), rasterizer_(std::move(rasterizer)) {}

    const Splats* splats_;
    std::optional<SplatBuffer> parameters_;
    Rasterizer rasterizer_;
};

}  // namespace macula::splat
