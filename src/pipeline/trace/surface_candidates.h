// Places on what can be seen, found by rays from all sides: what surface points are chosen from.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "shared/surface_params.h"

namespace macula::trace {

class DeviceScene;

// Runs a kernel over many items in dispatches of about 40 ms each, which are waited for.
class Portions {
  public:
    // `keepGoing` may be empty, and must outlive this.
    Portions(gpu::Device& device, std::uint32_t firstItems, const std::function<bool()>& keepGoing)
        : device_(device), items_(firstItems), keepGoing_(keepGoing) {}

    // `submit(first, count)` for all of `count`, a multiple of `grain` each time but what is left. Cancelled
    // when keepGoing says no.
    Result<void> run(std::uint32_t count, std::uint32_t grain,
                     const std::function<Result<gpu::Ticket>(std::uint32_t, std::uint32_t)>& submit);

  private:
    gpu::Device& device_;
    std::uint32_t items_;  // of the next dispatch
    const std::function<bool()>& keepGoing_;
};

// Boxes around all bricks with a bound above 0, of as many bricks along each edge as makes their surfaces
// smallest in all: then most rays through them meet matter. `bounds` by brick, x fastest; nothing where there
// is no such brick.
std::vector<shared::SurfaceCell> matterCells(std::span<const float> bounds, const glm::ivec3& voxels,
                                             const glm::dmat3& worldFromVoxel);

// Area in mm^2 of the surface of each.
std::vector<double> areasOf(std::span<const shared::SurfaceCell> cells, const glm::dmat3& worldFromVoxel);

struct SurfaceCandidates {
    std::vector<shared::SurfaceCandidate> found;  // each with a weight above 0
    double areaMm2 = 0.0;                         // of all that they stand for
};

// So many that they tell as much as `wanted` of equal weight, or as can be found in a few times more rays.
Result<SurfaceCandidates> findCandidates(const std::shared_ptr<gpu::Device>& device, const DeviceScene& scene,
                                         const gpu::Kernel& kernel, double wanted,
                                         const std::function<bool()>& keepGoing);

}  // namespace macula::trace
