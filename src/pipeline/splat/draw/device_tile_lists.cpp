#include "pipeline/splat/draw/device_tile_lists.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <utility>

#include "base/check.h"
#include "pipeline/gpu/transfer.h"
#include "shaders/splat.h"

namespace macula::splat {

namespace {

using shared::kListThreads;
using shared::kTileParts;
using shared::SplatListState;

constexpr std::uint64_t kItemBytes = 8;
constexpr int kDepthBits = 32;

// The room for pairs before any picture was drawn. The splats of large models are small, so few pairs for
// each suffice; a pair takes 29 bytes here and in the tile lists, and its derivatives take more.
std::uint64_t firstRoom(std::uint64_t splats) {
    return std::max({std::min<std::uint64_t>(8 * splats, 1u << 18), 2 * splats, std::uint64_t(4096)});
}

std::uint64_t mostPairsOn(const gpu::Device& device, std::uint64_t asked) {
    const gpu::DeviceInfo& info = device.info();
    const std::uint64_t bytes = std::min<std::uint64_t>(info.maxStorageBufferBytes, info.maxAllocationBytes);
    const std::uint64_t most =
        std::min({bytes / kItemBytes, std::uint64_t(info.maxTexelBufferElements), kMostSorted});
    return asked > 0 ? std::min(asked, most) : most;
}

Result<gpu::Buffer> makeState(const std::shared_ptr<gpu::Device>& device, const char* label) {
    return gpu::Buffer::create(
        device, {.label = label,
                 .bytes = sizeof(SplatListState),
                 .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT});
}

std::uint32_t blocksOf(std::uint32_t count) {
    return (count + shared::kSortBlock - 1) / shared::kSortBlock;
}

void write(gpu::Recorder& recorder, const gpu::Buffer& state, const SplatListState& value) {
    recorder.update(state, std::as_bytes(std::span(&value, 1)));
}

}  // namespace

DeviceTileLists::DeviceTileLists(std::shared_ptr<gpu::Device> device, std::uint64_t mostPairs,
                                 Kernels kernels, SplatBuffers splats, PairBuffers pairs, RadixSort splatSort,
                                 RadixSort pairSort, gpu::Buffer pairState, gpu::Buffer wanted)
    : device_(std::move(device)),
      mostPairs_(mostPairs),
      kernels_(std::move(kernels)),
      splats_(std::move(splats)),
      pairs_(std::move(pairs)),
      splatSort_(std::move(splatSort)),
      pairSort_(std::move(pairSort)),
      pairState_(std::move(pairState)),
      wanted_(std::move(wanted)) {}

Result<DeviceTileLists::PairBuffers> DeviceTileLists::makePairs(const std::shared_ptr<gpu::Device>& device,
                                                                std::uint64_t capacity) {
    MACULA_TRY(gpu::Buffer items,
               gpu::Buffer::create(device, {.label = "pairs", .bytes = capacity * kItemBytes}));
    MACULA_TRY(gpu::Buffer other,
               gpu::Buffer::create(device, {.label = "pairs on their way", .bytes = capacity * kItemBytes}));
    MACULA_TRY(gpu::Buffer splats,
               gpu::Buffer::create(device, {.label = "splats of pairs", .bytes = capacity * 4}));
    return PairBuffers{std::move(items), std::move(other), std::move(splats)};
}

Result<DeviceTileLists> DeviceTileLists::create(const std::shared_ptr<gpu::Device>& device,
                                                std::uint32_t splats, std::uint64_t mostPairs) {
    MACULA_CHECK_LE(splats, kMostSplatsInDeviceLists);
    const auto kernel = [&](const gpu::ShaderCode& code) { return gpu::Kernel::create(device, code); };
    MACULA_TRY(gpu::Kernel keys, kernel(shaders::splat_tile_keys_comp));
    MACULA_TRY(gpu::Kernel count, kernel(shaders::splat_tile_count_comp));
    MACULA_TRY(gpu::Kernel starts, kernel(shaders::splat_tile_starts_comp));
    MACULA_TRY(gpu::Kernel emit, kernel(shaders::splat_tile_emit_comp));
    MACULA_TRY(gpu::Kernel entries, kernel(shaders::splat_tile_entries_comp));
    MACULA_TRY(gpu::Kernel ranges, kernel(shaders::splat_tile_ranges_comp));
    const auto buffer = [&](const char* label, std::uint64_t bytes) {
        return gpu::Buffer::create(device, {.label = label, .bytes = bytes});
    };
    const std::uint64_t parts = std::uint64_t(splats) * kTileParts;
    MACULA_TRY(gpu::Buffer state, makeState(device, "splats to sort"));
    MACULA_TRY(gpu::Buffer items, buffer("splats by depth", splats * kItemBytes));
    MACULA_TRY(gpu::Buffer other, buffer("splats on their way", splats * kItemBytes));
    MACULA_TRY(gpu::Buffer tileCounts, buffer("tiles of splats", parts * 4));
    MACULA_TRY(gpu::Buffer groupStarts, buffer("first pairs", (parts + kListThreads - 1) / kListThreads * 4));
    MACULA_TRY(RadixSort splatSort, RadixSort::create(device, splats));
    MACULA_TRY(gpu::Buffer pairState, makeState(device, "pairs to sort"));
    MACULA_TRY(gpu::Buffer wanted, gpu::Buffer::create(device, {.label = "pairs wanted",
                                                                .bytes = 4,
                                                                .usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                                                .memory = gpu::MemoryKind::readback}));
    MACULA_TRY(RadixSort pairSort, RadixSort::create(device, 1));
    MACULA_TRY(PairBuffers pairs, makePairs(device, 1));
    DeviceTileLists lists(
        device, mostPairsOn(*device, mostPairs),
        {std::move(keys), std::move(count), std::move(starts), std::move(emit), std::move(entries),
         std::move(ranges)},
        {std::move(state), std::move(items), std::move(other), std::move(tileCounts), std::move(groupStarts)},
        std::move(pairs), std::move(splatSort), std::move(pairSort), std::move(pairState), std::move(wanted));
    MACULA_TRY_VOID(lists.makeRoomForPairs(std::min(firstRoom(splats), lists.mostPairs_)));
    return lists;
}

Result<void> DeviceTileLists::makeRoomForPairs(std::uint64_t pairs) {
    if (pairs <= capacity_) return {};
    if (pairs > mostPairs_) return tooManyPairs();
    const std::uint64_t capacity = std::min(pairs + pairs / 2, mostPairs_);
    MACULA_TRY(pairs_, makePairs(device_, capacity));
    MACULA_TRY_VOID(pairSort_.makeRoom(capacity));
    capacity_ = capacity;
    return {};
}

Result<void> DeviceTileLists::record(gpu::Recorder& recorder, const gpu::Buffer& frame,
                                     const gpu::TexelBuffer& screen, std::uint32_t count,
                                     const glm::ivec2& tiles, std::uint64_t most, TileBuffers& lists) {
    MACULA_CHECK_LT(0u, count);
    const auto tileCount = static_cast<std::uint32_t>(tiles.x) * static_cast<std::uint32_t>(tiles.y);
    MACULA_TRY_VOID(lists.makeRoomFor(tileCount, capacity_));
    const auto label = recorder.label("lists of tiles");
    write(recorder, splats_.state,
          {.count = count, .blocks = blocksOf(count), .groups = {blocksOf(count), 1, 1}});
    write(recorder, pairState_, {.capacity = static_cast<std::uint32_t>(std::min(capacity_, most))});
    recorder.dispatch(kernels_.keys, {count}, {frame, screen, splats_.items});
    const gpu::Buffer& byDepth =
        splatSort_.record(recorder, splats_.state, splats_.items, splats_.otherItems, kDepthBits);
    recorder.dispatch(kernels_.count, {count * kTileParts},
                      {frame, screen, byDepth, splats_.tileCounts, splats_.groupStarts});
    recorder.dispatch(kernels_.starts, {kListThreads}, {frame, pairState_, splats_.groupStarts});
    recorder.dispatch(kernels_.emit, {count * kTileParts},
                      {frame, screen, byDepth, splats_.tileCounts, splats_.groupStarts, pairState_,
                       pairs_.items, pairs_.splats, lists.pairs.buffer()});
    const gpu::Buffer& byTile = pairSort_.record(recorder, pairState_, pairs_.items, pairs_.otherItems,
                                                 static_cast<int>(std::bit_width(tileCount - 1)));
    recorder.dispatch(kernels_.entries, gpu::Recorder::Groups{pairState_, offsetof(SplatListState, groups)},
                      {pairState_, byTile, pairs_.splats, lists.entries->buffer()});
    recorder.dispatch(kernels_.ranges, {tileCount}, {frame, pairState_, byTile, lists.ranges->buffer()});
    recorder.copy(pairState_, offsetof(SplatListState, wanted), wanted_, 0, 4);
    return {};
}

Result<std::uint64_t> DeviceTileLists::wanted() const {
    std::uint32_t pairs = 0;
    MACULA_TRY_VOID(gpu::readInto(wanted_, 0, std::as_writable_bytes(std::span(&pairs, 1))));
    return pairs;
}

}  // namespace macula::splat
