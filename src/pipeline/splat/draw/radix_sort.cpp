#include "pipeline/splat/draw/radix_sort.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/check.h"
#include "shaders/splat.h"

namespace macula::splat {

namespace {

constexpr int kDigitBits = 8;
static_assert(1u << kDigitBits == shared::kSortDigits && shared::kSortDigits == shared::kListThreads);

// Up to this number of blocks, the scatter kernel sums the counts of all blocks itself, so that a pass of the
// radix sort needs no prefix sum. Which of the two is faster on a graphics card has not been measured.
constexpr std::uint64_t kFewBlocks = 128;
constexpr std::uint64_t kBytesOfBlock = shared::kSortDigits * 4;

Result<gpu::Buffer> makeCounts(const std::shared_ptr<gpu::Device>& device, std::uint64_t most) {
    MACULA_CHECK_LE(most, kMostSorted);
    const std::uint64_t blocks =
        std::max<std::uint64_t>(1, (most + shared::kSortBlock - 1) / shared::kSortBlock);
    return gpu::Buffer::create(device, {.label = "digits", .bytes = blocks * kBytesOfBlock});
}

}  // namespace

RadixSort::RadixSort(std::shared_ptr<gpu::Device> device, Kernels kernels, gpu::Buffer counts,
                     gpu::Buffer totals)
    : device_(std::move(device)),
      kernels_(std::move(kernels)),
      counts_(std::move(counts)),
      totals_(std::move(totals)) {}

Result<RadixSort> RadixSort::create(const std::shared_ptr<gpu::Device>& device, std::uint64_t most) {
    MACULA_TRY(gpu::Kernel count, gpu::Kernel::create(device, shaders::splat_sort_count_comp));
    MACULA_TRY(gpu::Kernel scan, gpu::Kernel::create(device, shaders::splat_sort_scan_comp));
    MACULA_TRY(gpu::Kernel scatter, gpu::Kernel::create(device, shaders::splat_sort_scatter_comp));
    MACULA_TRY(gpu::Kernel withoutScan, gpu::Kernel::create(device, shaders::splat_sort_scatter_comp,
                                                            {.specializations = {{"kScanned", false}}}));
    MACULA_TRY(gpu::Buffer counts, makeCounts(device, most));
    MACULA_TRY(gpu::Buffer totals,
               gpu::Buffer::create(device, {.label = "digits of all", .bytes = kBytesOfBlock}));
    return RadixSort(device, {std::move(count), std::move(scan), std::move(scatter), std::move(withoutScan)},
                     std::move(counts), std::move(totals));
}

Result<void> RadixSort::makeRoom(std::uint64_t most) {
    MACULA_TRY(counts_, makeCounts(device_, most));
    return {};
}

const gpu::Buffer& RadixSort::record(gpu::Recorder& recorder, const gpu::Buffer& state,
                                     const gpu::Buffer& items, const gpu::Buffer& other, int bits) const {
    const gpu::Recorder::Groups blocks{state, offsetof(shared::SplatListState, groups)};
    const gpu::Buffer* from = &items;
    const gpu::Buffer* to = &other;
    const bool scans = counts_.bytes() > kFewBlocks * kBytesOfBlock;
    const gpu::Kernel& scatter = scans ? kernels_.scatter : kernels_.scatterWithoutScan;
    for (int shift = 0; shift < bits; shift += kDigitBits) {
        const shared::SplatSortPush push{static_cast<std::uint32_t>(shift)};
        recorder.dispatch(kernels_.count, blocks, push, {state, *from, counts_});
        if (scans)
            recorder.dispatch(kernels_.scan, {shared::kSortDigits * shared::kListThreads}, push,
                              {state, counts_, totals_});
        recorder.dispatch(scatter, blocks, push, {state, *from, counts_, totals_, *to});
        std::swap(from, to);
    }
    return *from;
}

}  // namespace macula::splat
