// The voxels of a volume on the device: only the blocks that visible bricks touch.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/trace/voxel_memory.h"
#include "pipeline/volume/block_pool.h"
#include "pipeline/volume/brick_grid.h"
#include "pipeline/volume/coarsening.h"

namespace macula::trace {

// Used by one thread at a time, the one that uses the device.
//
// A pool holds blocks, a table says where each of them is: see fetchStored in shaders/trace/host.glsl. A
// block that is no longer visible stays in the pool until its room is needed, so that going back costs
// nothing. The pool grows with the visible blocks, up to the memory allowed.
class DeviceVolume {
  public:
    // Nothing is shown yet. `grid` is the volume's. outOfMemory when the device cannot hold the table.
    static Result<DeviceVolume> create(std::shared_ptr<gpu::Device> device,
                                       std::shared_ptr<const Volume> volume, const BrickGrid& grid,
                                       const MemoryLimits& limits);

    // Uploads the blocks of blocksToShow(grid, bounds, alsoShown) that are not there yet. If they do not all
    // fit, some are coarse: only then levels() has others than kFullLevel, kSingle and kAbsent, and message()
    // says so. On all cores; waits for the device. After a failure nothing is shown, and the next call starts
    // over.
    Result<void> show(const BrickGrid& grid, std::span<const float> bounds,
                      std::span<const std::uint8_t> alsoShown, std::span<const float> extinctionPerMm);

    bool isShown() const { return pool_.has_value(); }
    // The pool and the table that fetchCorners in shaders/trace/host.glsl reads: values, R16_UINT, once
    // shown; and words of blocks, RGBA32_UINT.
    const gpu::TexelBuffer& pool() const { return *pool_; }
    // log2 of the number of values in each view of the pool but the last.
    int viewShift() const { return poolViewShift(limits_, device_->info()); }
    const gpu::TexelBuffer& table() const { return table_; }

    std::span<const std::uint8_t> levels() const { return plan_.levels; }  // by block
    bool isCoarse() const { return plan_.coarse > 0; }
    // Whether any block in the pool is coarse, even one that is hidden now.
    bool holdsCoarseBlocks() const { return holdsCoarse_; }
    const std::optional<Message>& message() const { return message_; }
    VoxelMemory memory() const;

  private:
    struct Upload {
        std::size_t block = 0;
        std::uint32_t unit = 0;  // its place in the pool, in units of 8 values
        std::uint8_t level = kAbsent;
    };

    DeviceVolume(std::shared_ptr<gpu::Device> device, std::shared_ptr<const Volume> volume,
                 MemoryLimits limits, gpu::TexelBuffer table)
        : device_(std::move(device)), volume_(std::move(volume)), limits_(limits), table_(std::move(table)) {}

    Result<void> bring(const BrickGrid& grid, std::uint64_t slotsAllowed);
    Result<void> makeRoom(const BrickGrid& grid, std::uint64_t slotsAllowed);
    Result<void> growPool(std::uint64_t slots);
    bool placeAll(const BrickGrid& grid, std::vector<Upload>& uploads);
    void leave(const BrickGrid& grid, std::size_t block);
    void forgetAll(const BrickGrid& grid);
    void setWord(std::size_t block, std::uint32_t word);
    Result<void> uploadBlocks(const BrickGrid& grid, std::span<const Upload> uploads);
    Result<void> uploadStaged(const BrickGrid& grid, std::span<const Upload> uploads);
    Result<void> uploadTable(const BrickGrid& grid);

    std::shared_ptr<gpu::Device> device_;
    std::shared_ptr<const Volume> volume_;
    MemoryLimits limits_;
    gpu::TexelBuffer table_;
    std::optional<gpu::TexelBuffer> pool_;
    BlockPool room_;                      // free room in pool_
    std::vector<std::uint8_t> resident_;  // by block: its level in the pool, or kAbsent
    bool holdsCoarse_ = false;
    std::vector<std::uint32_t> words_;  // content of table_, once it is uploaded
    std::size_t firstStale_ = 0;        // words from here to endStale_ are still to be uploaded
    std::size_t endStale_ = 0;
    Coarsening plan_;
    std::optional<Message> message_;
    VoxelMemory memory_;
};

}  // namespace macula::trace
