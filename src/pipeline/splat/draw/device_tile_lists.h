// Tile binning on the device (shaders/splat/tile_*.comp): makes the lists that sortIntoTiles makes on the
// host, without reading anything back on the way. Sorts the splats by depth; counts each visible splat once
// for each of its tiles, by the same exact test; and sorts these pairs, which are then in order of depth,
// stably by tile.
//
// The lists equal those of the host except for tiles that a splat only just misses, where the device's
// logarithm and division may round differently: such a pair shows nothing, and changes neither picture nor
// derivatives.
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

// Larger models are binned on the host.
inline constexpr std::uint32_t kMostSplatsInDeviceLists =
    65535u * (shared::kListThreads / shared::kTileParts);

class DeviceTileLists {
  public:
    // For up to `splats` splats, at most kMostSplatsInDeviceLists, and up to `mostPairs` pairs (0: as many as
    // the device allows).
    static Result<DeviceTileLists> create(const std::shared_ptr<gpu::Device>& device, std::uint32_t splats,
                                          std::uint64_t mostPairs);

    // Records the lists of the first `count` splats, above 0, in `screen`, for the tiles of the SplatFrame in
    // `frame`. When there are more pairs than room, or more than `most`, all lists are empty: no tile shows
    // anything.
    Result<void> record(gpu::Recorder& recorder, const gpu::Buffer& frame, const gpu::TexelBuffer& screen,
                        std::uint32_t count, const glm::ivec2& tiles, std::uint64_t most, TileBuffers& lists);

    // The number of pairs that the last recorded lists need, whether or not there was room for them. Waits
    // until they are done.
    Result<std::uint64_t> wanted() const;
    // The number of pairs for which there is room.
    std::uint64_t capacity() const { return capacity_; }
    // Fails with tooManyPairs (outOfMemory).
    Result<void> makeRoomForPairs(std::uint64_t pairs);

  private:
    struct Kernels {
        gpu::Kernel keys, count, starts, emit, entries, ranges;
    };
    // Buffers with an entry for each splat, and with one for each pair of splat and tile.
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
