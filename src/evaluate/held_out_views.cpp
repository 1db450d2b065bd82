#include "evaluate/held_out_views.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <span>

#include "base/elapsed.h"
#include "image/masked_metrics.h"
#include "pipeline/hybrid/views/drawn_views.h"
#include "pipeline/hybrid/views/training_views.h"
#include "pipeline/splat/draw/displayed.h"

namespace macula::evaluate {

namespace {

constexpr double kLeastCoverage = 0.06;

// Poses of the protocol come nearer and stray farther one by one, so a smaller number is spread over all.
Result<hybrid::ChosenPoses> chooseTruth(live::SceneOnDevice& scene, hybrid::PoseSampling poses,
                                        std::size_t count, Progress& progress) {
    poses.count = std::max(count, poses.count);
    MACULA_TRY(hybrid::ChosenPoses chosen, hybrid::choosePoses(scene.tracer, scene.traced.seenMm(), poses,
                                                               {.leastCoverage = kLeastCoverage}, progress));
    for (std::size_t i = 0; i < count; ++i) chosen.cameras[i] = chosen.cameras[i * poses.count / count];
    chosen.cameras.resize(count);
    return chosen;
}

std::vector<std::uint8_t> besideEachOther(const glm::ivec2& size, std::span<const glm::vec4> left,
                                          std::span<const glm::vec4> right) {
    std::vector<std::uint8_t> rgba;
    rgba.reserve(left.size() * 8);
    const auto a = splat::displayed(left, splat::ColourSpace::linear, {});
    const auto b = splat::displayed(right, splat::ColourSpace::linear, {});
    const auto rowBytes = 4 * static_cast<std::ptrdiff_t>(size.x);
    for (std::ptrdiff_t y = 0; y < size.y; ++y) {
        for (const auto* half : {&a, &b})
            rgba.insert(rgba.end(), half->begin() + y * rowBytes, half->begin() + (y + 1) * rowBytes);
    }
    return rgba;
}

}  // namespace

Result<HeldOutViews> HeldOutViews::trace(std::shared_ptr<gpu::Device> device, live::SceneOnDevice& scene,
                                         const hybrid::PoseSampling& poses, std::size_t count,
                                         const hybrid::TruthOptions& options,
                                         const std::filesystem::path& cache, Progress& progress) {
    HeldOutViews views(std::move(device));
    MACULA_TRY(const hybrid::ChosenPoses chosen, chooseTruth(scene, poses, count, progress));
    const auto start = std::chrono::steady_clock::now();
    MACULA_TRY(views.truth_, hybrid::truthPictures(scene.tracer, scene.traced, chosen.cameras, options,
                                                   hybrid::PictureCache(cache), progress));
    views.seconds_ = secondsSince(start);
    views.sizePx_ = options.sizePx;
    views.givenUp_ = chosen.givenUp;
    return views;
}

Result<Comparison> HeldOutViews::compare(const splat::Splats& model, Progress& progress) const {
    progress.beginStage(Text("Comparing"), truth_.size());
    MACULA_TRY(const hybrid::DrawnViews drawn, hybrid::drawViews(device_, model, cameras(), sizePx_));
    Comparison comparison{.scores = {}, .drawMs = image::percentile(drawn.milliseconds, 0.5), .pictures = {}};
    for (std::size_t i = 0; i < truth_.size(); ++i) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, Text("Stopped."), {}, {}};
        MACULA_TRY(const ViewScores scores, scoresOf(truth_[i], drawn.pictures[i]));
        comparison.scores.push_back(scores);
        comparison.pictures.push_back(besideEachOther(sizePx_, truth_[i].whole(), drawn.pictures[i]));
        progress.advance();
    }
    return comparison;
}

std::vector<Camera> HeldOutViews::cameras() const {
    std::vector<Camera> cameras;
    std::transform(truth_.begin(), truth_.end(), std::back_inserter(cameras),
                   [](const hybrid::TruthPicture& picture) { return picture.camera(); });
    return cameras;
}

std::size_t HeldOutViews::fromCache() const {
    return static_cast<std::size_t>(
        std::count_if(truth_.begin(), truth_.end(), [](const auto& picture) { return picture.fromCache; }));
}

}  // namespace macula::evaluate
