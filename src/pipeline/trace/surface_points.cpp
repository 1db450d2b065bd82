#include "pipeline/trace/surface_points.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "base/frames.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/trace/device_scene.h"
#include "pipeline/trace/point_light.h"
#include "pipeline/volume/brick_grid.h"
#include "shared/surface_params.h"

namespace macula::trace {

namespace {

using Clock = std::chrono::steady_clock;
using shared::kSurfaceLanes;

constexpr int kDirections = 8;  // that a candidate is looked at from
constexpr std::uint32_t kPerBrick = 8;
constexpr int kMostRounds = 16;                      // of candidates
constexpr std::uint64_t kMostCandidates = 1u << 22;  // of a round: 64 MiB

constexpr double kDispatchMs = 40.0;
constexpr std::uint32_t kFirstPortion = 1u << 12;  // threads, before anything is known of the device

Error cancelled() {
    return {ErrorCode::cancelled, "The search for points on the surface was cancelled.", {}, {}};
}

// Cuts `count` items into dispatches of about kDispatchMs; each is waited for.
Result<void> inPortions(gpu::Device& device, std::uint32_t count, std::uint32_t threadsPerItem,
                        const std::function<bool()>& keepGoing,
                        const std::function<Result<gpu::Ticket>(std::uint32_t, std::uint32_t)>& submit) {
    std::uint32_t portion = std::max(kFirstPortion / threadsPerItem, 1u);
    for (std::uint32_t first = 0; first < count;) {
        const std::uint32_t now = std::min(portion, count - first);
        const auto begin = Clock::now();
        MACULA_TRY(const gpu::Ticket ticket, submit(first, now));
        MACULA_TRY([[maybe_unused]] const bool done, device.waitFor(ticket));
        const double ms = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
        first += now;
        // The first one compiles, and tells little.
        const double ratio = kDispatchMs / std::max(ms, 0.1);
        portion = std::max(static_cast<std::uint32_t>(portion * std::clamp(ratio, 0.5, 2.0)), 64u);
        if (keepGoing && !keepGoing()) return cancelled();
    }
    return {};
}

// Interleaves the bits of three numbers of ten bits: neighbours in this order are neighbours in space.
std::uint32_t morton(const glm::uvec3& p) {
    const auto spread = [](std::uint32_t v) {
        v = (v | v << 16) & 0x030000ffu;
        v = (v | v << 8) & 0x0300f00fu;
        v = (v | v << 4) & 0x030c30c3u;
        return (v | v << 2) & 0x09249249u;
    };
    return spread(p.x) | spread(p.y) << 1 | spread(p.z) << 2;
}

// Every `step` of the summed weight along a curve through space one candidate, so that they are spread as
// evenly as the weight is.
std::vector<glm::vec4> chosen(std::vector<glm::vec4> seen, const glm::vec3& size, std::uint32_t count) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> order(seen.size());
    for (std::uint32_t i = 0; i < seen.size(); ++i) {
        const glm::vec3 at = glm::clamp(glm::vec3(seen[i]) / size * 1024.0f, 0.0f, 1023.0f);
        order[i] = {morton(glm::uvec3(at)), i};
    }
    std::sort(order.begin(), order.end());
    double total = 0.0;
    for (const glm::vec4& candidate : seen) total += candidate.w;
    const double step = total / count;
    std::vector<glm::vec4> result;
    result.reserve(count);
    double sum = 0.0;
    double next = 0.5 * step;
    for (const auto& entry : order) {
        sum += seen[entry.second].w;
        if (sum <= next) continue;
        result.push_back(seen[entry.second]);
        next += step * std::ceil((sum - next) / step);  // one that is worth several is one all the same
    }
    return result;
}

class Search {
  public:
    Search(std::shared_ptr<gpu::Device> device, const DeviceScene& scene,
           const std::function<bool()>& keepGoing)
        : device_(std::move(device)), scene_(scene), keepGoing_(keepGoing) {
        const Volume& volume = *scene.volume();
        voxelMm3_ = std::abs(glm::determinant(glm::dmat3(volume.worldFromVoxel())));
    }

    // Candidates with weight, and what area they are on.
    Result<std::vector<glm::vec4>> candidates(const gpu::Kernel& kernel, double wanted, double& areaMm2) {
        std::vector<std::uint32_t> bricks;
        const std::span<const float> bounds = scene_.bounds();
        for (std::uint32_t i = 0; i < bounds.size(); ++i)
            if (bounds[i] > 0.0f) bricks.push_back(i);
        std::vector<glm::vec4> seen;
        areaMm2 = 0.0;
        if (bricks.empty()) return seen;
        const auto perBrick = static_cast<std::uint32_t>(
            std::clamp<std::uint64_t>(kMostCandidates / bricks.size(), 1u, kPerBrick));
        const auto count = static_cast<std::uint32_t>(bricks.size()) * perBrick;
        MACULA_TRY(gpu::Buffer brickList,
                   gpu::Buffer::create(device_, {.label = "bricks", .bytes = bricks.size() * 4}));
        MACULA_TRY_VOID(gpu::uploadTo<std::uint32_t>(brickList, bricks));
        MACULA_TRY(gpu::Buffer found,
                   gpu::Buffer::create(device_, {.label = "candidates", .bytes = count * sizeof(glm::vec4)}));
        double sum = 0.0;
        double squares = 0.0;
        int round = 0;
        // So many as there were if all weighed the same.
        const auto enough = [&] { return sum * sum >= wanted * squares; };
        do {
            MACULA_TRY_VOID(
                inPortions(*device_, count, 1, keepGoing_,
                           [&](std::uint32_t first, std::uint32_t now) -> Result<gpu::Ticket> {
                               MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "candidates"));
                               std::vector<gpu::Binding> bindings = scene_.bindings();
                               bindings.emplace_back(brickList);
                               bindings.emplace_back(found);
                               const shared::CandidatePush push{.first = first,
                                                                .count = now,
                                                                .perBrick = perBrick,
                                                                .round = static_cast<std::uint32_t>(round),
                                                                .directions = kDirections};
                               recorder.dispatch(kernel, {now}, push, bindings);
                               return recorder.submit();
                           }));
            MACULA_TRY(const auto values, gpu::read<glm::vec4>(found));
            for (const glm::vec4& value : values) {
                if (!(value.w > 0.0f) || !std::isfinite(value.w)) continue;
                seen.push_back(value);
                sum += value.w;
                squares += double(value.w) * value.w;
            }
            ++round;
        } while (round < kMostRounds && sum > 0.0 && !enough());
        constexpr double kVoxels = double(kBrickVoxels) * kBrickVoxels * kBrickVoxels;
        areaMm2 = sum * voxelMm3_ * kVoxels / (double(perBrick) * round);
        return seen;
    }

    Result<void> measure(const gpu::Kernel& kernel, const std::vector<glm::vec4>& at, std::uint32_t paths,
                         SurfacePoints& result) {
        const auto count = static_cast<std::uint32_t>(at.size());
        std::vector<glm::vec4> points = at;
        for (glm::vec4& point : points) point.w = radiusMm(result.areaMm2, point.w);
        MACULA_TRY(gpu::Buffer places,
                   gpu::Buffer::create(device_, {.label = "points", .bytes = count * sizeof(glm::vec4)}));
        MACULA_TRY_VOID(gpu::uploadTo<glm::vec4>(places, points));
        MACULA_TRY(gpu::Buffer sums,
                   gpu::Buffer::create(device_, {.label = "sums of points",
                                                 .bytes = std::uint64_t(count) * kSurfaceLanes *
                                                          sizeof(shared::SurfaceSums)}));
        MACULA_TRY_VOID(inPortions(
            *device_, count, kSurfaceLanes, keepGoing_,
            [&](std::uint32_t first, std::uint32_t now) -> Result<gpu::Ticket> {
                MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "surface points"));
                std::vector<gpu::Binding> bindings = scene_.bindings();
                bindings.emplace_back(places);
                bindings.emplace_back(sums);
                const shared::SurfacePush push{
                    .first = first, .count = now, .paths = (paths + kSurfaceLanes - 1) / kSurfaceLanes};
                recorder.dispatch(kernel, {now * kSurfaceLanes}, push, bindings);
                return recorder.submit();
            }));
        MACULA_TRY(const auto found, gpu::read<shared::SurfaceSums>(sums));
        std::vector<GatheredLight> gathered;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto sumsOf = std::span(found).subspan(i * kSurfaceLanes, kSurfaceLanes);
            result.points.push_back(pointOf(points[i], sumsOf, result));
            GatheredLight& light = gathered.emplace_back();
            for (const shared::SurfaceSums& s : sumsOf) {
                light.radiance += glm::dvec3(s.radiance);
                light.coverage += double(s.coverage);
            }
        }
        shareLight(result.points, gathered);
        return {};
    }

  private:
    // As far as to its neighbours: on a surface, or in matter so thin that they lie behind one another too.
    static float radiusMm(double areaMm2, float weight) {
        return static_cast<float>(std::max(std::sqrt(areaMm2), std::cbrt(areaMm2 / double(weight))));
    }

    SurfacePoint pointOf(const glm::vec4& place, std::span<const shared::SurfaceSums> sums,
                         const SurfacePoints& all) const {
        glm::dvec3 first(0.0), diagonal(0.0), offAxis(0.0);
        double taps = 0.0, mass = 0.0;
        for (const shared::SurfaceSums& s : sums) {
            taps += double(s.taps);
            mass += double(s.mass);
            first += glm::dvec3(s.first);
            diagonal += glm::dvec3(s.diagonal);
            offAxis += glm::dvec3(s.offAxis);
        }
        SurfacePoint point{.radiusMm = place.w};
        // The tracer's voxel coordinates have integers at faces, those of a volume at centres.
        const glm::dvec3 at = transformPoint(scene_.volume()->worldFromVoxel(), glm::dvec3(place) - 0.5);
        point.positionMm = glm::vec3(at - all.originMm);
        point.extinctionPerMm = static_cast<float>(mass / taps);
        if (!(mass > 0.0)) return point;
        const glm::dvec3 centre = first / mass;
        glm::dmat3 spread(diagonal.x, offAxis.x, offAxis.z, offAxis.x, diagonal.y, offAxis.y, offAxis.z,
                          offAxis.y, diagonal.z);
        spread = spread / mass - glm::outerProduct(centre, centre);
        point.centreMm = glm::vec3(centre);
        point.spreadMm2 = glm::mat3(spread);
        return point;
    }

    std::shared_ptr<gpu::Device> device_;
    const DeviceScene& scene_;
    const std::function<bool()>& keepGoing_;
    double voxelMm3_ = 1.0;
};

}  // namespace

Result<SurfacePoints> findSurfacePoints(const std::shared_ptr<gpu::Device>& device, const DeviceScene& scene,
                                        TraceKernels& kernels, SceneKind kind,
                                        const SurfacePointOptions& options,
                                        const std::function<bool()>& keepGoing) {
    if (options.count < 1 || options.count > kMaxSurfacePoints || options.paths < 1 ||
        options.candidatesPerPoint < 1) {
        return Error{ErrorCode::usage,
                     "This number of points on the surface makes no sense.",
                     {},
                     "Ask for 1 to " + std::to_string(kMaxSurfacePoints) + " points, with 1 path or more."};
    }
    Search search(device, scene, keepGoing);
    SurfacePoints result;
    const glm::dvec3 size(scene.volume()->size());
    result.originMm = transformPoint(scene.volume()->worldFromVoxel(), 0.5 * size - 0.5);
    MACULA_TRY(const gpu::Kernel* candidates, kernels.candidates(kind));
    double areaMm2 = 0.0;
    MACULA_TRY(std::vector<glm::vec4> seen,
               search.candidates(*candidates, double(options.count) * options.candidatesPerPoint, areaMm2));
    if (seen.empty()) return result;
    const std::vector<glm::vec4> at = chosen(std::move(seen), glm::vec3(size), options.count);
    result.areaMm2 = areaMm2 / double(at.size());
    MACULA_TRY(const gpu::Kernel* points, kernels.surfacePoints(kind));
    MACULA_TRY_VOID(search.measure(*points, at, options.paths, result));
    return result;
}

}  // namespace macula::trace
