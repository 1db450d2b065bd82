#include "evaluate/view_scores.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "image/masked_metrics.h"
#include "image/metrics.h"
#include "pipeline/splat/draw/displayed.h"

namespace macula::evaluate {

namespace {

constexpr double kMostDb = 75.0;

std::vector<float> coverageOf(std::span<const glm::vec4> rgba) {
    std::vector<float> coverage(rgba.size());
    std::transform(rgba.begin(), rgba.end(), coverage.begin(),
                   [](const glm::vec4& pixel) { return pixel.a; });
    return coverage;
}

std::optional<double> usableDb(std::optional<double> db) {
    return db && *db <= kMostDb ? db : std::nullopt;
}

// Linear premultiplied RGBA as displayed: three channels, not rounded.
image::Image exactImage(const glm::ivec2& sizePx, std::span<const glm::vec4> rgba) {
    image::Image image{.width = sizePx.x,
                       .height = sizePx.y,
                       .channels = 3,
                       .encoding = image::Encoding::display,
                       .pixels = {}};
    image.pixels.reserve(3 * rgba.size());
    for (const glm::vec3& colour : splat::displayedExactly(rgba, splat::ColourSpace::linear, {}))
        image.pixels.insert(image.pixels.end(), {colour.x, colour.y, colour.z});
    return image;
}

image::Image inEightBits(image::Image image) {
    for (float& value : image.pixels) value = static_cast<float>(std::lround(value * 255.0f)) / 255.0f;
    return image;
}

}  // namespace

Result<ViewScores> scoresOf(const hybrid::TruthPicture& truth, std::span<const glm::vec4> model) {
    const glm::ivec2 size = truth.sizePx();
    const std::vector<glm::vec4> whole = truth.whole();
    const image::NoisyReference reference{.first = exactImage(size, truth.halves[0].rgba),
                                          .second = exactImage(size, truth.halves[1].rgba),
                                          .whole = exactImage(size, whole)};
    const image::Image exact = exactImage(size, model);
    const image::Image a = inEightBits(reference.whole);
    const image::Image b = inEightBits(exact);
    const std::vector<float> coverageA = coverageOf(whole);
    const std::vector<float> coverageB = coverageOf(model);
    MACULA_TRY(const image::Mask lit, image::litMask(a, b));
    const image::Mask covered = image::coveredMask(coverageA);
    ViewScores scores;
    MACULA_TRY(scores.psnrDb, image::psnr(a, b));
    MACULA_TRY(scores.maskedPsnrDb, image::maskedPsnr(a, b, lit));
    MACULA_TRY(const auto lessNoise, image::squareErrorLessNoise(reference, exact, lit));
    if (lessNoise) {
        scores.maskedMseLessNoise = lessNoise->mean;
        scores.maskedMseLessNoiseError = lessNoise->standardError;
        scores.maskedPsnrLessNoiseDb = image::psnrOf(*lessNoise);
    }
    MACULA_TRY(scores.coveredPsnrDb, image::maskedPsnr(a, b, covered));
    for (auto* db :
         {&scores.psnrDb, &scores.maskedPsnrDb, &scores.maskedPsnrLessNoiseDb, &scores.coveredPsnrDb})
        *db = usableDb(*db);
    MACULA_TRY(scores.maskedSsim, image::maskedSsim(a, b, lit));
    MACULA_TRY(scores.coveredSsim, image::maskedSsim(a, b, covered));
    MACULA_TRY(const image::Flip flip, image::flip(a, b));
    scores.flip = flip.mean;
    MACULA_TRY(scores.luminanceRatio, image::luminanceRatioLessNoise(reference, exact, lit));
    image::Mask both = lit;
    for (std::size_t i = 0; i < both.size(); ++i)
        both[i] = coverageA[i] > 0.5f && coverageB[i] > 0.5f ? 1 : 0;
    MACULA_TRY(scores.sharedLuminanceRatio, image::luminanceRatioLessNoise(reference, exact, both));
    scores.coverageError =
        image::coverageError(coverageA, coverageB, image::unionOf(covered, image::coveredMask(coverageB)));
    MACULA_TRY(scores.truthNoise, image::noiseOf(reference, covered));
    return scores;
}

std::optional<image::SquareError> squareErrorOver(std::span<const ViewScores> views) {
    image::SquareError over;
    std::size_t count = 0;
    for (const ViewScores& scores : views) {
        if (!scores.maskedMseLessNoise || !scores.maskedMseLessNoiseError) continue;
        over.mean += *scores.maskedMseLessNoise;
        over.standardError = std::hypot(over.standardError, *scores.maskedMseLessNoiseError);
        ++count;
    }
    if (count == 0) return {};
    return image::SquareError{.mean = over.mean / double(count),
                              .standardError = over.standardError / double(count)};
}

std::optional<Spread> spreadOf(std::span<const std::optional<double>> values) {
    std::vector<double> known;
    for (const std::optional<double>& value : values) {
        if (value) known.push_back(*value);
    }
    if (known.empty()) return {};
    return Spread{.count = known.size(),
                  .mean = std::accumulate(known.begin(), known.end(), 0.0) / double(known.size()),
                  .p10 = image::percentile(known, 0.1),
                  .p50 = image::percentile(known, 0.5),
                  .p90 = image::percentile(known, 0.9)};
}

std::optional<Spread> spreadOf(std::span<const ViewScores> views, std::optional<double> ViewScores::*value) {
    std::vector<std::optional<double>> values;
    std::transform(views.begin(), views.end(), std::back_inserter(values),
                   [&](const ViewScores& scores) { return scores.*value; });
    return spreadOf(values);
}

}  // namespace macula::evaluate
