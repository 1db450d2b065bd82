#include "pipeline/trace/device_volume.h"

#include <algorithm>
#include <limits>

#include "base/check.h"
#include "base/parallel.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/volume/entry_map.h"
#include "pipeline/volume/voxel_blocks.h"

namespace macula::trace {

namespace {

constexpr std::uint64_t kSlotBytes = kSlotValues * sizeof(std::uint16_t);
constexpr std::uint64_t kUnitBytes = 8 * sizeof(std::uint16_t);
constexpr std::size_t kBlocksPerTask = 64;  // so that the cost of starting a task is negligible

glm::ivec3 blockAt(const BrickGrid& grid, std::size_t index) {
    const auto x = static_cast<std::size_t>(grid.blocks.x);
    const auto y = static_cast<std::size_t>(grid.blocks.y);
    return {static_cast<int>(index % x), static_cast<int>(index / x % y), static_cast<int>(index / x / y)};
}

// The table's word for a block that is not on the device: see fetchStored.
std::uint32_t absentWord(const BrickGrid& grid, std::size_t block) {
    return blockWord(kSingle, grid.blockRanges[block].low);
}

std::uint64_t bytesOf(std::uint8_t level) {
    return poolValues(level) * sizeof(std::uint16_t);
}

// The number of texels of the table: for each layer of blocks, a layer with one texel for each brick.
std::size_t tableTexels(const BrickGrid& grid) {
    return grid.index(0, 0, grid.blocks.z);
}

// Calls body(i) for each i below count, in tasks of kBlocksPerTask, on all cores.
template <class Body>
void forEachOf(std::size_t count, const Body& body) {
    parallelFor((count + kBlocksPerTask - 1) / kBlocksPerTask, [&](std::size_t task) {
        const std::size_t end = std::min(count, (task + 1) * kBlocksPerTask);
        for (std::size_t i = task * kBlocksPerTask; i < end; ++i) body(i);
    });
}

}  // namespace

Result<DeviceVolume> DeviceVolume::create(std::shared_ptr<gpu::Device> device,
                                          std::shared_ptr<const Volume> volume, const BrickGrid& grid,
                                          const MemoryLimits& limits) {
    MACULA_CHECK(volume != nullptr);
    if (grid.ranges.size() > std::size_t(std::numeric_limits<std::int32_t>::max())) {
        return Error{
            ErrorCode::outOfMemory,
            Text("A volume of {} million voxels is more than can be traced.", volume->voxelCount() / 1000000),
            {},
            Text("Open a smaller series.")};
    }
    MACULA_TRY(auto table, gpu::TexelBuffer::create(device, {.label = "blocks of voxels",
                                                             .elements = tableTexels(grid),
                                                             .format = VK_FORMAT_R32G32B32A32_UINT}));
    DeviceVolume result(std::move(device), std::move(volume), limits, std::move(table));
    result.words_.resize(grid.blockRanges.size());
    result.resident_.resize(grid.blockRanges.size());
    result.forgetAll(grid);
    result.memory_.gridBytes = tableTexels(grid) * sizeof(glm::uvec4) + grid.ranges.size() * sizeof(float);
    return result;
}

Result<void> DeviceVolume::show(const BrickGrid& grid, std::span<const float> bounds,
                                std::span<const std::uint8_t> alsoShown,
                                std::span<const float> extinctionPerMm) {
    const std::vector<std::uint8_t> wanted = blocksToShow(grid, bounds, alsoShown);
    const auto visible = std::count_if(bounds.begin(), bounds.end(), [](float b) { return b > 0.0f; });
    memory_.visibleBricks = static_cast<std::uint64_t>(visible);
    memory_.shownBlocks = static_cast<std::uint64_t>(std::count(wanted.begin(), wanted.end(), 1));
    MACULA_TRY_VOID(device_->waitForAll());

    // The present pool may always be used, even if the device has become short of memory meanwhile.
    PoolRoom allowed =
        poolRoom(limits_, device_->info(), device_->memoryAvailableBytes(), room_.slots() * kSlotBytes);
    allowed.slotCount = std::max(allowed.slotCount, room_.slots());
    while (true) {
        plan_ = fitBlocks(grid, wanted, extinctionPerMm, allowed.slotCount);
        message_ = coarseningMessage(plan_, memory_.shownBlocks, allowed);
        memory_.coarseBlocks = plan_.coarse;
        auto brought = bring(grid, allowed.slotCount);
        if (brought.ok()) return {};
        pool_.reset();
        room_ = {};
        forgetAll(grid);
        // The device has less memory than it reported: try with half.
        if (brought.error().code != ErrorCode::outOfMemory || plan_.slots < 2) return brought;
        allowed = {.slotCount = plan_.slots / 2, .bound = PoolBound::memory};
    }
}

Result<void> DeviceVolume::bring(const BrickGrid& grid, std::uint64_t slotsAllowed) {
    for (std::size_t block = 0; block < resident_.size(); ++block) {
        const std::uint8_t level = plan_.levels[block];
        if (level != kAbsent && resident_[block] != kAbsent && level != resident_[block]) leave(grid, block);
    }
    MACULA_TRY_VOID(makeRoom(grid, slotsAllowed));
    std::vector<Upload> uploads;
    if (!placeAll(grid, uploads)) {
        // The free room is fragmented. Places all blocks again, full ones first, which leaves no gaps.
        forgetAll(grid);
        const std::uint64_t slots = room_.slots();
        room_ = {};
        room_.grow(slots);
        MACULA_CHECK(placeAll(grid, uploads));
    }
    holdsCoarse_ = std::any_of(resident_.begin(), resident_.end(),
                               [](std::uint8_t level) { return level > kFullLevel && level < kSingle; });
    MACULA_TRY_VOID(uploadBlocks(grid, uploads));
    memory_.poolBytes = room_.slots() * kSlotBytes;
    memory_.uploadedBlocks = uploads.size();
    memory_.uploadedBytes = 0;
    for (const Upload& upload : uploads) memory_.uploadedBytes += bytesOf(upload.level);
    return uploadTable(grid);
}

// Makes a pool with room for the plan. Copies the content of the old one, unless the device cannot hold both.
Result<void> DeviceVolume::makeRoom(const BrickGrid& grid, std::uint64_t slotsAllowed) {
    const std::uint64_t needed = std::max<std::uint64_t>(plan_.slots, 1);  // a binding cannot be empty
    if (pool_ && needed <= room_.slots()) return {};
    // A pool that grows once often grows again: an eighth more, so that not every change copies all blocks.
    const std::uint64_t slots =
        pool_ ? std::max(needed, std::min(needed + needed / 8, slotsAllowed)) : needed;
    if (pool_) {
        auto grown = growPool(slots);
        if (grown.ok() || grown.error().code != ErrorCode::outOfMemory) return grown;
        pool_.reset();
        room_ = {};
        forgetAll(grid);
        return growPool(needed);
    }
    return growPool(slots);
}

Result<void> DeviceVolume::growPool(std::uint64_t slots) {
    MACULA_TRY(auto pool,
               gpu::TexelBuffer::create(device_, {.label = "voxels",
                                                  .elements = slots * kSlotValues,
                                                  .format = VK_FORMAT_R16_UINT,
                                                  .elementsOfView = std::uint64_t{1} << viewShift()}));
    if (pool_) {
        MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "grow voxels"));
        recorder.copy(pool_->buffer(), 0, pool.buffer(), 0, pool_->buffer().bytes());
        MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
        MACULA_TRY_VOID(device_->waitForAll());
    }
    pool_.emplace(std::move(pool));
    room_.grow(slots);
    return {};
}

// Finds a place for all planned blocks that are not resident, full ones first, and evicts invisible blocks
// when there is no other room. False when there is no room even then.
bool DeviceVolume::placeAll(const BrickGrid& grid, std::vector<Upload>& uploads) {
    uploads.clear();
    std::vector<std::size_t> unseen;
    for (std::size_t block = 0; block < resident_.size(); ++block) {
        const std::uint8_t level = plan_.levels[block];
        if (level == kAbsent && resident_[block] < kSingle) unseen.push_back(block);
        if (level != kAbsent && level != resident_[block]) uploads.push_back({block, 0, level});
    }
    std::stable_sort(uploads.begin(), uploads.end(),
                     [](const Upload& a, const Upload& b) { return a.level < b.level; });
    for (Upload& upload : uploads) {
        if (upload.level < kSingle) {
            auto unit = room_.allocate(upload.level);
            while (!unit && !unseen.empty()) {
                leave(grid, unseen.back());
                unseen.pop_back();
                unit = room_.allocate(upload.level);
            }
            if (!unit) return false;
            upload.unit = *unit;
            setWord(upload.block, blockWord(upload.level, upload.unit));
        }
        resident_[upload.block] = upload.level;
    }
    return true;
}

void DeviceVolume::leave(const BrickGrid& grid, std::size_t block) {
    if (resident_[block] < kSingle) room_.release(resident_[block], words_[block] & 0x3fffffffu);
    resident_[block] = kAbsent;
    setWord(block, absentWord(grid, block));
}

void DeviceVolume::forgetAll(const BrickGrid& grid) {
    std::fill(resident_.begin(), resident_.end(), kAbsent);
    for (std::size_t block = 0; block < words_.size(); ++block) words_[block] = absentWord(grid, block);
    firstStale_ = 0;
    endStale_ = words_.size();
}

void DeviceVolume::setWord(std::size_t block, std::uint32_t word) {
    if (firstStale_ >= endStale_) firstStale_ = endStale_ = block;
    firstStale_ = std::min(firstStale_, block);
    endStale_ = std::max(endStale_, block + 1);
    words_[block] = word;
}

Result<void> DeviceVolume::uploadBlocks(const BrickGrid& grid, std::span<const Upload> uploads) {
    const EntryMap map = entryMapOf(*volume_);
    // Full blocks come first, single values last.
    const auto singles = std::find_if(uploads.begin(), uploads.end(),
                                      [](const Upload& upload) { return upload.level == kSingle; });
    const auto count = static_cast<std::size_t>(singles - uploads.begin());
    const std::span<const Upload> single = uploads.subspan(count);
    std::vector<std::uint32_t> values(single.size());
    forEachOf(single.size(),
              [&](std::size_t i) { values[i] = singleValue(*volume_, map, blockAt(grid, single[i].block)); });
    for (std::size_t i = 0; i < single.size(); ++i) setWord(single[i].block, blockWord(kSingle, values[i]));

    const std::span<std::byte> mapped = pool_->buffer().mapped();
    if (mapped.empty()) return uploadStaged(grid, uploads.first(count));
    auto* pool = reinterpret_cast<std::uint16_t*>(mapped.data());
    forEachOf(count, [&](std::size_t i) {
        const Upload& upload = uploads[i];
        writeBlock(*volume_, map, blockAt(grid, upload.block), upload.level,
                   {pool + std::size_t(upload.unit) * 8, poolValues(upload.level)});
    });
    return {};
}

// Uploads through a staging buffer, a portion at a time; one copy for blocks that are adjacent both there and
// in the pool.
Result<void> DeviceVolume::uploadStaged(const BrickGrid& grid, std::span<const Upload> uploads) {
    if (uploads.empty()) return {};
    constexpr std::uint64_t kPortionBytes = std::uint64_t{16} << 20;
    const EntryMap map = entryMapOf(*volume_);
    MACULA_TRY(const gpu::Buffer stage,
               gpu::Buffer::create(device_, {.label = "staging",
                                             .bytes = std::min(kPortionBytes, uploads.size() * kSlotBytes),
                                             .usage = 0,
                                             .memory = gpu::MemoryKind::upload}));
    auto* values = reinterpret_cast<std::uint16_t*>(stage.mapped().data());
    std::vector<std::uint64_t> offsets;  // bytes, in the staging buffer
    for (std::size_t first = 0; first < uploads.size();) {
        offsets.clear();
        std::uint64_t bytes = 0;
        std::size_t end = first;
        for (; end < uploads.size() && bytes + bytesOf(uploads[end].level) <= stage.bytes(); ++end) {
            offsets.push_back(bytes);
            bytes += bytesOf(uploads[end].level);
        }
        offsets.push_back(bytes);
        forEachOf(end - first, [&](std::size_t i) {
            const Upload& upload = uploads[first + i];
            writeBlock(*volume_, map, blockAt(grid, upload.block), upload.level,
                       {values + offsets[i] / sizeof(std::uint16_t), poolValues(upload.level)});
        });
        MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "upload voxels"));
        for (std::size_t run = first; run < end;) {
            const std::uint64_t target = uploads[run].unit * kUnitBytes;
            std::size_t next = run + 1;
            while (next < end &&
                   uploads[next].unit * kUnitBytes - target == offsets[next - first] - offsets[run - first])
                ++next;
            recorder.copy(stage, offsets[run - first], pool_->buffer(), target,
                          offsets[next - first] - offsets[run - first], gpu::Order::concurrent);
            run = next;
        }
        MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
        MACULA_TRY_VOID(device_->waitForAll());
        first = end;
    }
    return {};
}

// Uploads whole layers of the table, from the first to the last in which something has changed.
Result<void> DeviceVolume::uploadTable(const BrickGrid& grid) {
    if (firstStale_ >= endStale_) return {};
    const int first = blockAt(grid, firstStale_).z;
    const int end = blockAt(grid, endStale_ - 1).z + 1;
    std::vector<glm::uvec4> texels(grid.index(0, 0, end - first));
    parallelFor(static_cast<std::size_t>(end - first), [&](std::size_t layer) {
        const int z = first + static_cast<int>(layer);
        for (int y = 0; y < grid.size.y; ++y) {
            // Past the end of the volume its last block is repeated; entries before its start are never read.
            const int ys[] = {std::max(y - 1, 0), std::min(y, grid.blocks.y - 1)};
            for (int x = 0; x < grid.size.x; ++x) {
                const int xs[] = {std::max(x - 1, 0), std::min(x, grid.blocks.x - 1)};
                texels[grid.index(x, y, static_cast<int>(layer))] = {
                    words_[grid.blockIndex(xs[0], ys[0], z)], words_[grid.blockIndex(xs[1], ys[0], z)],
                    words_[grid.blockIndex(xs[0], ys[1], z)], words_[grid.blockIndex(xs[1], ys[1], z)]};
            }
        }
    });
    MACULA_TRY_VOID(gpu::uploadTo(table_.buffer(), grid.index(0, 0, first) * sizeof(glm::uvec4),
                                  std::as_bytes(std::span(texels))));
    firstStale_ = endStale_ = 0;
    return {};
}

VoxelMemory DeviceVolume::memory() const {
    return memory_;
}

}  // namespace macula::trace
