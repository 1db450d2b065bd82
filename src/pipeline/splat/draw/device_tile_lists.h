// Tile binning on the device (shaders/splat/tile_*.comp): what sortIntoTiles makes on the host, without
// anything being read back on the way. Splats are sorted by depth; those that show are counted with each of
// their tiles, by the same exact test; the pairs, which are then in the order of depth, are sorted by tile.
//
// The lists are those of the host but for tiles that a splat only just misses, where logarithm and division
// of the device may round otherwise: such a pair shows nothing, and changes neither picture nor derivatives.
#pragma once

#include <cstdint>
#include <memory>

#include "base/result.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/splat/draw/radix_sort.h"
#include "pipeline/splat/draw/tile_buffers.h"

namespace macula::splat {

// The splats of larger models are binned on the host.
inline constexpr std::uint32_t kMostSplatsInDeviceLists =
    65535u * (shared::kListThreads / shared::kTileParts);

class DeviceTileLists {
  public:
    // For at most as many splats, up to kMostSplatsInDeviceLists, and pairs (0: as the device allows).
    static Result<DeviceTileLists> create(const std::shared_ptr<gpu::Device>& device, std::uint32_t splats,
                                          std::uint64_t mostPairs);

    // Lists of the first `count` splats, above 0, in `screen`, for the tiles of the SplatFrame in `frame`.
    // When there are more pairs than there is room for, or more than `most`, no tile shows anything and no
    // splat is in any.
    Result<void> record(gpu::Recorder& recorder, const gpu::Buffer& frame, const gpu::TexelBuffer& screen,
                        std::uint32_t count, const glm::ivec2& tiles, std::uint64_t most, TileBuffers& lists);

    // The number of pairs in what was recorded last, whether there was room for them or not. Waits until it
    // is done.
    Result<std::uint64_t> wanted() const;
    // Pairs there is room for.
    std::uint64_t capacity() const { return capacity_; }
    // outOfMemory as tooManyPairs.
    Result<void> makeRoomForPairs(std::uint64_t pairs);

  private:
    struct Kernels {
        gpu::Kernel keys, count, starts, emit, entries, ranges;
    };
    // Buffers by splat, and by pair of splat and tile.
    struct SplatBuffers {
        gpu::Buffer state, items, otherItems, tileCounts, groupStarts;
    };
    struct PairBuffers {
        gpu::Buffer items, otherItems, splats;
    };
    DeviceTileLists(std::shared_ptr<gpu::Device> device, std::uint64_t mostPairs, Kernels kernels,
                    SplatBuffers splats, PairBuffers pairs, RadixSort splatSort, RadixSort pairSort,
                    gpu::Buffer pairState, gpu::Buffer wanted);
    static Result<PairBuffers> makePairs(const std::shared_ptr<gpu::Device>& device, std::uint64_t capacity);

    std::shared_ptr<gpu::Device> device_;
    std::uint64_t mostPairs_;
    std::uint64_t capacity_ = 1;
    Kernels kernels_;
    SplatBuffers splats_;
    PairBuffers pairs_;
    RadixSort splatSort_;
    RadixSort pairSort_;
    gpu::Buffer pairState_;
    gpu::Buffer wanted_;
};

}  // namespace macula::splat
