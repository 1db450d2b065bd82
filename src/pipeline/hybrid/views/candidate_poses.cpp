#include "pipeline/hybrid/views/candidate_poses.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

#include "pipeline/hybrid/views/drawn_views.h"
#include "pipeline/hybrid/views/pose_sampling.h"

namespace macula::hybrid {

namespace {

// The sampling of candidates. The more views are known, the nearer and farther off the centre candidates are,
// as in training and refinement (pose_sampling.h).
PoseSampling candidatesBeside(std::size_t known, std::uint64_t seed, const CandidateOptions& options) {
    constexpr double kEach = 0.04;
    const double grown = kEach * double(known);
    const double reach = std::min(grown, 2.0);
    return {.count = options.candidates,
            .startDistance = std::max(5.5 - grown, 4.0),
            .increment = reach / double(std::max<std::size_t>(options.candidates, 1)),
            .mostVariability = reach,
            .seed = seed,
            .verticalFovDeg = options.verticalFovDeg};
}

bool isIn(const splat::RasterView& view, const glm::dvec3& placeMm) {
    const glm::dvec3 seen = view.cameraFromWorld * (placeMm - view.eyeMm);
    if (!(seen.z > view.nearMm)) return false;
    const glm::dvec2 pixel = view.focalPx * glm::dvec2(seen) / seen.z + view.principalPx;
    return pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x <= view.sizePx.x && pixel.y <= view.sizePx.y;
}

double angleAt(const glm::dvec3& place, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 toA = a - place;
    const glm::dvec3 toB = b - place;
    return std::atan2(glm::length(glm::cross(toA, toB)), glm::dot(toA, toB));
}

// How new a candidate is compared with a known view, in steps of newAngleDeg.
double newnessBeside(const splat::RasterView& candidate, const glm::dvec3& target,
                     const splat::RasterView& known, const CandidateOptions& options) {
    const double step = glm::radians(options.newAngleDeg);
    if (!isIn(known, target)) return glm::radians(180.0) / step;
    const double finer = std::log2(candidate.focalPx.y / glm::distance(candidate.eyeMm, target)) -
                         std::log2(known.focalPx.y / glm::distance(known.eyeMm, target));
    return angleAt(target, candidate.eyeMm, known.eyeMm) / step + std::max(finer, 0.0);
}

double expectedError(const splat::RasterView& candidate, const glm::dvec3& target,
                     std::span<const KnownPose> known, const CandidateOptions& options) {
    double newness = 180.0 / options.newAngleDeg;
    double errors = 0.0;
    double weights = 0.0;
    for (const KnownPose& view : known) {
        const double beside = newnessBeside(candidate, target, view.view, options);
        newness = std::min(newness, beside);
        if (!(view.error > 0.0)) continue;
        const double weight = 1.0 / (1.0 + beside * beside);
        errors += weight * view.error;
        weights += weight;
    }
    return (weights > 0.0 ? errors / weights : 1.0) * (1.0 + newness);
}

}  // namespace

Result<std::vector<CandidatePose>> candidatePoses(std::span<const KnownPose> known, const Box& seenMm,
                                                  const glm::dvec3& originMm, std::uint64_t seed,
                                                  const CandidateOptions& options) {
    MACULA_TRY(const auto candidates, samplePoses(seenMm, candidatesBeside(known.size(), seed, options)));
    const double radiusMm = 0.5 * seenMm.diagonal();
    std::vector<CandidatePose> wanted;
    for (const SampledPose& sampled : candidates) {
        if (!sampled.accepted) continue;
        MACULA_TRY(const splat::RasterView view, splat::rasterView(sampled.camera, options.sizePx, originMm));
        if (std::any_of(known.begin(), known.end(), [&](const KnownPose& k) {
                return isSamePose(k.view, view, radiusMm, options.admission);
            }))
            continue;
        const glm::dvec3 target = sampled.camera.targetMm - originMm;
        wanted.push_back(
            {.camera = sampled.camera, .expectedError = expectedError(view, target, known, options)});
    }
    std::stable_sort(wanted.begin(), wanted.end(), [](const CandidatePose& a, const CandidatePose& b) {
        return a.expectedError > b.expectedError;
    });
    return wanted;
}

namespace {

constexpr std::size_t kLooks = 8;  // candidates drawn at a time after the first
constexpr int kLookSidePx = 32;
constexpr double kLeastCoverage = 0.04;  // as PoseLimits

}  // namespace

Result<std::optional<CandidatePose>> firstThatShows(const std::shared_ptr<gpu::Device>& device,
                                                    const splat::Splats& model,
                                                    std::span<const CandidatePose> wanted,
                                                    const glm::ivec2& sizePx) {
    using Chosen = std::optional<CandidatePose>;
    const glm::dvec2 size(sizePx);
    const glm::ivec2 small = glm::max(glm::ivec2(size * (kLookSidePx / std::max(size.x, size.y))), 1);
    // The best candidates look at places that no view has seen yet, where there may be nothing: then the next
    // ones are tried.
    const CandidatePose* fullest = nullptr;
    double most = 0.0;
    std::size_t count = 1;  // usually the best one shows enough
    for (std::size_t first = 0; first < wanted.size(); first += std::exchange(count, kLooks)) {
        const std::span looks = wanted.subspan(first, std::min(count, wanted.size() - first));
        std::vector<Camera> cameras;
        std::transform(looks.begin(), looks.end(), std::back_inserter(cameras),
                       [](const CandidatePose& view) { return view.camera; });
        MACULA_TRY(const DrawnViews drawn, drawViews(device, model, cameras, small));
        for (std::size_t i = 0; i < looks.size(); ++i) {
            const double sum = std::accumulate(drawn.pictures[i].begin(), drawn.pictures[i].end(), 0.0,
                                               [](double s, const glm::vec4& p) { return s + double(p.a); });
            if (model.size() == 0 || sum >= kLeastCoverage * double(drawn.pictures[i].size()))
                return Chosen(looks[i]);
            if (sum > most) {
                most = sum;
                fullest = &looks[i];
            }
        }
    }
    // A vessel or a nodule covers little of any view, so the fullest one has to do.
    return fullest != nullptr ? Chosen(*fullest) : Chosen();
}

}  // namespace macula::hybrid
