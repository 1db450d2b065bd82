// The kernels of the rasterizer (rasterizer.h), specialised for a device, a degree of colour and a shape of
// tiles.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/splat/draw/raster_shape.h"

namespace macula::splat {

struct RasterKernels {
    gpu::Kernel project;
    gpu::Kernel raster;
    std::optional<gpu::Kernel> rasterBack;  // none for degrees that are only drawn
    std::optional<gpu::Kernel> gather;
    int slots = 1;  // subgroups of a tile: each writes its own sums for a pair

    // `shape` must have no zeros. deviceNotUsable when the device cannot compute derivatives for that degree.
    static Result<RasterKernels> create(const std::shared_ptr<gpu::Device>& device, int shDegree,
                                        const RasterShape& shape);

    // The floats that each pair of splat and tile has in the buffer of derivatives.
    std::uint64_t floatsOfPair() const;
    // The largest number of pairs whose derivatives fit into a buffer of the device.
    std::uint64_t mostPairs(const gpu::DeviceInfo& info) const;
};

}  // namespace macula::splat
