#include "pipeline/splat/draw/rasterizer.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "pipeline/gpu/transfer.h"

namespace macula::splat {

namespace {

using shared::kScreenTexels;

RasterShape chosenShape(const RasterShape& asked, const gpu::Device& device) {
    RasterShape shape = asked;
    if (shape.tileRows > 0) return shape;
    // On a graphics card, a tile has as many threads as run together: 8 x 4.
    shape.tileRows = device.isCpu() ? 16 : 8;
    shape.rowsPerThread = device.isCpu() ? 16 : 2;
    return shape;
}

bool makesLists(const gpu::Device& device, std::uint32_t capacity, ListMaker wanted) {
    if (wanted == ListMaker::host || capacity > kMostSplatsInDeviceLists) return false;
    return wanted == ListMaker::device || !device.isCpu();
}

}  // namespace

Rasterizer::Rasterizer(std::shared_ptr<gpu::Device> device, std::uint32_t capacity, RasterShape shape,
                       RasterKernels kernels, gpu::Buffer frame, gpu::TexelBuffer screen,
                       TileBuffers tileBuffers, std::optional<DeviceTileLists> deviceLists,
                       gpu::Buffer visible, gpu::Buffer statistics)
    : device_(std::move(device)),
      capacity_(capacity),
      shape_(shape),
      kernels_(std::move(kernels)),
      frame_(std::move(frame)),
      screen_(std::move(screen)),
      tileBuffers_(std::move(tileBuffers)),
      deviceLists_(std::move(deviceLists)),
      visible_(std::move(visible)),
      statistics_(std::move(statistics)) {}

Result<Rasterizer> Rasterizer::create(const std::shared_ptr<gpu::Device>& device, std::uint32_t capacity,
                                      int shDegree, const RasterShape& askedShape) {
    MACULA_CHECK_LT(0u, capacity);
    const RasterShape shape = chosenShape(askedShape, *device);
    MACULA_TRY(RasterKernels kernels, RasterKernels::create(device, shDegree, shape));
    MACULA_TRY(gpu::Buffer frame,
               gpu::Buffer::create(device, {.label = "splat frame", .bytes = sizeof(shared::SplatFrame)}));
    MACULA_TRY(gpu::TexelBuffer screen,
               gpu::TexelBuffer::create(device, {.label = "splats in the picture",
                                                 .elements = std::uint64_t(capacity) * kScreenTexels,
                                                 .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                                                 .usage = kReadAndWritten}));
    const bool onDevice = makesLists(*device, capacity, shape.lists);
    MACULA_TRY(TileBuffers tileBuffers,
               TileBuffers::create(device, onDevice ? TileBuffers::Maker::device : TileBuffers::Maker::host,
                                   capacity));
    std::optional<DeviceTileLists> deviceLists;
    if (onDevice) {
        MACULA_TRY(deviceLists, DeviceTileLists::create(device, capacity, shape.mostPairs));
    }
    MACULA_TRY(gpu::Buffer visible, gpu::Buffer::create(device, {.label = "visible splats",
                                                                 .bytes = std::uint64_t(capacity) * 4}));
    MACULA_TRY(
        gpu::Buffer statistics,
        gpu::Buffer::create(device, {.label = "statistics of splats",
                                     .bytes = std::uint64_t(capacity) * sizeof(shared::SplatStatistics)}));
    Rasterizer rasterizer(device, capacity, shape, std::move(kernels), std::move(frame), std::move(screen),
                          std::move(tileBuffers), std::move(deviceLists), std::move(visible),
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

// Records and submits. Buffers that are replaced by larger ones while commands are recorded are freed only
// afterwards: if both together exceed the memory, this records once more.
Result<void> Rasterizer::inOne(const char* label, const std::function<Result<void>(gpu::Recorder&)>& record) {
    const auto once = [&]() -> Result<void> {
        MACULA_TRY(auto recorder, gpu::Recorder::create(device_, label));
        MACULA_TRY_VOID(record(recorder));
        MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
        return {};
    };
    Result<void> done = once();
    if (done || done.error().code != ErrorCode::outOfMemory || device_->pendingDestructions() == 0)
        return done;
    MACULA_TRY_VOID(device_->waitForAll());
    return once();
}

void Rasterizer::recordProject(gpu::Recorder& recorder, const SplatBuffer& parameters, std::uint32_t count,
                               const RasterView& view, const Blending& blending) {
    shared::SplatFrame frame = frameOf(view, blending);
    frame.count = count;
    frame.capacity = parameters.capacity();
    recorder.update(frame_, std::as_bytes(std::span(&frame, 1)));
    if (count > 0)
        recorder.dispatch(kernels_.project, {count}, {frame_, screen_.buffer(), parameters.values()});
    tiles_ = frame.tiles;
}

RasterPass Rasterizer::beginPass(std::uint32_t splats) {
    RasterPass pass;
    pass.serial_ = ++serial_;
    pass.splats_ = splats;
    return pass;
}

Result<void> Rasterizer::recordLists(gpu::Recorder& recorder, std::uint64_t mostPairs, RasterPass& pass) {
    if (pass.splats_ > 0) {
        MACULA_TRY_VOID(
            deviceLists_->record(recorder, frame_, screen_, pass.splats_, tiles_, mostPairs, tileBuffers_));
    } else {
        MACULA_TRY_VOID(
            tileBuffers_.makeRoomFor(static_cast<std::uint64_t>(tiles_.x) * std::uint64_t(tiles_.y), 1));
        recorder.fill(tileBuffers_.ranges->buffer(), 0);
    }
    pass.isSettled_ = pass.splats_ == 0;
    pass.pairs_ = pass.isSettled_ ? 0 : std::min(mostPairs, deviceLists_->capacity());
    pass.mostPairs_ = mostPairs;
    return {};
}

// The threads of one workgroup for each tile. The backward kernel requires its subgroup size: with another,
// sums of derivatives would be in wrong places.
gpu::Threads Rasterizer::tileThreads() const {
    const int threads = shared::kTileColumns * shape_.tileRows / shape_.rowsPerThread;
    return {static_cast<std::uint32_t>(tiles_.x * threads), static_cast<std::uint32_t>(tiles_.y)};
}

void Rasterizer::recordRaster(gpu::Recorder& recorder, const gpu::TexelBuffer& screen) {
    recorder.dispatch(
        kernels_.raster, tileThreads(),
        {frame_, screen, *tileBuffers_.ranges, *tileBuffers_.entries, picture_->texels.buffer(), *depths_});
}

Result<RasterPass> Rasterizer::recordDraw(gpu::Recorder& recorder, const SplatBuffer& parameters,
                                          std::uint32_t count, const RasterView& view,
                                          const Blending& blending) {
    MACULA_CHECK(listsOnDevice());
    MACULA_CHECK_LE(count, capacity_);
    MACULA_CHECK_LE(count, parameters.capacity());
    RasterPass pass = beginPass(count);
    MACULA_TRY_VOID(makePicture(view.sizePx));
    recordProject(recorder, parameters, count, view, blending);
    MACULA_TRY_VOID(recordLists(recorder, kernels_.mostPairs(device_->info()), pass));
    recordRaster(recorder, screen_);
    return pass;
}

Result<bool> Rasterizer::settle(RasterPass& pass) {
    MACULA_CHECK_EQ(pass.serial_, serial_);
    if (pass.isSettled_) return true;
    MACULA_TRY(const std::uint64_t wanted, deviceLists_->wanted());
    if (wanted <= pass.pairs_) {
        pass.isSettled_ = true;
        pass.pairs_ = wanted;
        return true;
    }
    serial_ = pass.serial_ + 1;  // invalidates the pass: it has no backward pass
    if (wanted > pass.mostPairs_) return tooManyPairs();
    MACULA_TRY_VOID(deviceLists_->makeRoomForPairs(wanted));
    return false;
}

Result<void> Rasterizer::makePicture(glm::ivec2 sizePx) {
    const std::uint64_t pixels = std::uint64_t(sizePx.x) * std::uint64_t(sizePx.y);
    // The buffers are kept for smaller pictures, so that alternating sizes need no new memory.
    if (depths_ && picture_ && picture_->texels.elements() >= pixels) {
        picture_->width = sizePx.x;
        picture_->height = sizePx.y;
        return {};
    }
    picture_.reset();
    depths_.reset();
    const std::uint64_t bytes = pixels * sizeof(glm::vec4);
    const std::uint64_t most =
        std::min<std::uint64_t>(device_->info().maxStorageBufferBytes, device_->info().maxAllocationBytes);
    if (bytes > most)
        return Error{ErrorCode::outOfMemory,
                     Text("A picture of {} x {} pixels is too large for this device.", sizePx.x, sizePx.y),
                     {},
                     Text("Choose one of at most {:.1f} million pixels.",
                          static_cast<double>(most) / sizeof(glm::vec4) / 1e6)};
    MACULA_TRY(picture_, DevicePicture::create(device_, "picture of splats", sizePx.x, sizePx.y));
    MACULA_TRY(depths_,
               gpu::Buffer::create(device_, {.label = "depths of splats", .bytes = pixels * sizeof(float)}));
    return {};
}

// The projected splats on the host. A CPU device's memory is read in place: for a million splats a copy would
// take as long as sorting.
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

Result<RasterPass> Rasterizer::draw(const SplatBuffer& parameters, std::uint32_t count,
                                    const RasterView& view, const Blending& blending,
                                    const Submitted& submitted) {
    MACULA_CHECK_LE(count, capacity_);
    MACULA_CHECK_LE(count, parameters.capacity());
    const auto tell = [&](DrawStage stage) { return submitted ? submitted(stage) : Result<void>(); };
    while (true) {
        RasterPass pass = beginPass(count);
        MACULA_TRY_VOID(makePicture(view.sizePx));
        MACULA_TRY_VOID(inOne("project splats", [&](gpu::Recorder& recorder) -> Result<void> {
            recordProject(recorder, parameters, count, view, blending);
            return {};
        }));
        MACULA_TRY_VOID(tell(DrawStage::project));
        if (listsOnDevice()) {
            MACULA_TRY_VOID(inOne("lists of tiles", [&](gpu::Recorder& recorder) {
                return recordLists(recorder, kMostSorted, pass);
            }));
        } else {
            MACULA_TRY(const std::span<const glm::vec4> screen, readScreen(count));
            MACULA_TRY_VOID(sortOnHost(screen, view, blending, count > 0, pass));
        }
        MACULA_TRY_VOID(tell(DrawStage::lists));
        MACULA_TRY_VOID(inOne("draw splats", [&](gpu::Recorder& recorder) -> Result<void> {
            recordRaster(recorder, screen_);
            return {};
        }));
        MACULA_TRY_VOID(tell(DrawStage::raster));
        MACULA_TRY(const bool isRight, settle(pass));
        if (isRight) return pass;
    }
}

Result<void> Rasterizer::drawProjected(std::span<const glm::vec4> screen, const RasterView& view,
                                       const Blending& blending) {
    RasterPass pass = beginPass(0);
    MACULA_TRY_VOID(makePicture(view.sizePx));
    MACULA_TRY_VOID(makeRoom(hostScreen_, device_, "splats projected on the host",
                             VK_FORMAT_R32G32B32A32_SFLOAT, screen.size(),
                             VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT));
    if (!screen.empty()) MACULA_TRY_VOID(gpu::uploadTo<glm::vec4>(hostScreen_->buffer(), screen));
    MACULA_TRY_VOID(sortOnHost(screen, view, blending, false, pass));
    const shared::SplatFrame frame = frameOf(view, blending);
    return inOne("draw splats", [&](gpu::Recorder& recorder) -> Result<void> {
        recorder.update(frame_, std::as_bytes(std::span(&frame, 1)));
        recordRaster(recorder, *hostScreen_);
        return {};
    });
}

Result<void> Rasterizer::sortOnHost(std::span<const glm::vec4> screen, const RasterView& view,
                                    const Blending& blending, bool withPairs, RasterPass& pass) {
    // The most pairs that the lists can hold. The backward pass needs more memory, and requests it later.
    std::uint64_t mostPairs = std::min<std::uint64_t>(
        device_->info().maxTexelBufferElements, device_->info().maxAllocationBytes / sizeof(glm::uvec2));
    if (shape_.mostPairs > 0) mostPairs = std::min(mostPairs, shape_.mostPairs);
    if (!sortIntoTiles(screen, view, blending, shape_.tileRows, mostPairs, lists_)) return tooManyPairs();
    MACULA_TRY_VOID(tileBuffers_.upload(lists_, withPairs));
    tiles_ = lists_.tiles;
    pass.pairs_ = lists_.entries.size();
    return {};
}

Result<void> Rasterizer::recordBackward(gpu::Recorder& recorder, const RasterPass& pass,
                                        const SplatBuffer& parameters, const DevicePicture& gradient,
                                        SplatBuffer& gradients) {
    MACULA_CHECK_EQ(pass.serial_, serial_);
    MACULA_CHECK(kernels_.gather.has_value() && picture_.has_value());
    MACULA_CHECK_EQ(gradient.width, picture_->width);
    MACULA_CHECK_EQ(gradient.height, picture_->height);
    if (pass.splats_ == 0) return {};
    // While the picture is not settled, pairs_ is the room in the device's lists.
    MACULA_TRY_VOID(makeRoom(pairs_, device_, "derivatives of pairs", VK_FORMAT_R32_SFLOAT,
                             pass.pairs_ * kernels_.floatsOfPair(), kReadAndWritten,
                             pass.isSettled_ ? Room::toGrow : Room::exact));
    recorder.dispatch(kernels_.rasterBack.value(), tileThreads(),
                      {frame_, screen_, *tileBuffers_.ranges, *tileBuffers_.entries, picture_->texels,
                       gradient.texels, pairs_->buffer()});
    recorder.dispatch(kernels_.gather.value(), {pass.splats_},
                      {frame_, screen_, parameters.values(), tileBuffers_.pairs, *pairs_,
                       gradients.values().buffer(), visible_, statistics_});
    return {};
}

}  // namespace macula::splat
