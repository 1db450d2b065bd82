#include "pipeline/splat/draw/tile_buffers.h"

#include <algorithm>
#include <utility>

#include "pipeline/gpu/transfer.h"

namespace macula::splat {

Error tooManyPairs() {
    return {ErrorCode::outOfMemory,
            Text("The splats of this model are too large and too many for this device."),
            {},
            Text("Draw a smaller picture, or a model of fewer splats.")};
}

Result<void> makeRoom(std::optional<gpu::TexelBuffer>& texels, const std::shared_ptr<gpu::Device>& device,
                      const char* label, VkFormat format, std::uint64_t elements, VkBufferUsageFlags usage,
                      Room room) {
    if (texels && texels->elements() >= elements) return {};
    const gpu::DeviceInfo& info = device->info();
    std::uint64_t bytes = info.maxAllocationBytes;
    if (usage & VK_BUFFER_USAGE_STORAGE_BUFFER_BIT)
        bytes = std::min<std::uint64_t>(bytes, info.maxStorageBufferBytes);
    const std::uint64_t limit =
        std::min<std::uint64_t>(info.maxTexelBufferElements, bytes / gpu::bytesPerTexel(format));
    if (elements > limit) return tooManyPairs();
    const std::uint64_t slack = room == Room::toGrow ? elements / 2 : 0;
    const std::uint64_t made = std::min(std::max<std::uint64_t>(elements + slack, 1024), limit);
    texels.reset();
    MACULA_TRY(texels, gpu::TexelBuffer::create(
                           device, {.label = label, .elements = made, .format = format, .usage = usage}));
    return {};
}

namespace {

VkBufferUsageFlags usageOf(TileBuffers::Maker maker) {
    if (maker == TileBuffers::Maker::device) return kReadAndWritten;
    return VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;
}

}  // namespace

Result<TileBuffers> TileBuffers::create(const std::shared_ptr<gpu::Device>& device, Maker maker,
                                        std::uint32_t splats) {
    MACULA_TRY(gpu::TexelBuffer pairs, gpu::TexelBuffer::create(device, {.label = "pairs of splats",
                                                                         .elements = splats,
                                                                         .format = VK_FORMAT_R32G32_UINT,
                                                                         .usage = usageOf(maker)}));
    return TileBuffers{
        .maker = maker, .device = device, .ranges = {}, .entries = {}, .pairs = std::move(pairs)};
}

Result<void> TileBuffers::makeRoomFor(std::uint64_t tiles, std::uint64_t pairCount) {
    MACULA_TRY_VOID(makeRoom(ranges, device, "tiles", VK_FORMAT_R32G32_UINT, tiles, usageOf(maker)));
    return makeRoom(entries, device, "splats of tiles", VK_FORMAT_R32G32_UINT, pairCount, usageOf(maker),
                    maker == Maker::device ? Room::exact : Room::toGrow);
}

Result<void> TileBuffers::upload(const TileLists& lists, bool withPairs) {
    MACULA_TRY_VOID(makeRoomFor(lists.ranges.size(), lists.entries.size()));
    MACULA_TRY_VOID(gpu::uploadTo<glm::uvec2>(ranges->buffer(), lists.ranges));
    if (!lists.entries.empty()) MACULA_TRY_VOID(gpu::uploadTo<glm::uvec2>(entries->buffer(), lists.entries));
    if (withPairs) MACULA_TRY_VOID(gpu::uploadTo<glm::uvec2>(pairs.buffer(), lists.pairs));
    return {};
}

}  // namespace macula::splat
