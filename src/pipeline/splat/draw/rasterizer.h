// Draws splats on the device, and computes the derivatives of the loss by their parameters: the same kernels
// serve viewing and training. shaders/lib/splat_projection.glsl and splat_blend.glsl define the picture
// exactly; reference_rasterizer.h is its slow implementation.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "base/result.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/splat/draw/device_picture.h"
#include "pipeline/splat/draw/device_tile_lists.h"
#include "pipeline/splat/draw/raster_kernels.h"
#include "pipeline/splat/draw/raster_shape.h"
#include "pipeline/splat/draw/raster_view.h"
#include "pipeline/splat/draw/tile_buffers.h"
#include "pipeline/splat/draw/tile_lists.h"
#include "pipeline/splat/model/splat_buffer.h"
#include "shared/splat_frame.h"

namespace macula::splat {

// The stages of drawing.
enum class DrawStage { project, lists, raster };

// A recorded picture of splats, as needed to compute its derivatives and to check whether it is complete. It
// is valid until its rasterizer draws the next picture.
class RasterPass {
  public:
    // The number of pairs of splat and tile in it; 0 while it is not settled.
    std::uint64_t pairCount() const { return isSettled_ ? pairs_ : 0; }

  private:
    friend class Rasterizer;
    std::uint64_t serial_ = 0;
    std::uint32_t splats_ = 0;
    std::uint64_t pairs_ = 0;      // while it is not settled: the room in the lists
    std::uint64_t mostPairs_ = 0;  // to which the lists may grow
    bool isSettled_ = true;
};

// Used by one thread at a time, the one that uses the device.
class Rasterizer {
  public:
    // For models of up to `capacity` splats, and of that degree.
    static Result<Rasterizer> create(const std::shared_ptr<gpu::Device>& device, std::uint32_t capacity,
                                     int shDegree, const RasterShape& shape = {});

    // Draws the first `count` splats. The view and the blending must be valid. If the host makes the lists,
    // waits for the projection, which it sorts, and the picture is done when the submitted work is; if the
    // device makes them, waits for the whole picture. outOfMemory when there are too many pairs of splat and
    // tile, or the picture is too large; then there is no picture until the next draw succeeds. Calls
    // `submitted` (may be empty) after submitting each stage, to measure it; its error ends this.
    using Submitted = std::function<Result<void>(DrawStage)>;
    Result<RasterPass> draw(const SplatBuffer& parameters, std::uint32_t count, const RasterView& view,
                            const Blending& blending, const Submitted& submitted = {});

    // Whether the device makes the lists; only then recordDraw may be called.
    bool listsOnDevice() const { return deviceLists_.has_value(); }
    // Draws as draw does, without waiting for anything. Whether there was room for all pairs is known only
    // once the picture is done; without room it is empty, and no splat shows in it.
    Result<RasterPass> recordDraw(gpu::Recorder& recorder, const SplatBuffer& parameters, std::uint32_t count,
                                  const RasterView& view, const Blending& blending);
    // Call after submitting the recorded picture; waits. True if the picture is complete. False if it had no
    // room: now there is room, so record it again. outOfMemory as draw. Always true for a picture from draw.
    Result<bool> settle(RasterPass& pass);

    // Draws splats that projectOnHost has projected. Such a picture has no backward pass.
    Result<void> drawProjected(std::span<const glm::vec4> screen, const RasterView& view,
                               const Blending& blending);

    // The picture of the last view, until the next is drawn. Premultiplied; a is the coverage.
    const DevicePicture& picture() const { return *picture_; }
    // Float for each pixel, in a buffer that may have more: sum of weight times depth of the centre, in mm;
    // divided by the coverage, the mean depth.
    const gpu::Buffer& depths() const { return *depths_; }
    // The tile lists on the device, in buffers that may have more room; in the order of TileLists.
    const TileBuffers& tileLists() const { return tileBuffers_; }

    // The backward pass of the last picture, with the same parameters: from `gradient`, the derivative of the
    // loss by the picture (its rgb, and its coverage in a), computes the derivative by each parameter.
    // Gradients of splats that do not show stay unchanged. For degrees 0 and 1.
    Result<void> recordBackward(gpu::Recorder& recorder, const RasterPass& pass,
                                const SplatBuffer& parameters, const DevicePicture& gradient,
                                SplatBuffer& gradients);
    // A uint for each splat, not 0 if the splat showed when recordBackward was last done.
    const gpu::Buffer& visible() const { return visible_; }
    // SplatStatistics for each splat, summed by every recordBackward since clearStatistics.
    const gpu::Buffer& statistics() const { return statistics_; }
    void clearStatistics(gpu::Recorder& recorder) { recorder.fill(statistics_, 0u); }

  private:
    Rasterizer(std::shared_ptr<gpu::Device> device, std::uint32_t capacity, RasterShape shape,
               RasterKernels kernels, gpu::Buffer frame, gpu::TexelBuffer screen, TileBuffers tileBuffers,
               std::optional<DeviceTileLists> deviceLists, gpu::Buffer visible, gpu::Buffer statistics);

    shared::SplatFrame frameOf(const RasterView& view, const Blending& blending) const;
    Result<void> inOne(const char* label, const std::function<Result<void>(gpu::Recorder&)>& record);
    void recordProject(gpu::Recorder& recorder, const SplatBuffer& parameters, std::uint32_t count,
                       const RasterView& view, const Blending& blending);
    RasterPass beginPass(std::uint32_t splats);
    Result<void> recordLists(gpu::Recorder& recorder, std::uint64_t mostPairs, RasterPass& pass);
    gpu::Threads tileThreads() const;
    void recordRaster(gpu::Recorder& recorder, const gpu::TexelBuffer& screen);
    Result<std::span<const glm::vec4>> readScreen(std::uint32_t count);
    Result<void> sortOnHost(std::span<const glm::vec4> screen, const RasterView& view,
                            const Blending& blending, bool withPairs, RasterPass& pass);
    Result<void> makePicture(glm::ivec2 sizePx);

    std::shared_ptr<gpu::Device> device_;
    std::uint32_t capacity_;
    RasterShape shape_;
    RasterKernels kernels_;
    gpu::Buffer frame_;
    gpu::TexelBuffer screen_;
    TileBuffers tileBuffers_;
    std::optional<DeviceTileLists> deviceLists_;
    gpu::Buffer visible_;
    gpu::Buffer statistics_;
    std::optional<gpu::TexelBuffer> hostScreen_;  // splats that the host projected
    std::optional<gpu::TexelBuffer> pairs_;       // the derivatives of pairs of splat and tile
    std::optional<DevicePicture> picture_;
    std::optional<gpu::Buffer> depths_;
    std::vector<glm::vec4> screenCopy_;  // a copy, if the host cannot read the device's
    std::uint64_t serial_ = 0;           // of the last pass
    glm::ivec2 tiles_{0};                // of the last pass
    TileLists lists_;                    // made on the host
};

}  // namespace macula::splat
