// Candidates for surface points: the places where rays from all sides meet visible matter.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/resources.h"
#include "shared/surface_params.h"

namespace macula::trace {

class SceneView;

// The number of items in a dispatch of about 40 ms, adjusted from one dispatch to the next.
class Portions {
  public:
    explicit Portions(std::uint32_t firstItems) : items_(firstItems) {}

    // Submits one dispatch, `submit(first, now)`, over some of the `left` items that begin with `first`;
    // waits. Returns how many: a multiple of `grain`, or all.
    Result<std::uint32_t> next(
        gpu::Device& device, std::uint32_t first, std::uint32_t left, std::uint32_t grain,
        const std::function<Result<gpu::Ticket>(std::uint32_t, std::uint32_t)>& submit);

  private:
    std::uint32_t items_;  // of the next dispatch
};

// Boxes around all bricks with a majorant above 0. Their edge, in bricks, is chosen so that their total
// surface is small: then most rays through them meet matter. `bounds` by brick, x fastest; empty if there is
// no such brick.
std::vector<shared::SurfaceCell> matterCells(std::span<const float> bounds, const glm::ivec3& voxels,
                                             const glm::dmat3& worldFromVoxel);

// The surface area of each cell in mm^2.
std::vector<double> areasOf(std::span<const shared::SurfaceCell> cells, const glm::dmat3& worldFromVoxel);

struct SurfaceCandidates {
    std::vector<shared::SurfaceCandidate> found;  // each with a weight above 0
    double areaMm2 = 0.0;                         // that all of them together stand for
};

// The search for candidates. Used by one thread at a time, the one that uses the device.
class CandidateSearch {
  public:
    // Searches until the effective sample size of the candidates' weights is `wanted`, or until 32 rays for
    // each wanted candidate have been sent.
    static Result<CandidateSearch> begin(const SceneView& scene, double wanted);

    bool isDone() const { return isDone_; }
    // One dispatch, while it is not done; waits. Scene and view must be those with which the search began.
    Result<void> step(const SceneView& scene, const gpu::Kernel& kernel);
    // When it is done.
    SurfaceCandidates take() { return std::move(result_); }

  private:
    CandidateSearch(std::vector<shared::SurfaceCell> cells, double wanted);
    Result<void> beginRound(const SceneView& scene);
    Result<void> endRound();

    std::vector<shared::SurfaceCell> cells_;
    std::vector<double> areas_;  // mm^2, of the surface of each of cells_
    double areaMm2_ = 0.0;       // the sum of areas_
    double wanted_;
    Portions portions_;
    std::optional<gpu::Buffer> cellBuffer_, rayBuffer_, found_;
    std::uint32_t round_ = 0;
    std::uint32_t rays_ = 0;  // rays of this round; 0: it has not begun
    std::uint32_t done_ = 0;  // of these rays
    double next_;             // rays wanted in the next round
    double sum_ = 0.0, squares_ = 0.0, sent_ = 0.0;
    bool isDone_ = false;
    SurfaceCandidates result_;
};

}  // namespace macula::trace
