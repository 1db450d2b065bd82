#include "pipeline/splat/draw/raster_kernels.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/check.h"
#include "pipeline/splat/draw/radix_sort.h"
#include "pipeline/splat/native/native_gather.h"
#include "pipeline/splat/native/native_project.h"
#include "pipeline/splat/native/native_raster.h"
#include "pipeline/splat/native/native_raster_back.h"
#include "shaders/splat.h"
#include "shared/splat_frame.h"

namespace macula::splat {

namespace {

// The subgroup size to require of the backward kernel, whose sums are laid out by it: 32 if the device allows
// it. Without a requirement, a device with several sizes may choose another for each kernel.
std::uint32_t askedSubgroupSize(const gpu::DeviceInfo& info) {
    return info.maxSubgroupSize == 0 ? 0 : std::clamp(32u, info.minSubgroupSize, info.maxSubgroupSize);
}

}  // namespace

Result<RasterKernels> RasterKernels::create(const std::shared_ptr<gpu::Device>& device, int shDegree,
                                            const RasterShape& shape) {
    MACULA_CHECK_EQ(shape.tileRows % shape.rowsPerThread, 0);
    const int threadRows = shape.tileRows / shape.rowsPerThread;
    const int threads = shared::kTileColumns * threadRows;
    const std::uint32_t asked = askedSubgroupSize(device->info());
    const int subgroup = static_cast<int>(asked > 0 ? asked : device->info().subgroupSize);
    const int slots = (threads + subgroup - 1) / subgroup;
    const int slotRows = std::min(threads, subgroup) / shared::kTileColumns * shape.rowsPerThread;

    const std::vector<gpu::Specialization> tile{{"kRows", shape.rowsPerThread}, {2u, threads}};
    const std::vector<gpu::Specialization> degree{{"kDegree", shDegree}};
    std::vector<gpu::Specialization> tileSlots = tile;
    tileSlots.emplace_back("kSlots", slots);
    tileSlots.emplace_back("kLanes", std::min(threads, subgroup));
    std::vector<gpu::Specialization> degreeSlots = degree;
    degreeSlots.emplace_back("kSlots", slots);
    MACULA_TRY(gpu::Kernel project,
               gpu::Kernel::create(device, shaders::splat_project_comp,
                                   {.specializations = degree, .native = nativeProject(shDegree)}));
    MACULA_TRY(gpu::Kernel raster, gpu::Kernel::create(device, shaders::splat_raster_comp,
                                                       {.specializations = tile, .native = nativeRaster()}));
    RasterKernels kernels{.project = std::move(project), .raster = std::move(raster), .slots = slots};
    if (shDegree > 1) return kernels;
    if (subgroup < shared::kTileColumns)
        return Error{ErrorCode::deviceNotUsable,
                     Text("This device runs too few threads together to train models."),
                     {},
                     Text("Choose another device: `macula devices` lists them.")};
    MACULA_TRY(kernels.rasterBack,
               gpu::Kernel::create(device, shaders::splat_raster_back_comp,
                                   {.specializations = tileSlots,
                                    .subgroupSize = asked,
                                    .native = nativeRasterBack({.slots = slots, .rowsOfSlot = slotRows})}));
    MACULA_TRY(kernels.gather, gpu::Kernel::create(device, shaders::splat_gather_comp,
                                                   {.specializations = degreeSlots,
                                                    .native = nativeGather(shDegree, slots)}));
    return kernels;
}

std::uint64_t RasterKernels::floatsOfPair() const {
    return std::uint64_t(shared::kPairValues) * std::uint64_t(slots);
}

std::uint64_t RasterKernels::mostPairs(const gpu::DeviceInfo& info) const {
    if (!gather) return kMostSorted;
    const std::uint64_t floats =
        std::min({std::uint64_t(info.maxStorageBufferBytes) / sizeof(float),
                  info.maxAllocationBytes / sizeof(float), std::uint64_t(info.maxTexelBufferElements)});
    return floats / floatsOfPair();
}

}  // namespace macula::splat
