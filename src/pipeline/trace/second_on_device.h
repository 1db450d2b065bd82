// The second volume of a scene: its voxels on the device, and what it adds to the majorants of the volume.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "pipeline/trace/device_volume.h"
#include "pipeline/volume/additions.h"

namespace macula::trace {

// Used by one thread at a time, the one that uses the device.
class SecondOnDevice {
  public:
    // Nothing is shown yet. outOfMemory when the device cannot hold the grid of `second`.
    static Result<SecondOnDevice> create(const std::shared_ptr<gpu::Device>& device,
                                         std::shared_ptr<const Volume> second, const MemoryLimits& limits);

    // Uploads the voxels that its transfer function shows, and finds what they add to the majorant of each
    // brick of `volume`. `shown` must refer to that second volume. outOfMemory as DeviceVolume::show.
    Result<void> show(const DrawnSecondVolume& shown, const Volume& volume, const BrickGrid& grid);

    const std::shared_ptr<const Volume>& volume() const { return volume_; }
    const DeviceVolume& voxels() const { return voxels_; }
    std::span<const float> bounds() const { return bounds_; }  // by brick of the volume

  private:
    SecondOnDevice(std::shared_ptr<const Volume> volume, BrickGrid grid, DeviceVolume voxels)
        : volume_(std::move(volume)), made_{std::move(grid), {}}, voxels_(std::move(voxels)) {}

    std::shared_ptr<const Volume> volume_;
    SecondMedium made_;
    std::vector<float> bounds_;
    std::optional<DrawnSecondVolume> shownAs_;  // that made_ and bounds_ are for; nothing: still to be made
    DeviceVolume voxels_;
};

}  // namespace macula::trace
