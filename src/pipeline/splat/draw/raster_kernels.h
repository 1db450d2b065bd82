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
    std::optional<gpu::Kernel> rasterBack;  // not of degrees that are only drawn
    std::optional<gpu::Kernel> gather;
    int slots = 1;  // subgroups of a tile: each writes sums of its own for a pair

    // Of a shape without zeros. deviceNotUsable when the device cannot find derivatives of that degree.
    static Result<RasterKernels> create(const std::shared_ptr<gpu::Device>& device, int shDegree,
                                        const RasterShape& shape);

    // Floats in the buffer of derivatives for each pair of splat and tile.
    std::uint64_t floatsOfPair() const;
    // The most pairs for whose derivatives a buffer of that device can have room.
    std::uint64_t mostPairs(const gpu::DeviceInfo& info) const;
};

}  // namespace macula::splat
