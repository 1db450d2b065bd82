#include "pipeline/trace/second_on_device.h"

#include <cstdint>
#include <utility>

#include "pipeline/volume/voxel_blocks.h"

namespace macula::trace {

Result<SecondOnDevice> SecondOnDevice::create(const std::shared_ptr<gpu::Device>& device,
                                              std::shared_ptr<const Volume> second,
                                              const MemoryLimits& limits) {
    BrickGrid grid = makeBrickGrid(*second);
    MemoryLimits ofSecond = limits;
    ofSecond.isSecond = true;
    MACULA_TRY(DeviceVolume voxels, DeviceVolume::create(device, second, grid, ofSecond));
    return SecondOnDevice(std::move(second), std::move(grid), std::move(voxels));
}

// Uploads the voxels of its gradients too: denoiser and shading need them where this volume dominates.
Result<void> SecondOnDevice::show(const DrawnSecondVolume& shown, const Volume& volume,
                                  const BrickGrid& grid) {
    // A change of the first volume's transfer function changes nothing here.
    if (shownAs_ == shown) return {};
    shownAs_.reset();
    made_.medium = makeMedium(*volume_, made_.grid, *shown.function);
    std::vector<std::uint8_t> alsoShown;
    addReachOfGradients(made_.grid, made_.medium.bounds, alsoShown);
    MACULA_TRY_VOID(voxels_.show(made_.grid, made_.medium.bounds, alsoShown, made_.medium.extinctionPerMm));
    if (voxels_.isCoarse()) coverCoarseBlocks(made_.medium, made_.grid, voxels_.levels());
    bounds_ = boundsInVolume(shown, made_, volume, grid);
    shownAs_ = shown;
    return {};
}

}  // namespace macula::trace
