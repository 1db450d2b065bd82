#include "pipeline/trace/native_surface_points.h"

#include <array>
#include <atomic>
#include <memory>

#include "base/parallel.h"
#include "pipeline/trace/native_tables.h"
#include "shared/surface_params.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/trace/native_surface_points.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>
// After it.
#include "pipeline/trace/path_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace macula::trace {
namespace HWY_NAMESPACE {
namespace {

// The threads of surface_points.comp: each has a few paths around a point, and some taps. Each lane follows
// the paths of one such thread after the other.
class PointPaths {
  public:
    PointPaths(const NativeHost& host, const gpu::NativeDispatch& dispatch, std::atomic<std::uint32_t>& next)
        : host_(host),
          points_(dispatch.binding<const glm::vec4>(16)),
          sums_(dispatch.binding<shared::SurfaceSums>(17)),
          push_(dispatch.push<shared::SurfacePush>()),
          threads_(dispatch.groups()[0] * shared::kSurfaceGroup),
          next_(next) {}

    bool start(std::size_t lane, NativeHost::Path& path, NativeHost::Rng& rng) {
        Thread& t = lanes_[lane];
        if (t.done == shared::kSurfacePaths) {
            if (t.isTaken) finish(t, rng);
            if (!take(t, rng)) return false;
        }
        int rounds = 0;
        path = host_.startTowards(glm::vec3(t.point), std::abs(t.point.w), t.point.w < 0.0f,
                                  {t.before + t.done, t.net}, rng, rounds, t.weight);
        return true;
    }

    void endRay(std::size_t, const NativeHost::Path&) {}

    void endPath(std::size_t lane, const NativeHost::Path& path) {
        Thread& t = lanes_[lane];
        const glm::vec4 value = glm::vec4(path.radiance, path.coverage) * t.weight;
        if (host_.isFinite(value)) {
            t.found.radiance += glm::vec3(value);
            t.found.coverage += value.w;
            t.found.lost -= 1.0f;
        }
        ++t.done;
    }

  private:
    struct Thread {
        bool isTaken = false;
        std::uint32_t index = 0;
        glm::vec4 point{0.0f};
        std::uint32_t net = 0;     // all paths of a point form one
        std::uint32_t before = 0;  // points of the net before those of this thread
        std::uint32_t done = shared::kSurfacePaths;
        float weight = 0.0f;  // of the current path
        shared::SurfaceSums found{};
    };

    bool take(Thread& t, NativeHost::Rng& rng) {
        t = {};
        const std::uint32_t n = next_++;
        if (n >= threads_) return false;
        const std::uint32_t seed = host_.params.seed;
        t.isTaken = true;
        t.index = push_.first * shared::kSurfaceLanes + n;
        const std::uint32_t at = t.index / shared::kSurfaceLanes;
        const std::uint32_t lane = t.index % shared::kSurfaceLanes;
        t.point = points_[at];
        t.net = host_.hashOf(push_.base + at, seed ^ 0x2545f491u);
        t.before = (push_.pass * shared::kSurfaceLanes + lane) * shared::kSurfacePaths;
        rng = host_.makeRng(push_.base + at, lane, 8u + push_.pass, seed ^ 0x5f0f1e5du);
        t.done = 0;
        t.found.lost = float(shared::kSurfacePaths);
        return true;
    }

    void finish(Thread& t, NativeHost::Rng& rng) {
        const auto around = host_.surroundingsOf(glm::vec3(t.point), std::abs(t.point.w), t.point.w < 0.0f,
                                                 int(t.index % shared::kSurfaceLanes),
                                                 int(shared::kSurfaceLanes), int(shared::kSurfaceTaps), rng);
        t.found.taps = float(shared::kSurfaceTaps);
        t.found.mass = around.mass;
        t.found.first = around.first;
        t.found.diagonal = around.diagonal;
        t.found.offAxis = around.offAxis;
        sums_[t.index] = t.found;
    }

    NativeHost host_;
    std::span<const glm::vec4> points_;
    std::span<shared::SurfaceSums> sums_;
    shared::SurfacePush push_;
    std::uint32_t threads_;
    std::atomic<std::uint32_t>& next_;
    std::array<Thread, kFlights> lanes_{};
};

}  // namespace

void findCandidates(const gpu::NativeDispatch& dispatch, const SceneKind& scene) {
    const shared::TraceParams& params = dispatch.binding<const shared::TraceParams>(0)[0];
    const NativeHost prototype(nativeTables(dispatch, params, {.scene = scene}), params, Filter::trilinear);
    const auto cells = dispatch.binding<const shared::SurfaceCell>(16);
    const auto cellOfRay = dispatch.binding<const std::uint32_t>(17);
    const auto candidates = dispatch.binding<shared::SurfaceCandidate>(18);
    const auto push = dispatch.push<shared::CandidatePush>();
    parallelFor(dispatch.groups()[0], [&](std::size_t group) {
        NativeHost host = prototype;
        for (std::uint32_t n = 0; n < shared::kSurfaceGroup; ++n) {
            const std::uint32_t ray = push.first + std::uint32_t(group) * shared::kSurfaceGroup + n;
            const shared::SurfaceCell& cell = cells[cellOfRay[ray]];
            NativeHost::Rng rng = host.makeRng(ray, push.round, 2u, params.seed ^ 0x3c6ef372u);
            const NativeHost::Candidate found =
                host.findCandidate(cell.low, cell.high, shared::kCandidateDirections, rng);
            candidates[ray] = {found.at, found.weight, found.density};
        }
    });
}

void measurePoints(const gpu::NativeDispatch& dispatch, const SceneKind& scene) {
    const shared::TraceParams& params = dispatch.binding<const shared::TraceParams>(0)[0];
    const HostTables<PooledVoxels> tables = nativeTables(dispatch, params, {.scene = scene});
    const NativeHost host(tables, params, Filter::trilinear);
    std::atomic<std::uint32_t> next{0};
    parallelFor(coreCount(), [&](std::size_t) {
        PointPaths paths(host, dispatch, next);
        std::make_unique<PathLanes<PointPaths>>(host, tables, Filter::trilinear, scene.coarse, paths)->work();
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace macula::trace {

HWY_EXPORT(findCandidates);
HWY_EXPORT(measurePoints);

gpu::NativeKernel nativeCandidates(const SceneKind& scene) {
    return [scene](const gpu::NativeDispatch& dispatch) {
        HWY_DYNAMIC_DISPATCH(findCandidates)(dispatch, scene);
    };
}

gpu::NativeKernel nativeSurfacePoints(const SceneKind& scene) {
    return [scene](const gpu::NativeDispatch& dispatch) {
        HWY_DYNAMIC_DISPATCH(measurePoints)(dispatch, scene);
    };
}

}  // namespace macula::trace
#endif
