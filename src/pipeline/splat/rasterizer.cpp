#include "pipeline/splat/rasterizer.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "pipeline/gpu/transfer.h"
#include "shaders/splat.h"

namespace macula::splat {

namespace {

using shared::kPairValues;
using shared::kScreenTexels;

constexpr VkBufferUsageFlags kBothUses =
    VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

RasterShape chosenShape(const RasterShape& asked, const gpu::Device& device) {
    if (asked.tileRows > 0) return asked;
    // A tile of a graphics card is as many threads as it runs together: 8 x 4.
    return device.isCpu() ? RasterShape{.tileRows = 16, .rowsPerThread = 16}
                          : RasterShape{.tileRows = 8, .rowsPerThread = 2};
}

// One that has room for `elements`: the same, or a larger one.
Result<void> makeRoom(std::optional<gpu::TexelBuffer>& texels, const std::shared_ptr<gpu::Device>& device,
                      const char* label, VkFormat format, std::uint64_t elements, VkBufferUsageFlags usage) {
    if (texels && texels->elements() >= elements) return {};
    const std::uint64_t room = std::max<std::uint64_t>(elements + elements / 2, 1024);
    texels.reset();
    MACULA_TRY(texels, gpu::TexelBuffer::create(
                           device, {.label = label, .elements = room, .format = format, .usage = usage}));
    return {};
}

}  // namespace

Rasterizer::Rasterizer(std::shared_ptr<gpu::Device> device, std::uint32_t capacity, RasterShape shape,
                       int slots, Kernels kernels, gpu::Buffer frame, gpu::TexelBuffer screen,
                       gpu::TexelBuffer pairRanges, gpu::Buffer visible, gpu::Buffer statistics)
    : device_(std::move(device)),
      capacity_(capacity),
      shape_(shape),
      slots_(slots),
      kernels_(std::move(kernels)),
      frame_(std::move(frame)),
      screen_(std::move(screen)),
      pairRanges_(std::move(pairRanges)),
      visible_(std::move(visible)),
      statistics_(std::move(statistics)) {}

Result<Rasterizer> Rasterizer::create(const std::shared_ptr<gpu::Device>& device, std::uint32_t capacity,
                                      int shDegree, const RasterShape& askedShape) {
    MACULA_CHECK_LT(0u, capacity);
    const RasterShape shape = chosenShape(askedShape, *device);
    MACULA_CHECK_EQ(shape.tileRows % shape.rowsPerThread, 0);
    const int threadRows = shape.tileRows / shape.rowsPerThread;
    const int subgroup = static_cast<int>(device->info().subgroupSize);
    MACULA_CHECK_LE(8, subgroup);
    const int threads = shared::kTileColumns * threadRows;
    const int slots = (threads + subgroup - 1) / subgroup;

    const std::vector<gpu::Specialization> tile{{"kRows", shape.rowsPerThread}, {2u, threadRows}};
    const std::vector<gpu::Specialization> degree{{"kDegree", shDegree}};
    std::vector<gpu::Specialization> tileSlots = tile;
    tileSlots.emplace_back("kSlots", slots);
    std::vector<gpu::Specialization> degreeSlots = degree;
    degreeSlots.emplace_back("kSlots", slots);
    MACULA_TRY(gpu::Kernel project,
               gpu::Kernel::create(device, shaders::splat_project_comp, {.specializations = degree}));
    MACULA_TRY(gpu::Kernel raster,
               gpu::Kernel::create(device, shaders::splat_raster_comp, {.specializations = tile}));
    Kernels kernels{.project = std::move(project), .raster = std::move(raster)};
    if (shDegree <= 1) {
        MACULA_TRY(kernels.rasterBack, gpu::Kernel::create(device, shaders::splat_raster_back_comp,
                                                           {.specializations = tileSlots}));
        MACULA_TRY(kernels.gather,
                   gpu::Kernel::create(device, shaders::splat_gather_comp, {.specializations = degreeSlots}));
    }
    MACULA_TRY(gpu::Buffer frame,
               gpu::Buffer::create(device, {.label = "splat frame", .bytes = sizeof(shared::SplatFrame)}));
    MACULA_TRY(gpu::TexelBuffer screen,
               gpu::TexelBuffer::create(device, {.label = "splats in the picture",
                                                 .elements = std::uint64_t(capacity) * kScreenTexels,
                                                 .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                                                 .usage = kBothUses}));
    MACULA_TRY(
        gpu::TexelBuffer pairRanges,
        gpu::TexelBuffer::create(
            device, {.label = "pairs of splats", .elements = capacity, .format = VK_FORMAT_R32G32_UINT}));
    MACULA_TRY(gpu::Buffer visible, gpu::Buffer::create(device, {.label = "visible splats",
                                                                 .bytes = std::uint64_t(capacity) * 4}));
    MACULA_TRY(
        gpu::Buffer statistics,
        gpu::Buffer::create(device, {.label = "statistics of splats",
                                     .bytes = std::uint64_t(capacity) * sizeof(shared::SplatStatistics)}));
    Rasterizer rasterizer(device, capacity, shape, slots, std::move(kernels), std::move(frame),
                          std::move(screen), std::move(pairRanges), std::move(visible),
                          std::move(statistics));
    MACULA_TRY(auto recorder, gpu::Recorder::create(device, "clear statistics"));
    rasterizer.clearStatistics(recorder);
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return rasterizer;
}

Result<void> Rasterizer::project(const SplatBuffer& parameters, std::uint32_t count, const RasterView& view,
                                 const Blending& blending) {
    const glm::ivec2 tileSize(shared::kTileColumns, shape_.tileRows);
    const shared::SplatFrame frame{.view = splatView(view, blending),
                                   .count = count,
                                   .capacity = parameters.capacity(),
                                   .tiles = (view.sizePx + tileSize - 1) / tileSize,
                                   .tileRows = shape_.tileRows};
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "project splats"));
    recorder.update(frame_, std::as_bytes(std::span(&frame, 1)));
    if (count > 0)
        recorder.dispatch(kernels_.project, {count}, {frame_, screen_.buffer(), parameters.values()});
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return {};
}

Result<void> Rasterizer::uploadLists() {
    MACULA_TRY_VOID(makeRoom(ranges_, device_, "tiles", VK_FORMAT_R32G32_UINT, lists_.ranges.size(),
                             VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT));
    MACULA_TRY_VOID(makeRoom(entries_, device_, "splats of tiles", VK_FORMAT_R32G32_UINT,
                             lists_.entries.size(), VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT));
    MACULA_TRY_VOID(gpu::uploadTo<glm::uvec2>(ranges_->buffer(), lists_.ranges));
    if (!lists_.entries.empty())
        MACULA_TRY_VOID(gpu::uploadTo<glm::uvec2>(entries_->buffer(), lists_.entries));
    if (!lists_.pairs.empty()) MACULA_TRY_VOID(gpu::uploadTo<glm::uvec2>(pairRanges_.buffer(), lists_.pairs));
    return {};
}

Result<void> Rasterizer::makePicture(glm::ivec2 sizePx) {
    if (picture_ && picture_->width == sizePx.x && picture_->height == sizePx.y) return {};
    picture_.reset();
    depths_.reset();
    MACULA_TRY(picture_, DevicePicture::create(device_, "picture of splats", sizePx.x, sizePx.y));
    MACULA_TRY(depths_, gpu::Buffer::create(device_, {.label = "depths of splats",
                                                      .bytes = std::uint64_t(sizePx.x) *
                                                               std::uint64_t(sizePx.y) * sizeof(float)}));
    return {};
}

Result<void> Rasterizer::draw(const SplatBuffer& parameters, std::uint32_t count, const RasterView& view,
                              const Blending& blending) {
    MACULA_CHECK_LE(count, capacity_);
    MACULA_CHECK_LE(count, parameters.capacity());
    count_ = count;
    MACULA_TRY_VOID(makePicture(view.sizePx));
    MACULA_TRY_VOID(project(parameters, count, view, blending));
    std::vector<glm::vec4> screen(std::size_t(count) * kScreenTexels);
    if (count > 0)
        MACULA_TRY_VOID(gpu::readInto(screen_.buffer(), 0, std::as_writable_bytes(std::span(screen))));
    // Each pair takes kPairValues floats in the backward pass.
    const std::uint64_t mostPairs =
        device_->info().maxTexelBufferElements / (std::uint64_t(kPairValues) * std::uint64_t(slots_));
    MACULA_TRY_VOID(sortIntoTiles(screen, view, blending, shape_.tileRows, mostPairs, lists_));
    MACULA_TRY_VOID(uploadLists());
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "draw splats"));
    recorder.dispatch(kernels_.raster,
                      {static_cast<std::uint32_t>(lists_.tiles.x * shared::kTileColumns),
                       static_cast<std::uint32_t>(lists_.tiles.y * shape_.tileRows / shape_.rowsPerThread)},
                      {frame_, screen_, *ranges_, *entries_, picture_->texels.buffer(), *depths_});
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return {};
}

Result<void> Rasterizer::recordBackward(gpu::Recorder& recorder, const SplatBuffer& parameters,
                                        const DevicePicture& gradient, SplatBuffer& gradients) {
    MACULA_CHECK(kernels_.gather.has_value() && picture_.has_value());
    MACULA_CHECK_EQ(gradient.width, picture_->width);
    MACULA_CHECK_EQ(gradient.height, picture_->height);
    if (count_ == 0) return {};
    MACULA_TRY_VOID(makeRoom(pairs_, device_, "derivatives of pairs", VK_FORMAT_R32_SFLOAT,
                             lists_.entries.size() * std::uint64_t(kPairValues) * std::uint64_t(slots_),
                             kBothUses));
    recorder.dispatch(
        kernels_.rasterBack.value(),
        {static_cast<std::uint32_t>(lists_.tiles.x * shared::kTileColumns),
         static_cast<std::uint32_t>(lists_.tiles.y * shape_.tileRows / shape_.rowsPerThread)},
        {frame_, screen_, *ranges_, *entries_, picture_->texels, gradient.texels, pairs_->buffer()});
    recorder.dispatch(kernels_.gather.value(), {count_},
                      {frame_, screen_, parameters.values(), pairRanges_, *pairs_,
                       gradients.values().buffer(), visible_, statistics_});
    return {};
}

}  // namespace macula::splat
