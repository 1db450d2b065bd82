#include "pipeline/trace/surface_points.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/frames.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/trace/point_light.h"
#include "pipeline/trace/scene_view.h"
#include "pipeline/trace/surface_candidates.h"
#include "shared/surface_params.h"

namespace macula::trace {

namespace {

using shared::kSurfaceGroup;
using shared::kSurfaceLanes;
using shared::SurfaceCandidate;

constexpr std::uint32_t kFirstPoints = 1u << 9;    // of the first dispatch, before the device's pace is known
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

// Systematic sampling along a Morton curve: one candidate for every `step` of the summed weight, so that the
// chosen ones are as evenly spread as the weight.
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
        next += step * std::ceil((sum - next) / step);  // a candidate worth several steps is taken once
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

// Light and matter around the points that were chosen.
class Measurement {
  public:
    Measurement(std::vector<SurfaceCandidate> at, std::uint32_t paths)
        : at_(std::move(at)),
          passes_((paths - 1) / (kSurfaceLanes * shared::kSurfacePaths) + 1),
          portions_(kFirstPoints),
          sums_(at_.size()) {}

    bool isDone() const { return base_ >= at_.size(); }
    Result<void> step(const SceneView& scene, const gpu::Kernel& kernel, double areaMm2);
    void finish(const Volume& volume, SurfacePoints& result) const;

  private:
    // Points of one work group: a dispatch has whole groups, whose results beyond the last point are dropped.
    static constexpr std::uint32_t kGrain = kSurfaceGroup / kSurfaceLanes;

    std::uint32_t countNow() const {
        return std::min(kPointsAtOnce, static_cast<std::uint32_t>(at_.size()) - base_);
    }
    std::uint32_t paddedNow() const { return (countNow() + kGrain - 1) / kGrain * kGrain; }
    Result<void> beginPart(const SceneView& scene, double areaMm2);
    Result<void> endPass();

    std::vector<SurfaceCandidate> at_;
    std::uint32_t passes_;
    Portions portions_;
    std::vector<PointSums> sums_;
    std::uint32_t base_ = 0;  // first point of the part under way
    std::uint32_t pass_ = 0;  // of that part
    std::uint32_t done_ = 0;  // points of that pass
    std::optional<gpu::Buffer> places_, found_;
};

// The position of a point, with a radius that reaches its neighbours: those on a surface or, in thin matter,
// also those in depth; at most a tenth of the volume's diagonal there.
glm::vec4 placeOf(const SurfaceCandidate& at, double areaMm2, const Volume& volume) {
    double radius = std::sqrt(areaMm2);
    if (at.density >= 0.0f)
        radius = std::clamp(std::cbrt(areaMm2 / double(at.density)), radius,
                            std::max(radius, 0.1 * volume.worldBox().diagonal()));
    return {at.at, at.density < 0.0f ? -radius : radius};
}

SurfacePoint pointOf(const glm::vec4& place, const PointSums& sums, const Volume& volume,
                     const glm::dvec3& originMm) {
    SurfacePoint point{.radiusMm = std::abs(place.w)};
    // The tracer's voxel coordinates have integers at faces, those of a volume at centres.
    const glm::dvec3 at = transformPoint(volume.worldFromVoxel(), glm::dvec3(place) - 0.5);
    point.positionMm = glm::vec3(at - originMm);
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

Result<void> Measurement::beginPart(const SceneView& scene, double areaMm2) {
    const std::shared_ptr<gpu::Device>& device = scene.scene().device();
    const std::uint32_t padded = paddedNow();
    std::vector<glm::vec4> places;
    for (std::uint32_t i = 0; i < padded; ++i)
        places.push_back(placeOf(at_[base_ + std::min(i, countNow() - 1)], areaMm2, *scene.scene().volume()));
    MACULA_TRY(places_,
               gpu::Buffer::create(device, {.label = "points", .bytes = padded * sizeof(glm::vec4)}));
    MACULA_TRY_VOID(gpu::uploadTo<glm::vec4>(*places_, places));
    MACULA_TRY(found_, gpu::Buffer::create(device, {.label = "sums of points",
                                                    .bytes = std::uint64_t(padded) * kSurfaceLanes *
                                                             sizeof(shared::SurfaceSums)}));
    return {};
}

Result<void> Measurement::step(const SceneView& scene, const gpu::Kernel& kernel, double areaMm2) {
    if (!found_) MACULA_TRY_VOID(beginPart(scene, areaMm2));
    const std::shared_ptr<gpu::Device>& device = scene.scene().device();
    const auto submit = [&](std::uint32_t first, std::uint32_t now) -> Result<gpu::Ticket> {
        MACULA_TRY(auto recorder, gpu::Recorder::create(device, "surface points"));
        std::vector<gpu::Binding> bindings = scene.bindings();
        bindings.emplace_back(*places_);
        bindings.emplace_back(*found_);
        const shared::SurfacePush push{.first = first, .base = base_, .pass = pass_};
        recorder.dispatch(kernel, {now * kSurfaceLanes}, push, bindings);
        return recorder.submit();
    };
    const std::uint32_t padded = paddedNow();
    MACULA_TRY(const std::uint32_t now, portions_.next(*device, done_, padded - done_, kGrain, submit));
    done_ += now;
    return done_ < padded ? Result<void>() : endPass();
}

Result<void> Measurement::endPass() {
    MACULA_TRY(const auto values, gpu::read<shared::SurfaceSums>(*found_));
    for (std::size_t i = 0; i < std::size_t(countNow()) * kSurfaceLanes; ++i)
        sums_[base_ + i / kSurfaceLanes].add(values[i]);
    done_ = 0;
    if (++pass_ < passes_) return {};
    pass_ = 0;
    base_ += countNow();
    places_.reset();
    found_.reset();
    return {};
}

void Measurement::finish(const Volume& volume, SurfacePoints& result) const {
    std::vector<GatheredLight> gathered;
    double lost = 0.0;
    for (std::size_t i = 0; i < at_.size(); ++i) {
        const glm::vec4 place = placeOf(at_[i], result.areaMm2, volume);
        result.points.push_back(pointOf(place, sums_[i], volume, result.originMm));
        gathered.push_back(sums_[i].light);
        lost += sums_[i].lost;
    }
    result.lostPaths = static_cast<std::uint64_t>(lost);
    shareLight(result.points, gathered);
}

}  // namespace

struct SurfacePointSearch::Impl {
    SurfacePointOptions options;
    std::shared_ptr<const Volume> volume;
    CandidateSearch candidates;
    std::optional<Measurement> measurement = {};
    SurfacePoints result = {};
    bool isDone = false;

    void choose();
};

SurfacePointSearch::SurfacePointSearch(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SurfacePointSearch::SurfacePointSearch(SurfacePointSearch&&) noexcept = default;
SurfacePointSearch& SurfacePointSearch::operator=(SurfacePointSearch&&) noexcept = default;
SurfacePointSearch::~SurfacePointSearch() = default;

Result<SurfacePointSearch> SurfacePointSearch::begin(const SceneView& scene,
                                                     const SurfacePointOptions& options) {
    if (options.count < 1 || options.count > kMaxSurfacePoints || options.paths < 1 ||
        options.candidatesPerPoint < 1) {
        return Error{ErrorCode::usage,
                     Text("This number of points on the surface makes no sense."),
                     {},
                     Text("Ask for 1 to {} points, with 1 path or more.", kMaxSurfacePoints)};
    }
    MACULA_TRY(CandidateSearch candidates,
               CandidateSearch::begin(scene, double(options.count) * options.candidatesPerPoint));
    auto impl = std::make_unique<Impl>(
        Impl{.options = options, .volume = scene.scene().volume(), .candidates = std::move(candidates)});
    const Volume& volume = *impl->volume;
    impl->result.originMm = transformPoint(volume.worldFromVoxel(), 0.5 * glm::dvec3(volume.size()) - 0.5);
    if (impl->candidates.isDone()) impl->choose();
    return SurfacePointSearch(std::move(impl));
}

void SurfacePointSearch::Impl::choose() {
    const SurfaceCandidates seen = candidates.take();
    isDone = seen.found.empty();
    if (isDone) return;
    std::vector<SurfaceCandidate> at = chosen(seen.found, *volume, options.count);
    result.areaMm2 = seen.areaMm2 / double(at.size());
    measurement.emplace(std::move(at), options.paths);
}

bool SurfacePointSearch::isDone() const {
    return impl_->isDone;
}

Result<void> SurfacePointSearch::step(const SceneView& scene, TraceKernels& kernels, SceneKind kind) {
    Impl& s = *impl_;
    MACULA_CHECK(!s.isDone);
    if (!s.measurement) {
        MACULA_TRY(const gpu::Kernel* kernel, kernels.candidates(kind));
        MACULA_TRY_VOID(s.candidates.step(scene, *kernel));
        if (s.candidates.isDone()) s.choose();
        return {};
    }
    MACULA_TRY(const gpu::Kernel* kernel, kernels.surfacePoints(kind));
    MACULA_TRY_VOID(s.measurement->step(scene, *kernel, s.result.areaMm2));
    if (!s.measurement->isDone()) return {};
    s.measurement->finish(*s.volume, s.result);
    s.isDone = true;
    return {};
}

SurfacePoints SurfacePointSearch::take() {
    MACULA_CHECK(impl_->isDone);
    return std::move(impl_->result);
}

}  // namespace macula::trace
