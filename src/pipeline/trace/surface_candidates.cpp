#include "pipeline/trace/surface_candidates.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numeric>

#include "pipeline/gpu/transfer.h"
#include "pipeline/trace/scene_view.h"
#include "pipeline/volume/brick_grid.h"

namespace macula::trace {

namespace {

using Clock = std::chrono::steady_clock;
using shared::kSurfaceGroup;
using shared::SurfaceCandidate;
using shared::SurfaceCell;

constexpr double kDispatchMs = 40.0;
constexpr std::uint32_t kFirstRays = 1u << 12;  // in the first dispatch, before the device's pace is known
constexpr std::uint32_t kMostRays = 1u << 20;   // in a round: 20 MiB of candidates
constexpr double kRaysPerWanted = 32.0;  // after so many, matter is too faint or small: the search ends
// Rays into small cells cost some marching as well: halving the cells pays only if the rays needed fall to
// this fraction.
constexpr double kSmallerPays = 0.6;

glm::dvec3 faceAreas(const glm::dmat3& worldFromVoxel) {
    return {glm::length(glm::cross(worldFromVoxel[1], worldFromVoxel[2])),
            glm::length(glm::cross(worldFromVoxel[2], worldFromVoxel[0])),
            glm::length(glm::cross(worldFromVoxel[0], worldFromVoxel[1]))};
}

glm::ivec3 brickOf(std::size_t index, const glm::ivec3& grid) {
    const auto plane = std::size_t(grid.x) * std::size_t(grid.y);
    const auto inPlane = static_cast<int>(index % plane);
    return {inPlane % grid.x, inPlane / grid.x, static_cast<int>(index / plane)};
}

// Cells of `edge` bricks, tight around those with matter.
std::vector<SurfaceCell> cellsOf(std::span<const std::size_t> bricks, const glm::ivec3& grid, int edge,
                                 const glm::ivec3& voxels) {
    const glm::ivec3 groups = (grid + edge - 1) / edge;
    const auto count = std::size_t(groups.x) * std::size_t(groups.y) * std::size_t(groups.z);
    std::vector<glm::ivec3> low(count, grid);
    std::vector<glm::ivec3> high(count, glm::ivec3(0));
    for (const std::size_t index : bricks) {
        const glm::ivec3 brick = brickOf(index, grid);
        const glm::ivec3 group = brick / edge;
        const auto g =
            (std::size_t(group.z) * std::size_t(groups.y) + std::size_t(group.y)) * std::size_t(groups.x) +
            std::size_t(group.x);
        low[g] = glm::min(low[g], brick);
        high[g] = glm::max(high[g], brick + 1);
    }
    std::vector<SurfaceCell> cells;
    for (std::size_t g = 0; g < count; ++g) {
        if (high[g].x <= low[g].x) continue;
        const auto corner = [&](const glm::ivec3& brick) {  // bricks begin half a voxel before the volume
            return glm::clamp(glm::vec3(brick * kBrickVoxels) - 0.5f, glm::vec3(0.0f), glm::vec3(voxels));
        };
        cells.push_back({corner(low[g]), corner(high[g])});
    }
    return cells;
}

}  // namespace

Result<std::uint32_t> Portions::next(
    gpu::Device& device, std::uint32_t first, std::uint32_t left, std::uint32_t grain,
    const std::function<Result<gpu::Ticket>(std::uint32_t, std::uint32_t)>& submit) {
    const std::uint32_t whole = std::max(items_ / grain, 1u) * grain;
    const std::uint32_t now = std::min(whole, left);
    const auto begin = Clock::now();
    MACULA_TRY(const gpu::Ticket ticket, submit(first, now));
    MACULA_TRY([[maybe_unused]] const bool done, device.waitFor(ticket));
    const double ms = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    // The first dispatch compiles, and says little; the last of a round is short.
    const double most = device.isCpu() ? 2.0 : 8.0;  // the most by which a dispatch may exceed the last one
    const double ratio = std::clamp(kDispatchMs / std::max(ms, 0.1), 0.5, most);
    if (now == whole || ratio < 1.0) items_ = std::max(static_cast<std::uint32_t>(items_ * ratio), grain);
    return now;
}

std::vector<double> areasOf(std::span<const SurfaceCell> cells, const glm::dmat3& worldFromVoxel) {
    const glm::dvec3 face = faceAreas(worldFromVoxel);
    std::vector<double> areas;
    for (const SurfaceCell& cell : cells) {
        const glm::dvec3 size = glm::dvec3(cell.high) - glm::dvec3(cell.low);
        areas.push_back(2.0 *
                        (face.x * size.y * size.z + face.y * size.z * size.x + face.z * size.x * size.y));
    }
    return areas;
}

std::vector<SurfaceCell> matterCells(std::span<const float> bounds, const glm::ivec3& voxels,
                                     const glm::dmat3& worldFromVoxel) {
    const glm::ivec3 grid = brickCount(voxels);
    std::vector<std::size_t> bricks;
    for (std::size_t i = 0; i < bounds.size(); ++i)
        if (bounds[i] > 0.0f) bricks.push_back(i);
    if (bricks.empty()) return {};
    std::vector<SurfaceCell> best;
    double least = 0.0;
    int edge = 1;
    while (edge < std::max({grid.x, grid.y, grid.z})) edge *= 2;
    for (; edge > 0; edge /= 2) {
        std::vector<SurfaceCell> cells = cellsOf(bricks, grid, edge, voxels);
        const std::vector<double> areas = areasOf(cells, worldFromVoxel);
        const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
        if (!best.empty() && !(area < kSmallerPays * least)) continue;
        best = std::move(cells);
        least = area;
    }
    return best;
}

CandidateSearch::CandidateSearch(std::vector<SurfaceCell> cells, double wanted)
    : cells_(std::move(cells)), wanted_(wanted), portions_(kFirstRays), next_(wanted) {}

Result<CandidateSearch> CandidateSearch::begin(const SceneView& view, double wanted) {
    const DeviceScene& scene = view.scene();
    const Volume& volume = *scene.volume();
    const glm::dmat3 worldFromVoxel(volume.worldFromVoxel());
    std::vector<SurfaceCell> cells = matterCells(scene.bounds(), volume.size(), worldFromVoxel);
    // A grey face shows values wherever it is, also where there is no matter.
    if (scene.hasGreyFaces()) cells = {{glm::vec3(0.0f), glm::vec3(volume.size())}};
    CandidateSearch search(std::move(cells), wanted);
    search.isDone_ = search.cells_.empty();
    if (search.isDone_) return search;
    search.areas_ = areasOf(search.cells_, worldFromVoxel);
    search.areaMm2_ = std::accumulate(search.areas_.begin(), search.areas_.end(), 0.0);
    MACULA_TRY(search.cellBuffer_,
               gpu::Buffer::create(scene.device(),
                                   {.label = "cells", .bytes = search.cells_.size() * sizeof(SurfaceCell)}));
    MACULA_TRY_VOID(gpu::uploadTo<SurfaceCell>(*search.cellBuffer_, search.cells_));
    return search;
}

Result<void> CandidateSearch::beginRound(const SceneView& scene) {
    const auto groups =
        static_cast<std::uint32_t>(std::clamp(next_, 1.0, double(kMostRays))) / kSurfaceGroup + 1;
    const std::uint32_t rays = groups * kSurfaceGroup;
    // Cells get rays in proportion to their surface.
    std::vector<std::uint32_t> cellOfRay(rays);
    const double offset = std::fmod(0.5 + 0.6180339887498949 * round_, 1.0);
    double end = areas_[0];
    for (std::uint32_t ray = 0, cell = 0; ray < rays; ++ray) {
        while (areaMm2_ * ((ray + offset) / rays) > end && cell + 1 < cells_.size()) end += areas_[++cell];
        cellOfRay[ray] = cell;
    }
    const std::shared_ptr<gpu::Device>& device = scene.scene().device();
    MACULA_TRY(rayBuffer_, gpu::Buffer::create(device, {.label = "rays", .bytes = std::uint64_t(rays) * 4}));
    MACULA_TRY_VOID(gpu::uploadTo<std::uint32_t>(*rayBuffer_, cellOfRay));
    MACULA_TRY(found_,
               gpu::Buffer::create(
                   device, {.label = "candidates", .bytes = std::uint64_t(rays) * sizeof(SurfaceCandidate)}));
    rays_ = rays;
    done_ = 0;
    return {};
}

Result<void> CandidateSearch::step(const SceneView& scene, const gpu::Kernel& kernel) {
    MACULA_CHECK(!isDone_);
    if (rays_ == 0) MACULA_TRY_VOID(beginRound(scene));
    const std::shared_ptr<gpu::Device>& device = scene.scene().device();
    const auto submit = [&](std::uint32_t first, std::uint32_t now) -> Result<gpu::Ticket> {
        MACULA_TRY(auto recorder, gpu::Recorder::create(device, "candidates"));
        std::vector<gpu::Binding> bindings = scene.bindings();
        bindings.emplace_back(*cellBuffer_);
        bindings.emplace_back(*rayBuffer_);
        bindings.emplace_back(*found_);
        recorder.dispatch(kernel, {now}, shared::CandidatePush{.first = first, .round = round_}, bindings);
        return recorder.submit();
    };
    MACULA_TRY(const std::uint32_t now, portions_.next(*device, done_, rays_ - done_, kSurfaceGroup, submit));
    done_ += now;
    return done_ < rays_ ? Result<void>() : endRound();
}

Result<void> CandidateSearch::endRound() {
    MACULA_TRY(const auto values, gpu::read<SurfaceCandidate>(*found_));
    for (const SurfaceCandidate& value : values) {
        if (!(value.weight > 0.0f) || !std::isfinite(value.weight)) continue;
        result_.found.push_back(value);
        sum_ += double(value.weight);
        squares_ += double(value.weight) * double(value.weight);
    }
    sent_ += rays_;
    ++round_;
    rays_ = 0;
    // The effective sample size (Kish).
    const double effective = squares_ > 0.0 ? sum_ * sum_ / squares_ : 0.0;
    isDone_ = effective >= wanted_ || sent_ >= kRaysPerWanted * wanted_;
    if (isDone_) result_.areaMm2 = sum_ * 0.25 * areaMm2_ / sent_;
    const double missing = 1.05 * (wanted_ - effective) * sent_ / std::max(effective, 1.0);
    next_ = std::clamp(missing, 1.0, std::max(1.0, std::min(4.0 * sent_, kRaysPerWanted * wanted_ - sent_)));
    return {};
}

}  // namespace macula::trace
