#include "cli/view_scores.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "image/masked_metrics.h"
#include "image/metrics.h"
#include "pipeline/splat/displayed.h"

namespace macula::cli {

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

}  // namespace

image::Image displayImage(const glm::ivec2& sizePx, std::span<const glm::vec4> rgba) {
    image::Image image{.width = sizePx.x,
                       .height = sizePx.y,
                       .channels = 3,
                       .encoding = image::Encoding::display,
                       .pixels = {}};
    const std::vector<std::uint8_t> shown = splat::displayed(rgba, splat::ColourSpace::linear, {});
    image.pixels.reserve(shown.size() / 4 * 3);
    for (std::size_t i = 0; i < shown.size(); i += 4)
        for (std::size_t c = 0; c < 3; ++c) image.pixels.push_back(static_cast<float>(shown[i + c]) / 255.0f);
    return image;
}

Result<ViewScores> scoresOf(const hybrid::TracedView& truth, double noise, std::span<const glm::vec4> model) {
    const image::Image a = displayImage(truth.sizePx, truth.rgba);
    const image::Image b = displayImage(truth.sizePx, model);
    const std::vector<float> coverageA = coverageOf(truth.rgba);
    const std::vector<float> coverageB = coverageOf(model);
    MACULA_TRY(const image::Mask lit, image::litMask(a, b));
    const image::Mask covered = image::coveredMask(coverageA);
    ViewScores scores;
    MACULA_TRY(scores.psnrDb, image::psnr(a, b));
    MACULA_TRY(scores.maskedPsnrDb, image::maskedPsnr(a, b, lit));
    MACULA_TRY(scores.coveredPsnrDb, image::maskedPsnr(a, b, covered));
    for (auto* db : {&scores.psnrDb, &scores.maskedPsnrDb, &scores.coveredPsnrDb}) *db = usableDb(*db);
    if (scores.maskedPsnrDb) scores.maskedPsnrLessNoiseDb = image::psnrLessNoise(*scores.maskedPsnrDb, noise);
    MACULA_TRY(scores.maskedSsim, image::maskedSsim(a, b, lit));
    MACULA_TRY(scores.coveredSsim, image::maskedSsim(a, b, covered));
    MACULA_TRY(const image::Flip flip, image::flip(a, b));
    scores.flip = flip.mean;
    MACULA_TRY(scores.luminanceRatio, image::luminanceRatio(a, b, lit));
    scores.coverageError =
        image::coverageError(coverageA, coverageB, image::unionOf(covered, image::coveredMask(coverageB)));
    return scores;
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

}  // namespace macula::cli
