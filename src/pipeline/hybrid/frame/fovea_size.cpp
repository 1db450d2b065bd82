#include "pipeline/hybrid/frame/fovea_size.h"

#include <algorithm>
#include <cmath>

namespace macula::hybrid {

namespace {

constexpr double kFieldBeforeCoarser = 0.6;
constexpr double kCoarsest = 0.5;
constexpr double kLeastField = 0.1;
constexpr double kLeastFieldDeg = 0.1;  // smallest field of a camera

double halfTangent(double fieldDeg) {
    return std::tan(0.5 * glm::radians(fieldDeg));
}

}  // namespace

double guessedFoveaMsPerSample(const gpu::Device& device) {
    return device.isCpu() ? 1e-2 : 5e-5;
}

FoveaAim affordableFovea(const trace::View& whole, const glm::dvec2& gaze, double msPerSample,
                         double budgetMs, const FoveaOptions& request) {
    const double halfOfFrame = halfTangent(whole.camera.verticalFovDeg);
    const double pixelsPerTangent = 0.5 * double(whole.height) / halfOfFrame;
    const double aspect = double(whole.width) / double(whole.height);
    const double half = std::min(halfTangent(request.fieldDeg), halfOfFrame * std::max(aspect, 1.0));
    const double wantedPx = std::max(2.0 * half * pixelsPerTangent, 1.0);
    // The share of the wanted side, in steps: a picture as large as the last one reuses its memory, and the
    // denoiser can use the samples of both.
    constexpr double kLeastShare = kLeastField * kCoarsest;
    const double affordable = std::clamp(
        std::sqrt(budgetMs / (msPerSample * request.samplesPerPixel)) / wantedPx, kLeastShare, 1.0);
    const double share = kLeastShare * std::floor(affordable / kLeastShare + 1e-6);
    const double fineness = std::clamp(share / kFieldBeforeCoarser, kCoarsest, 1.0);
    const double field = std::min(share / fineness, 1.0);
    return {.whole = whole,
            .gaze = gaze,
            .fieldDeg = std::max(glm::degrees(2.0 * std::atan(field * half)), kLeastFieldDeg),
            .sidePx = std::max(static_cast<int>(std::lround(wantedPx * share)), 1),
            .samplesPerPixel = request.samplesPerPixel,
            .denoising = request.denoising};
}

}  // namespace macula::hybrid
