// Draws splats on the device, and finds how each parameter would have to change for the picture to change:
// the same kernels for showing a model and for training it. What a picture of splats is exactly is told by
// shaders/lib/splat_projection.glsl and splat_blend.glsl; reference_rasterizer.h is the slow form of the
// same.
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

// A picture of splats that was recorded: what finding its derivatives, and asking whether it is right, need.
// It ends with the next picture of its rasterizer.
class RasterPass {
  public:
    // Pairs of splats and tiles in it; of one that is not settled 0.
    std::uint64_t pairCount() const { return isSettled_ ? pairs_ : 0; }

  private:
    friend class Rasterizer;
    std::uint64_t serial_ = 0;
    std::uint32_t splats_ = 0;
    std::uint64_t pairs_ = 0;      // of one that is not settled: for how many the lists have room
    std::uint64_t mostPairs_ = 0;  // that the lists may be made to have room for
    bool isSettled_ = true;
};

// Used by one thread at a time, the one that uses the device.
class Rasterizer {
  public:
    // For models of that capacity and degree.
    static Result<Rasterizer> create(const std::shared_ptr<gpu::Device>& device, std::uint32_t capacity,
                                     int shDegree, const RasterShape& shape = {});

    // Draws the first `count` splats. The view and the blending must be valid. Waits, for the projection,
    // whose result is sorted on the host, or for all where the device makes the lists; the picture is done
    // when what was submitted is. outOfMemory when there are too many pairs of splats and tiles, or the
    // picture is too large; then there is no picture until the next draw that succeeds. `submitted` (may be
    // empty) is told after the work of each stage was submitted, to measure it: where it fails, so does this.
    using Submitted = std::function<Result<void>(DrawStage)>;
    Result<RasterPass> draw(const SplatBuffer& parameters, std::uint32_t count, const RasterView& view,
                            const Blending& blending, const Submitted& submitted = {});

    // Lists are made on the device, and recordDraw is there.
    bool listsOnDevice() const { return deviceLists_.has_value(); }
    // Draws as draw does, without waiting for anything. Whether there was room for all pairs is known when it
    // is done; if not, the picture is empty and no splat shows in it.
    Result<RasterPass> recordDraw(gpu::Recorder& recorder, const SplatBuffer& parameters, std::uint32_t count,
                                  const RasterView& view, const Blending& blending);
    // After what was recorded is submitted, waits: true when the picture is right. False: now there is room,
    // record it again. outOfMemory as draw. True of what draw made.
    Result<bool> settle(RasterPass& pass);

    // Draws splats that projectOnHost has projected. Nothing can be differentiated then.
    Result<void> drawProjected(std::span<const glm::vec4> screen, const RasterView& view,
                               const Blending& blending);

    // The picture of the last view, until the next is drawn. Premultiplied; a is the coverage.
    const DevicePicture& picture() const { return *picture_; }
    // Float for each pixel, perhaps more: sum of weight times depth of the centre, mm; over a, the mean.
    const gpu::Buffer& depths() const { return *depths_; }
    // The tile lists on the device, with room for more than there are: TileLists has their order.
    const TileBuffers& tileLists() const { return tileBuffers_; }

    // The backward pass of the last picture, with the same parameters: the derivative of the loss by each
    // parameter, from that by the picture (its rgb, and its coverage in a). Splats that do not show keep the
    // gradients they had. Of degree 0 or 1.
    Result<void> recordBackward(gpu::Recorder& recorder, const RasterPass& pass,
                                const SplatBuffer& parameters, const DevicePicture& gradient,
                                SplatBuffer& gradients);
    // A uint for each splat, not 0 for those that showed when recordBackward was last done.
    const gpu::Buffer& visible() const { return visible_; }
    // SplatStatistics for each splat, summed by every recordBackward since they were cleared.
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
    std::optional<gpu::TexelBuffer> hostScreen_;  // what was projected on the host
    std::optional<gpu::TexelBuffer> pairs_;       // the derivatives of pairs of splat and tile
    std::optional<DevicePicture> picture_;
    std::optional<gpu::Buffer> depths_;
    std::vector<glm::vec4> screenCopy_;  // where the host cannot read the device's
    std::uint64_t serial_ = 0;           // of the last pass
    glm::ivec2 tiles_{0};                // of its picture
    TileLists lists_;                    // of the host
};

}  // namespace macula::splat
