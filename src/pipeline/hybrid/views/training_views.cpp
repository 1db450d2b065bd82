#include "pipeline/hybrid/views/training_views.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace macula::hybrid {

namespace {

constexpr double kNearestRadii = 0.5;  // nearer views no longer show the centre
constexpr double kMostByArea = 4.0;    // cap, reached at 6 radii: pictures from farther away show less detail

glm::dvec3 forwardOf(const splat::RasterView& view) {
    return glm::transpose(view.cameraFromWorld)[2];
}

Result<splat::TrainingView> weighedByArea(const splat::Trainer& trainer, const Box& seenMm, TracedView view) {
    const glm::dvec3 originMm = trainer.lastGood().splats.originMm;
    if (isParallel(view.camera))
        return Error{
            ErrorCode::usage, Text("Splats learn from what an eye sees, not from parallel rays."), {}, {}};
    MACULA_TRY(const splat::RasterView from, splat::rasterView(view.camera, view.sizePx, originMm));
    return splat::TrainingView{
        .view = from, .pixels = std::move(view.rgba), .weight = weightByArea(from, seenMm, originMm)};
}

}  // namespace

Result<ChosenPoses> choosePoses(trace::PathTracer& tracer, const Box& seenMm, const PoseSampling& sampling,
                                const PoseLimits& limits, const Progress& progress) {
    const double radiusMm = 0.5 * seenMm.diagonal();
    MACULA_TRY(const auto views,
               samplePoses(seenMm, sampling, showsEnough(tracer, radiusMm, limits, progress)));
    ChosenPoses chosen;
    for (const SampledPose& view : views) {
        chosen.cameras.push_back(view.camera);
        if (!view.accepted) ++chosen.givenUp;
    }
    return chosen;
}

float weightBySamples(double samplesPerPixel) {
    constexpr double kUsual = 8.0;
    return static_cast<float>(2.0 * samplesPerPixel / (samplesPerPixel + kUsual));
}

float weightByArea(const splat::RasterView& from, const Box& seenMm, const glm::dvec3& originMm) {
    const double radiusMm = 0.5 * seenMm.diagonal();
    if (!(radiusMm > 0.0) || !std::isfinite(radiusMm)) return 1.0f;
    const auto areaOf = [](const glm::dvec2& sideAt1, double distance) {
        return sideAt1.x * sideAt1.y * distance * distance;
    };
    const double radii = glm::distance(from.eyeMm, seenMm.centre() - originMm) / radiusMm;
    const double area = areaOf(glm::dvec2(from.sizePx) / from.focalPx, std::max(radii, kNearestRadii));
    const PoseSampling usual = groundTruth(1);
    const glm::dvec2 usualSideAt1(2.0 * std::tan(glm::radians(0.5 * usual.verticalFovDeg)));
    return static_cast<float>(std::min(area / areaOf(usualSideAt1, usual.startDistance), kMostByArea));
}

Result<splat::TrainingView> trainingView(const splat::Trainer& trainer, const Box& seenMm, TracedView view) {
    const float bySamples = view.isLit ? 1.0f : weightBySamples(view.samplesPerPixel);
    MACULA_TRY(splat::TrainingView picture, weighedByArea(trainer, seenMm, std::move(view)));
    picture.weight *= bySamples;
    return picture;
}

Result<splat::TrainingView> coverageTrainingView(const splat::Trainer& trainer, const Box& seenMm,
                                                 TracedView view) {
    MACULA_TRY(splat::TrainingView outline, weighedByArea(trainer, seenMm, std::move(view)));
    outline.kind = splat::ViewKind::outline;
    return outline;
}

Result<void> learnStandInFrom(splat::Trainer& trainer, const Box& seenMm, TracedView view) {
    MACULA_TRY(splat::TrainingView standIn, trainingView(trainer, seenMm, std::move(view)));
    standIn.kind = splat::ViewKind::standIn;
    return trainer.addView(std::move(standIn));
}

Result<void> learnFrom(splat::Trainer& trainer, const Box& seenMm, TracedView view) {
    MACULA_TRY(splat::TrainingView picture, trainingView(trainer, seenMm, std::move(view)));
    return trainer.addView(std::move(picture));
}

Result<void> learnCoverageFrom(splat::Trainer& trainer, const Box& seenMm, TracedView view) {
    MACULA_TRY(splat::TrainingView outline, coverageTrainingView(trainer, seenMm, std::move(view)));
    return trainer.addView(std::move(outline));
}

bool isSamePose(const splat::RasterView& a, const splat::RasterView& b, double radiusMm,
                const AdmissionOptions& options) {
    const double leastCosine = std::cos(glm::radians(options.newAngleDeg));
    return glm::distance(a.eyeMm, b.eyeMm) <= options.newDistanceRadii * radiusMm &&
           glm::dot(forwardOf(a), forwardOf(b)) >= leastCosine;
}

Result<Novelty> admit(splat::Trainer& trainer, splat::TrainingView picture, double radiusMm,
                      const AdmissionOptions& options) {
    std::vector<std::size_t> known;  // views from the same pose
    for (std::size_t i = 0; i < trainer.viewCount(); ++i) {
        if (trainer.view(i).kind != splat::ViewKind::picture) continue;  // it has no traced picture
        if (!isSamePose(picture.view, trainer.view(i).view, radiusMm, options)) continue;
        if (!trainer.wasDrawn(i)) return Novelty::none;
        known.push_back(i);
    }
    // Compares only with pictures from the same pose: near views have larger differences than far ones.
    double most = 0.0;
    for (const std::size_t i : known) {
        MACULA_TRY(const double difference, trainer.differenceTo(trainer.view(i)));
        most = std::max(most, difference);
    }
    if (!known.empty()) {
        MACULA_TRY(const double difference, trainer.differenceTo(picture));
        if (!(difference > options.newDifference * most)) return Novelty::none;
    }
    MACULA_TRY_VOID(trainer.addView(std::move(picture)));
    return known.empty() ? Novelty::pose : Novelty::picture;
}

void AskedViews::add(const Camera& camera) {
    constexpr std::size_t kMostAsked = 8;
    cameras_.push_back(camera);
    if (cameras_.size() > kMostAsked) cameras_.erase(cameras_.begin());
}

void AskedViews::came(const splat::RasterView& from, const glm::dvec3& originMm, double radiusMm,
                      const AdmissionOptions& options) {
    std::erase_if(cameras_, [&](const Camera& camera) {
        const auto asked = splat::rasterView(camera, sizePx_, originMm);
        return asked && isSamePose(*asked, from, radiusMm, options);
    });
}

std::vector<splat::RasterView> AskedViews::views(const glm::dvec3& originMm) const {
    std::vector<splat::RasterView> views;
    for (const Camera& camera : cameras_) {
        if (const auto view = splat::rasterView(camera, sizePx_, originMm)) views.push_back(*view);
    }
    return views;
}

namespace {

// Bytes on the device for a pixel of a view, with its smaller copies: a third more than LossTarget takes.
constexpr double kBytesOfPixel = 27.0;

}  // namespace

double bytesOfViews(const splat::Trainer& trainer) {
    double bytes = 0.0;
    for (std::size_t i = 0; i < trainer.viewCount(); ++i)
        bytes += kBytesOfPixel * double(trainer.view(i).pixels.size());
    return bytes;
}

double meanPixelsOfViews(const splat::Trainer& trainer) {
    double pixels = 0.0;
    for (std::size_t i = 0; i < trainer.viewCount(); ++i) pixels += double(trainer.view(i).pixels.size());
    return pixels / double(std::max<std::size_t>(trainer.viewCount(), 1));
}

std::optional<std::size_t> pictureOf(const splat::Trainer& trainer, const splat::RasterView& view) {
    for (std::size_t i = 0; i < trainer.viewCount(); ++i)
        if (trainer.view(i).kind == splat::ViewKind::picture && trainer.view(i).view == view) return i;
    return std::nullopt;
}

bool hasPictureFrom(const splat::Trainer& trainer, const splat::RasterView& view, double radiusMm,
                    const AdmissionOptions& options) {
    for (std::size_t i = 0; i < trainer.viewCount(); ++i)
        if (trainer.view(i).kind == splat::ViewKind::picture &&
            isSamePose(view, trainer.view(i).view, radiusMm, options))
            return true;
    return false;
}

}  // namespace macula::hybrid
