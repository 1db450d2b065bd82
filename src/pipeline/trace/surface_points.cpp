#include "pipeline/trace/surface_points.h"

#include <algorithm>
#include <cmath>

#include "base/frames.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/trace/device_scene.h"
#include "pipeline/trace/point_light.h"
#include "pipeline/trace/surface_candidates.h"
#include "shared/surface_params.h"

namespace macula::trace {

namespace {

using shared::kSurfaceGroup;
using shared::kSurfaceLanes;
using shared::SurfaceCandidate;

constexpr std::uint32_t kFirstPoints = 1u << 9;    // of a dispatch, before anything is known of the device
constexpr std::uint32_t kPointsAtOnce = 1u << 16;  // 38 MiB of sums

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
std::vector<SurfaceCandidate> chosen(const std::vector<SurfaceCandidate>& seen, const Volume& volume,
                                     std::uint32_t count) {
    const glm::dmat3 mm(volume.worldFromVoxel());
    const glm::vec3 spacing(glm::length(mm[0]), glm::length(mm[1]), glm::length(mm[2]));
    const glm::vec3 size = spacing * glm::vec3(volume.size());
    const glm::vec3 toCurve = spacing * (1024.0f / std::max({size.x, size.y, size.z}));
    std::vector<std::pair<std::uint32_t, std::uint32_t>> order(seen.size());
    double total = 0.0;
    for (std::uint32_t i = 0; i < seen.size(); ++i) {
        const glm::vec3 at = glm::clamp(seen[i].at * toCurve, 0.0f, 1023.0f);
        order[i] = {morton(glm::uvec3(at)), i};
        total += double(seen[i].weight);
    }
    std::sort(order.begin(), order.end());
    const double step = total / count;
    std::vector<SurfaceCandidate> result;
    result.reserve(count);
    double sum = 0.0;
    double next = 0.5 * step;
    for (const auto& entry : order) {
        sum += double(seen[entry.second].weight);
        if (sum <= next) continue;
        result.push_back(seen[entry.second]);
        next += step * std::ceil((sum - next) / step);  // one that is worth several is one all the same
    }
    return result;
}

// Sums over the lanes and passes of a point.
struct PointSums {
    GatheredLight light;
    double lost = 0.0, taps = 0.0, mass = 0.0;
    glm::dvec3 first{0.0}, diagonal{0.0}, offAxis{0.0};

    void add(const shared::SurfaceSums& s) {
        light.radiance += glm::dvec3(s.radiance);
        light.coverage += double(s.coverage);
        lost += double(s.lost);
        taps += double(s.taps);
        mass += double(s.mass);
        first += glm::dvec3(s.first);
        diagonal += glm::dvec3(s.diagonal);
        offAxis += glm::dvec3(s.offAxis);
    }
};

class Measurement {
  public:
    Measurement(std::shared_ptr<gpu::Device> device, const DeviceScene& scene, const gpu::Kernel& kernel,
                const std::function<bool()>& keepGoing)
        : device_(std::move(device)),
          scene_(scene),
          kernel_(kernel),
          portions_(*device_, kFirstPoints, keepGoing) {}

    Result<void> measure(const std::vector<SurfaceCandidate>& at, std::uint32_t paths,
                         SurfacePoints& result) {
        const auto passes = (paths - 1) / (kSurfaceLanes * shared::kSurfacePaths) + 1;
        std::vector<PointSums> sums(at.size());
        for (std::uint32_t base = 0; base < at.size(); base += kPointsAtOnce) {
            const auto count = std::min(kPointsAtOnce, static_cast<std::uint32_t>(at.size()) - base);
            // Whole groups: those beyond the last one are measured for nothing.
            constexpr std::uint32_t kGrain = kSurfaceGroup / kSurfaceLanes;
            const std::uint32_t padded = (count + kGrain - 1) / kGrain * kGrain;
            std::vector<glm::vec4> places;
            for (std::uint32_t i = 0; i < padded; ++i)
                places.push_back(placeOf(at[base + std::min(i, count - 1)], result.areaMm2));
            MACULA_TRY(
                gpu::Buffer placeBuffer,
                gpu::Buffer::create(device_, {.label = "points", .bytes = padded * sizeof(glm::vec4)}));
            MACULA_TRY_VOID(gpu::uploadTo<glm::vec4>(placeBuffer, places));
            MACULA_TRY(gpu::Buffer found,
                       gpu::Buffer::create(device_, {.label = "sums of points",
                                                     .bytes = std::uint64_t(padded) * kSurfaceLanes *
                                                              sizeof(shared::SurfaceSums)}));
            for (std::uint32_t pass = 0; pass < passes; ++pass) {
                const auto submit = [&](std::uint32_t first, std::uint32_t now) -> Result<gpu::Ticket> {
                    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "surface points"));
                    std::vector<gpu::Binding> bindings = scene_.bindings();
                    bindings.emplace_back(placeBuffer);
                    bindings.emplace_back(found);
                    const shared::SurfacePush push{.first = first, .base = base, .pass = pass};
                    recorder.dispatch(kernel_, {now * kSurfaceLanes}, push, bindings);
                    return recorder.submit();
                };
                MACULA_TRY_VOID(portions_.run(padded, kGrain, submit));
                MACULA_TRY(const auto values, gpu::read<shared::SurfaceSums>(found));
                for (std::size_t i = 0; i < std::size_t(count) * kSurfaceLanes; ++i)
                    sums[base + i / kSurfaceLanes].add(values[i]);
            }
        }
        std::vector<GatheredLight> gathered;
        double lost = 0.0;
        for (std::size_t i = 0; i < at.size(); ++i) {
            result.points.push_back(pointOf(placeOf(at[i], result.areaMm2), sums[i], result));
            gathered.push_back(sums[i].light);
            lost += sums[i].lost;
        }
        result.lostPaths = static_cast<std::uint64_t>(lost);
        shareLight(result.points, gathered);
        return {};
    }

  private:
    // With the radius as far as to its neighbours: on a surface, or in matter so thin that they lie behind
    // one another too; in no case as far as the volume is large.
    glm::vec4 placeOf(const SurfaceCandidate& at, double areaMm2) const {
        double radius = std::sqrt(areaMm2);
        if (at.density >= 0.0f)
            radius = std::clamp(std::cbrt(areaMm2 / double(at.density)), radius,
                                std::max(radius, 0.1 * scene_.volume()->worldBox().diagonal()));
        return {at.at, at.density < 0.0f ? -radius : radius};
    }

    SurfacePoint pointOf(const glm::vec4& place, const PointSums& sums, const SurfacePoints& all) const {
        SurfacePoint point{.radiusMm = std::abs(place.w)};
        // The tracer's voxel coordinates have integers at faces, those of a volume at centres.
        const glm::dvec3 at = transformPoint(scene_.volume()->worldFromVoxel(), glm::dvec3(place) - 0.5);
        point.positionMm = glm::vec3(at - all.originMm);
        point.extinctionPerMm = static_cast<float>(sums.mass / sums.taps);
        if (!(sums.mass > 0.0)) return point;
        const glm::dvec3 centre = sums.first / sums.mass;
        const glm::dvec3& d = sums.diagonal;
        const glm::dvec3& o = sums.offAxis;
        const glm::dmat3 around(d.x, o.x, o.z, o.x, d.y, o.y, o.z, o.y, d.z);
        const glm::dmat3 spread = around / sums.mass - glm::outerProduct(centre, centre);
        point.centreMm = glm::vec3(centre);
        point.spreadMm2 = glm::mat3(spread);
        return point;
    }

    std::shared_ptr<gpu::Device> device_;
    const DeviceScene& scene_;
    const gpu::Kernel& kernel_;
    Portions portions_;
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
    SurfacePoints result;
    const Volume& volume = *scene.volume();
    result.originMm = transformPoint(volume.worldFromVoxel(), 0.5 * glm::dvec3(volume.size()) - 0.5);
    MACULA_TRY(const gpu::Kernel* candidates, kernels.candidates(kind));
    MACULA_TRY(const SurfaceCandidates seen,
               findCandidates(device, scene, *candidates, double(options.count) * options.candidatesPerPoint,
                              keepGoing));
    if (seen.found.empty()) return result;
    const std::vector<SurfaceCandidate> at = chosen(seen.found, volume, options.count);
    result.areaMm2 = seen.areaMm2 / double(at.size());
    MACULA_TRY(const gpu::Kernel* points, kernels.surfacePoints(kind));
    Measurement measurement(device, scene, *points, keepGoing);
    MACULA_TRY_VOID(measurement.measure(at, options.paths, result));
    return result;
}

}  // namespace macula::trace
