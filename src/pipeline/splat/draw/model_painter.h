// Pictures of one model that does not change, of whatever size: for those who only look.
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

// A model that fits the device's buffers is kept there; of a larger one (on lavapipe more than 2.3 million
// splats of degree 0, 0.5 of degree 3) the host projects what each view shows. Pictures differ by rounding
// only.
class ModelPainter {
  public:
    // `splats` must be valid, and outlive the painter unchanged; it may be empty.
    enum class Projection { wherever, onHost };
    static Result<ModelPainter> create(const std::shared_ptr<gpu::Device>& device, const Splats& splats,
                                       Projection projection = Projection::wherever);

    // The view must be valid. It stays on the device, in the model's colour space, until the next one is
    // drawn; done when what was submitted is. outOfMemory when the picture, or what shows in it, is too large
    // for the device.
    Result<const DevicePicture*> drawOnDevice(const RasterView& view);
    // Of that picture: Rasterizer::depths.
    const gpu::Buffer& depthsOnDevice() const { return rasterizer_.depths(); }
    // The same, read, of any size: a picture of more than `mostPixels` is drawn in bands of whole rows, from
    // top to bottom, and no more than one is held. What `take` returns as an error ends it. outOfMemory when
    // what shows in a band is too much for the device.
    using Take = std::function<Result<void>(const SplatPicture& band)>;
    Result<void> drawBands(const RasterView& view, const Take& take,
                           std::uint64_t mostPixels = kMostPixelsAtOnce);
    // Draws the whole picture at once.
    Result<SplatPicture> draw(const RasterView& view);

    // The pixels that fit the smallest buffers that Vulkan allows, 128 MiB; one row of kMaxRasterSide is
    // less.
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
