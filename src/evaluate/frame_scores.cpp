#include "evaluate/frame_scores.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "evaluate/shown_picture.h"
#include "image/edges.h"
#include "image/frame_metrics.h"
#include "image/metrics.h"
#include "pipeline/splat/draw/displayed.h"

namespace macula::evaluate {

namespace {

Result<RegionScores> scoresIn(const FrameTruth& truth, const image::Image& shown,
                              const image::Mask& covered) {
    RegionScores scores;
    MACULA_TRY(scores.maskedPsnrDb, image::maskedPsnr(truth.shown, shown, covered));
    if (scores.maskedPsnrDb && !std::isfinite(*scores.maskedPsnrDb)) scores.maskedPsnrDb.reset();
    MACULA_TRY(scores.maskedSsim, image::maskedSsim(truth.shown, shown, covered));
    return scores;
}

}  // namespace

FrameTruth frameTruthOf(const hybrid::TruthPicture& picture) {
    const std::vector<glm::vec4> light = picture.whole();
    std::vector<float> coverage;
    coverage.reserve(light.size());
    for (const glm::vec4& pixel : light) coverage.push_back(pixel.a);
    FrameTruth truth{
        .camera = picture.camera(),
        .shown = imageOf(splat::displayed(light, splat::ColourSpace::linear, {}), picture.sizePx()),
        .covered = image::coveredMask(coverage),
        .middle = image::foveaMask({.sizePx = picture.sizePx(),
                                    .verticalFovDeg = picture.camera().verticalFovDeg,
                                    .fieldDeg = trace::kFovealFieldDeg})
                      .value(),
        .coveredInMiddle = {},
        .silhouetteInMiddle = image::silhouetteMask(coverage, picture.sizePx().x, picture.sizePx().y)};
    truth.coveredInMiddle = truth.middle;
    for (std::size_t i = 0; i < truth.covered.size(); ++i) {
        if (truth.covered[i] == 0) truth.coveredInMiddle[i] = 0;
        if (truth.middle[i] == 0) truth.silhouetteInMiddle[i] = 0;
    }
    return truth;
}

Result<FrameScores> frameScoresOf(const FrameTruth& truth, const image::Image& shown) {
    FrameScores scores;
    MACULA_TRY(scores.full, scoresIn(truth, shown, truth.covered));
    MACULA_TRY(scores.fovea, scoresIn(truth, shown, truth.coveredInMiddle));
    MACULA_TRY(const image::Flip flip, image::flip(truth.shown, shown));
    scores.full.flip = flip.mean;
    MACULA_TRY(scores.fovea.flip, image::meanOf(flip.perPixel, truth.middle));
    if (std::min(shown.width, shown.height) >= image::kMsSsimLeastPx) {
        MACULA_TRY(scores.msSsim, image::msSsim(truth.shown, shown));
    }
    return scores;
}

std::vector<std::optional<double>> gainsDb(std::span<const FrameScores> ours,
                                           std::span<const FrameScores> theirs,
                                           RegionScores FrameScores::*region) {
    MACULA_CHECK_EQ(ours.size(), theirs.size());
    std::vector<std::optional<double>> gains(ours.size());
    for (std::size_t i = 0; i < ours.size(); ++i) {
        const std::optional<double>& a = (ours[i].*region).maskedPsnrDb;
        const std::optional<double>& b = (theirs[i].*region).maskedPsnrDb;
        if (a && b) gains[i] = *a - *b;
    }
    return gains;
}

}  // namespace macula::evaluate
