#include "pipeline/hybrid/views/showing_pose.h"

#include <algorithm>
#include <glm/glm.hpp>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

#include "pipeline/hybrid/views/drawn_views.h"

namespace macula::hybrid {

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
