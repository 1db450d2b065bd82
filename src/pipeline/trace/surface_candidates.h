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

// How many items a dispatch of about 40 ms has, learnt from one to the next.
class Portions {
  public:
    explicit Portions(std::uint32_t firstItems) : items_(firstItems) {}

    // One dispatch, `submit(first, now)`, of the `left` items that begin with `first`; waits. How many it
    // had: a multiple of `grain`, or all.
    Result<std::uint32_t> next(
        gpu::Device& device, std::uint32_t first, std::uint32_t left, std::uint32_t grain,
        const std::function<Result<gpu::Ticket>(std::uint32_t, std::uint32_t)>& submit);

  private:
    std::uint32_t items_;  // of the next dispatch
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

// The search for them. Used by one thread at a time, the one that uses the device.
class CandidateSearch {
  public:
    // Searches until the effective sample size of the candidates' weights is `wanted`, or a few times as many
    // rays have found no more.
    static Result<CandidateSearch> begin(const SceneView& scene, double wanted);

    bool isDone() const { return isDone_; }
    // One dispatch, while it is not done; waits. The scene must be the one that it began with, and be looked
    // at as it was then.
    Result<void> step(const SceneView& scene, const gpu::Kernel& kernel);
    // When it is done.
    SurfaceCandidates take() { return std::move(result_); }

  private:
    CandidateSearch(std::vector<shared::SurfaceCell> cells, double wanted);
    Result<void> beginRound(const SceneView& scene);
    Result<void> endRound();

    std::vector<shared::SurfaceCell> cells_;
    std::vector<double> areas_;  // of the surfaces of cells_
    double areaMm2_ = 0.0;       // the sum of areas_
    double wanted_;
    Portions portions_;
    std::optional<gpu::Buffer> cellBuffer_, rayBuffer_, found_;
    std::uint32_t round_ = 0;
    std::uint32_t rays_ = 0;  // rays of this round; 0: it has not begun
    std::uint32_t done_ = 0;  // of these rays
    double next_;             // rays wanted of the next round
    double sum_ = 0.0, squares_ = 0.0, sent_ = 0.0;
    bool isDone_ = false;
    SurfaceCandidates result_;
};

}  // namespace macula::trace
