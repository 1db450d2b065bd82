// The table of macula-bench evaluate.
#include <algorithm>
#include <cmath>
#include <functional>

#include "evaluate/evaluation_report.h"

namespace macula::evaluate {

namespace {

// "20.51 [18.20 20.40 22.90]": mean, and p10, p50, p90.
std::string cell(const std::optional<Spread>& spread, int decimals) {
    if (!spread) return "nothing to compare";
    return fmt::format("{:.{}f} [{:.{}f} {:.{}f} {:.{}f}]", spread->mean, decimals, spread->p10, decimals,
                       spread->p50, decimals, spread->p90, decimals);
}

using SpreadOf = std::function<std::optional<Spread>(std::optional<double> ViewScores::*)>;

std::string rowOf(const std::string& name, const std::string& splats, const std::string& seconds,
                  const SpreadOf& spread) {
    return fmt::format(
        "{:<32} {:>7} {:>7}  {:<27} {:<27} {:<27} {:<27} {:<27} {:<27} {:<27}\n", name, splats, seconds,
        cell(spread(&ViewScores::psnrDb), 2), cell(spread(&ViewScores::maskedPsnrDb), 2),
        cell(spread(&ViewScores::maskedPsnrLessNoiseDb), 2), cell(spread(&ViewScores::maskedSsim), 3),
        cell(spread(&ViewScores::flip), 3), cell(spread(&ViewScores::luminanceRatio), 3),
        cell(spread(&ViewScores::coverageError), 3));
}

// The first line of a table.
std::string headOf(const std::string& first) {
    return fmt::format("{:<32} {:>7} {:>7}  {:<27} {:<27} {:<27} {:<27} {:<27} {:<27} {:<27}\n", first,
                       "splats", "s", "PSNR dB", "masked PSNR dB", "less noise, dB", "masked SSIM", "FLIP",
                       "light / truth", "coverage error");
}

std::string nameOf(const EvaluatedStudy& scene) {
    return fmt::format("{:.8} {}", scene.studyDigest, scene.preset);
}

std::string whatWasAsked(const EvaluationOptions& o) {
    const hybrid::FirstModelOptions& m = o.model;
    std::string text =
        fmt::format("Truth: {} views of {} x {} pixels, {} samples, {} bounces. Model: ", o.truthViews,
                    o.truth.sizePx.x, o.truth.sizePx.y, o.truth.samplesPerPixel, o.truth.bounces);
    text +=
        o.live ? fmt::format("as the window's, for {} s at most.", o.live->seconds)
               : fmt::format("{} points, {} views of {} samples, {} other sides lit by these, {} iterations.",
                             m.points.count, m.views, m.samplesPerPixel,
                             m.directions - std::min(m.directions, m.views), m.iterations);
    if (o.refinement)
        text += fmt::format(" Then {} views of {} samples more, {} iterations, room for {} splats.",
                            o.refinement->views, o.refinement->samplesPerPixel, o.refinement->iterations,
                            o.refinement->capacity);
    const EvaluationOptions protocol;
    if (o.truthViews < protocol.truthViews || o.truth.samplesPerPixel < protocol.truth.samplesPerPixel)
        text += fmt::format("\nThe protocol has a truth of {} views of {} samples.", protocol.truthViews,
                            protocol.truth.samplesPerPixel);
    return text + "\nOf each number the mean over views, and [p10 p50 p90].\n\n";
}

// The seconds are training time.
std::string snapshotsOf(const EvaluatedStudy& scene) {
    std::string table = "\n" + headOf(nameOf(scene) + ", step");
    for (const Snapshot& snapshot : scene.evaluation.snapshots)
        table += rowOf(fmt::format("{}", snapshot.steps), fmt::format("{}", snapshot.splats),
                       fmt::format("{:.1f}", snapshot.trainSeconds),
                       [&](auto value) { return spreadOf(snapshot.scores, value); });
    const GreatestFall fall = greatestFall(scene.evaluation.snapshots);
    return table + fmt::format("greatest fall of masked PSNR: {:.2f} dB, of its median {:.2f} dB\n",
                               fall.meanDb, fall.medianDb);
}

// The model's error without the truth's noise, over all views together.
std::string lessNoise(const image::SquareError& error) {
    constexpr double kTellsLittleDb = 1.0;
    const auto db = image::psnrOf(error);
    const auto wrongBy = image::psnrErrorOf(error);
    if (!db || !wrongBy || *wrongBy > kTellsLittleDb)
        return "the error of the model is not seen through it: give more --truth-spp";
    return fmt::format("without it the mean square over all views is {:.2f} dB, give or take {:.2f}", *db,
                       *wrongBy);
}

std::string timesOf(const EvaluatedStudy& scene, bool refined) {
    const SceneEvaluation& e = scene.evaluation;
    std::string text = fmt::format("\n{}: points {:.2f} s, views {:.2f} s, ", nameOf(scene), e.pointsSeconds,
                                   e.viewsSeconds);
    if (refined) text += fmt::format("more views {:.2f} s, ", e.moreViewsSeconds);
    text += fmt::format("training {:.2f} s, drawing {:.0f} ms; the truth's own noise is {:.4f} ({:.1f} dB)",
                        e.last().trainSeconds, e.drawMs, e.truthNoise(),
                        -20.0 * std::log10(std::max(e.truthNoise(), 1e-6)));
    if (const auto error = squareErrorOver(e.last().scores)) text += "; " + lessNoise(*error);
    if (e.viewsFromCache > 0)
        text += fmt::format("; {} views were in the cache, and took no time", e.viewsFromCache);
    if (e.viewsGivenUp > 0) text += fmt::format("; {} views show less than was asked for", e.viewsGivenUp);
    return text + ".";
}

}  // namespace

std::string tableOf(const EvaluationReport& report) {
    const bool refined = report.options.refinement.has_value();
    const bool hasSnapshots = refined || report.options.live;
    std::string table = whatWasAsked(report.options) + headOf("scene");
    for (const EvaluatedStudy& scene : report.scenes) {
        const SceneEvaluation& e = scene.evaluation;
        const double seconds = e.pointsSeconds + e.viewsSeconds + e.moreViewsSeconds + e.last().trainSeconds;
        table += rowOf(nameOf(scene), fmt::format("{}", e.last().splats), fmt::format("{:.1f}", seconds),
                       [&](auto value) { return spreadOf(e.last().scores, value); });
    }
    if (report.scenes.size() > 1)
        table += rowOf("over scenes, of their means", "", "",
                       [&](auto value) { return spreadOverScenes(report, value); });
    if (hasSnapshots)
        for (const EvaluatedStudy& scene : report.scenes) table += snapshotsOf(scene);
    for (const EvaluatedStudy& scene : report.scenes) table += timesOf(scene, refined);
    return table + "\n";
}

}  // namespace macula::evaluate
