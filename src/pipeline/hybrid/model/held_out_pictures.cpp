#include "pipeline/hybrid/model/held_out_pictures.h"

#include <algorithm>
#include <cmath>

#include "pipeline/hybrid/model/model_start.h"
#include "pipeline/hybrid/views/held_out.h"
#include "pipeline/splat/train/reference_loss.h"

namespace macula::hybrid {

namespace {

constexpr double kLeastShare = 0.02;

// The lines of the picture that the window traces in motion without a model, on two cores.
constexpr int kCoarseLines = 42;
constexpr int kCoarserThanPicture = 3;  // at least by this factor

// Compares with a copy of the shown splats that is on the device only for this: pictures are held out rarely,
// and a permanent copy would take memory from the model that learns.
Result<void> judgeShown(std::span<HeldOutPicture> held, const std::shared_ptr<gpu::Device>& device,
                        const glm::dvec3& originMm, splat::TrainerOptions options,
                        const ShownOfModel& shown) {
    if (held.empty()) return {};
    options.capacity = 0;  // 0: just room for the splats
    const auto compare = [&](const splat::Splats& splats, double HeldOutErrors::*error) -> Result<void> {
        const splat::Splats here = relativeTo(splats, originMm);
        MACULA_TRY(splat::Trainer judge, splat::Trainer::create(device, here, options));
        for (HeldOutPicture& h : held) {
            MACULA_TRY(const double difference, judge.differenceTo(*h.picture));
            h.errors.*error = difference / h.coverage;
        }
        return {};
    };
    MACULA_TRY_VOID(compare(shown.now, &HeldOutErrors::shown));
    if (&shown.best != &shown.now) return compare(shown.best, &HeldOutErrors::best);
    for (HeldOutPicture& h : held) h.errors.best = h.errors.shown;
    return {};
}

}  // namespace

double judgedCoverage(const splat::TrainingView& view) {
    return std::max(meanCoverage(view), kLeastShare);
}

bool HeldOutPictures::canJudge() const {
    return held_.size() >= kLeastHeldOut;
}

Result<void> HeldOutPictures::take(std::span<const std::shared_ptr<const splat::TrainingView>> pictures,
                                   splat::Trainer& trainer, const std::shared_ptr<gpu::Device>& device,
                                   const splat::TrainerOptions& options, const ShownOfModel& shown) {
    std::vector<HeldOutPicture> taken;
    for (const auto& picture : pictures) {
        HeldOutPicture& h = taken.emplace_back();
        h.picture = picture;
        h.coverage = judgedCoverage(*picture);
        MACULA_TRY(const double error, trainer.differenceTo(*picture));
        h.errors.trained = error / h.coverage;
        const int lines = std::min(kCoarseLines, picture->view.sizePx.y / kCoarserThanPicture);
        h.errors.coarse = coarseDifference(*picture, std::max(lines, 1), options.loss) / h.coverage;
    }
    MACULA_TRY_VOID(judgeShown(taken, device, trainer.lastGood().splats.originMm, options, shown));
    held_.insert(held_.end(), taken.begin(), taken.end());
    return {};
}

Result<void> HeldOutPictures::judgeNext(splat::Trainer& trainer) {
    HeldOutPicture& h = held_[judged_++];
    MACULA_TRY(const double difference, trainer.differenceTo(*h.picture));
    h.errors.trained = difference / h.coverage;
    return {};
}

void HeldOutPictures::judgedIsShown(bool isBest) {
    for (HeldOutPicture& h : held_) {
        h.errors.shown = h.errors.trained;
        if (isBest) h.errors.best = h.errors.trained;
    }
}

HeldOutErrors HeldOutPictures::meanErrors() const {
    HeldOutErrors mean;
    for (const HeldOutPicture& h : held_) {
        mean.trained += h.errors.trained / double(held_.size());
        mean.shown += h.errors.shown / double(held_.size());
        mean.best += h.errors.best / double(held_.size());
        mean.coarse += h.errors.coarse / double(held_.size());
    }
    return mean;
}

double HeldOutPictures::pixels() const {
    double pixels = 0.0;
    for (const HeldOutPicture& h : held_) pixels += double(h.picture->pixels.size());
    return pixels;
}

double HeldOutPictures::degreesBeside(const splat::RasterView& view, const glm::dvec3& centre) const {
    double least = 180.0;
    for (const HeldOutPicture& h : held_) {
        const glm::dvec3 a = view.eyeMm - centre;
        const glm::dvec3 b = h.picture->view.eyeMm - centre;
        least = std::min(least, glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b))));
    }
    return least;
}

bool HeldOutPictures::hasFrom(const splat::RasterView& view, double radiusMm,
                              const AdmissionOptions& options) const {
    return std::any_of(held_.begin(), held_.end(), [&](const HeldOutPicture& h) {
        return isSamePose(view, h.picture->view, radiusMm, options);
    });
}

splat::TrainingView coarselyShown(const splat::TrainingView& view, int lines) {
    const glm::ivec2 size = view.view.sizePx;
    const double step = double(size.y) / double(lines);
    splat::TrainingView shown = view;
    if (!(step > 1.0)) return shown;
    const glm::ivec2 coarse = glm::max(glm::ivec2(glm::round(glm::dvec2(size) / step)), 1);
    const glm::dvec2 pixelsOfCoarse = glm::dvec2(size) / glm::dvec2(coarse);
    const auto coarseAt = [&](const glm::ivec2& at) {
        const glm::ivec2 pixel(glm::dvec2(glm::clamp(at, glm::ivec2(0), coarse - 1)) * pixelsOfCoarse +
                               0.5 * pixelsOfCoarse);
        return view.pixels[std::size_t(pixel.y) * std::size_t(size.x) + std::size_t(pixel.x)];
    };
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const glm::dvec2 at = (glm::dvec2(x, y) + 0.5) / pixelsOfCoarse - 0.5;
            const glm::ivec2 low(glm::floor(at));
            const glm::vec2 t(at - glm::dvec2(low));
            const glm::vec4 above = glm::mix(coarseAt(low), coarseAt(low + glm::ivec2(1, 0)), t.x);
            const glm::vec4 below =
                glm::mix(coarseAt(low + glm::ivec2(0, 1)), coarseAt(low + glm::ivec2(1, 1)), t.x);
            shown.pixels[std::size_t(y) * std::size_t(size.x) + std::size_t(x)] = glm::mix(above, below, t.y);
        }
    }
    return shown;
}

double coarseDifference(const splat::TrainingView& view, int lines, const splat::LossOptions& loss) {
    const splat::TrainingView shown = coarselyShown(view, lines);
    double sum = 0.0;
    for (std::size_t i = 0; i < view.pixels.size(); ++i) {
        const glm::dvec4 target(view.pixels[i]);
        const glm::dvec4 coarse(shown.pixels[i]);
        if (glm::any(glm::isnan(target) || glm::isinf(target))) continue;
        if (glm::any(glm::isnan(coarse) || glm::isinf(coarse))) continue;
        const glm::dvec4 difference = glm::abs(splat::referenceCompared(coarse, loss, glm::dvec3(0.0)) -
                                               splat::referenceCompared(target, loss, glm::dvec3(0.0)));
        const bool isOutline = view.kind == splat::ViewKind::outline;
        sum += isOutline ? difference.w : glm::dot(difference, glm::dvec4(1.0));
    }
    return sum / (4.0 * double(std::max<std::size_t>(view.pixels.size(), 1)));
}

}  // namespace macula::hybrid
