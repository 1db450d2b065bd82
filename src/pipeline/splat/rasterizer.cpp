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
    RasterShape shape = asked;
    if (shape.tileRows > 0) return shape;
    // A tile of a graphics card is as many threads as it runs together: 8 x 4.
    shape.tileRows = device.isCpu() ? 16 : 8;
    shape.rowsPerThread = device.isCpu() ? 16 : 2;
    return shape;
}

Error tooMany() {
    return {ErrorCode::outOfMemory,
            "The splats of this model are too large and too many for this device.",
            {},
            "Draw a smaller picture, or a model of fewer splats."};
}

// One that has room for `elements`: the same, or a larger one.
Result<void> makeRoom(std::optional<gpu::TexelBuffer>& texels, const std::shared_ptr<gpu::Device>& device,
                      const char* label, VkFormat format, std::uint64_t elements, VkBufferUsageFlags usage) {
    if (texels && texels->elements() >= elements) return {};
    const gpu::DeviceInfo& info = device->info();
    std::uint64_t bytes = info.maxAllocationBytes;
    if (usage & VK_BUFFER_USAGE_STORAGE_BUFFER_BIT)
        bytes = std::min<std::uint64_t>(bytes, info.maxStorageBufferBytes);
    const std::uint64_t limit =
        std::min<std::uint64_t>(info.maxTexelBufferElements, bytes / gpu::bytesPerTexel(format));
    if (elements > limit) return tooMany();
    const std::uint64_t room = std::min(std::max<std::uint64_t>(elements + elements / 2, 1024), limit);
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

shared::SplatFrame Rasterizer::frameOf(const RasterView& view, const Blending& blending) const {
    const glm::ivec2 tileSize(shared::kTileColumns, shape_.tileRows);
    return {.view = splatView(view, blending),
            .count = 0,
            .capacity = capacity_,
            .tiles = (view.sizePx + tileSize - 1) / tileSize,
            .tileRows = shape_.tileRows};
}

Result<void> Rasterizer::project(const SplatBuffer& parameters, std::uint32_t count, const RasterView& view,
                                 const Blending& blending) {
    shared::SplatFrame frame = frameOf(view, blending);
    frame.count = count;
    frame.capacity = parameters.capacity();
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
    if (count_ > 0) MACULA_TRY_VOID(gpu::uploadTo<glm::uvec2>(pairRanges_.buffer(), lists_.pairs));
    return {};
}

Result<void> Rasterizer::makePicture(glm::ivec2 sizePx) {
    if (picture_ && picture_->width == sizePx.x && picture_->height == sizePx.y) return {};
    picture_.reset();
    depths_.reset();
    const std::uint64_t bytes = std::uint64_t(sizePx.x) * std::uint64_t(sizePx.y) * sizeof(glm::vec4);
    const std::uint64_t most =
        std::min<std::uint64_t>(device_->info().maxStorageBufferBytes, device_->info().maxAllocationBytes);
    if (bytes > most)
        return Error{
            ErrorCode::outOfMemory,
            fmt::format("A picture of {} x {} pixels is too large for this device.", sizePx.x, sizePx.y),
            {},
            fmt::format("Choose one of at most {:.1f} million pixels.",
                        static_cast<double>(most) / sizeof(glm::vec4) / 1e6)};
    MACULA_TRY(picture_, DevicePicture::create(device_, "picture of splats", sizePx.x, sizePx.y));
    MACULA_TRY(depths_, gpu::Buffer::create(device_, {.label = "depths of splats",
                                                      .bytes = std::uint64_t(sizePx.x) *
                                                               std::uint64_t(sizePx.y) * sizeof(float)}));
    return {};
}

// Of a CPU device it is read where it lies: for a million splats that saves as much as sorting takes.
Result<std::span<const glm::vec4>> Rasterizer::readScreen(std::uint32_t count) {
    const std::size_t texels = std::size_t(count) * kScreenTexels;
    const gpu::Buffer& buffer = screen_.buffer();
    if (!buffer.mapped().empty() && buffer.hostCached()) {
        MACULA_TRY_VOID(device_->waitForAll());
        return std::span(reinterpret_cast<const glm::vec4*>(buffer.mapped().data()), texels);
    }
    screenCopy_.resize(texels);
    if (count > 0) MACULA_TRY_VOID(gpu::readInto(buffer, 0, std::as_writable_bytes(std::span(screenCopy_))));
    return std::span<const glm::vec4>(screenCopy_);
}

Result<void> Rasterizer::draw(const SplatBuffer& parameters, std::uint32_t count, const RasterView& view,
                              const Blending& blending, const Submitted& submitted) {
    MACULA_CHECK_LE(count, capacity_);
    MACULA_CHECK_LE(count, parameters.capacity());
    count_ = 0;
    MACULA_TRY_VOID(makePicture(view.sizePx));
    MACULA_TRY_VOID(project(parameters, count, view, blending));
    if (submitted) MACULA_TRY_VOID(submitted(DrawStage::project));
    MACULA_TRY(const std::span<const glm::vec4> screen, readScreen(count));
    count_ = count;
    Result<void> drawn = sortAndRaster(screen, screen_, view, blending, submitted);
    if (!drawn) count_ = 0;  // nothing can be differentiated
    return drawn;
}

Result<void> Rasterizer::drawProjected(std::span<const glm::vec4> screen, const RasterView& view,
                                       const Blending& blending) {
    count_ = 0;
    MACULA_TRY_VOID(makePicture(view.sizePx));
    MACULA_TRY_VOID(makeRoom(hostScreen_, device_, "splats projected on the host",
                             VK_FORMAT_R32G32B32A32_SFLOAT, screen.size(),
                             VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT));
    if (!screen.empty()) MACULA_TRY_VOID(gpu::uploadTo<glm::vec4>(hostScreen_->buffer(), screen));
    const shared::SplatFrame frame = frameOf(view, blending);
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "frame of splats"));
    recorder.update(frame_, std::as_bytes(std::span(&frame, 1)));
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return sortAndRaster(screen, *hostScreen_, view, blending);
}

Result<void> Rasterizer::sortAndRaster(std::span<const glm::vec4> screen,
                                       const gpu::TexelBuffer& screenTexels, const RasterView& view,
                                       const Blending& blending, const Submitted& submitted) {
    // What a tile's list can hold; the backward pass needs more, and asks for it then.
    std::uint64_t mostPairs = std::min<std::uint64_t>(
        device_->info().maxTexelBufferElements, device_->info().maxAllocationBytes / sizeof(glm::uvec2));
    if (shape_.mostPairs > 0) mostPairs = std::min(mostPairs, shape_.mostPairs);
    if (!sortIntoTiles(screen, view, blending, shape_.tileRows, mostPairs, lists_)) return tooMany();
    MACULA_TRY_VOID(uploadLists());
    if (submitted) MACULA_TRY_VOID(submitted(DrawStage::lists));
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "draw splats"));
    recorder.dispatch(kernels_.raster,
                      {static_cast<std::uint32_t>(lists_.tiles.x * shared::kTileColumns),
                       static_cast<std::uint32_t>(lists_.tiles.y * shape_.tileRows / shape_.rowsPerThread)},
                      {frame_, screenTexels, *ranges_, *entries_, picture_->texels.buffer(), *depths_});
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    if (submitted) MACULA_TRY_VOID(submitted(DrawStage::raster));
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
