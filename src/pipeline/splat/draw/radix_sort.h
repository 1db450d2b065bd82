// A stable sort of key-value pairs on the device, by key: shaders/splat/sort_*.comp.
#pragma once

#include <cstdint>
#include <memory>

#include "base/result.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/resources.h"
#include "shared/splat_lists.h"

namespace macula::splat {

inline constexpr std::uint64_t kMostSorted = 65535ull * shared::kSortBlock;

class RadixSort {
  public:
    // For at most `most` items, up to kMostSorted. outOfMemory when the device has no room for a byte for
    // each.
    static Result<RadixSort> create(const std::shared_ptr<gpu::Device>& device, std::uint64_t most);

    // Makes room for `most` items; sorts recorded before remain valid.
    Result<void> makeRoom(std::uint64_t most);

    // Sorts the items (uvec2: key, value) by the lowest `bits` bits of their keys; the other bits must be 0
    // or not matter. Items with equal keys keep their order. When the device executes this, it reads the
    // number of items from `state`, a SplatListState that may also be used for indirect dispatches. Returns
    // the buffer with the result: `items` or `other`, which needs as much room.
    const gpu::Buffer& record(gpu::Recorder& recorder, const gpu::Buffer& state, const gpu::Buffer& items,
                              const gpu::Buffer& other, int bits) const;

  private:
    struct Kernels {
        gpu::Kernel count;
        gpu::Kernel scan;
        gpu::Kernel scatter;  // used after scan
        gpu::Kernel scatterWithoutScan;
    };
    RadixSort(std::shared_ptr<gpu::Device> device, Kernels kernels, gpu::Buffer counts, gpu::Buffer totals);

    std::shared_ptr<gpu::Device> device_;
    Kernels kernels_;
    gpu::Buffer counts_;
    gpu::Buffer totals_;
};

}  // namespace macula::splat
