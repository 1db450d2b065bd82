#include "cli/evaluation_report.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>

namespace macula::cli {

namespace {

using Json = nlohmann::ordered_json;
using Values = std::vector<std::optional<double>>;

Json toJson(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

Json toJson(const std::optional<Spread>& spread) {
    if (!spread) return {};
    return {{"count", spread->count},
            {"mean", spread->mean},
            {"p10", spread->p10},
            {"p50", spread->p50},
            {"p90", spread->p90}};
}

Values valuesOf(const SceneEvaluation& evaluation, std::optional<double> ViewScores::*value) {
    Values values;
    std::transform(evaluation.scores.begin(), evaluation.scores.end(), std::back_inserter(values),
                   [&](const ViewScores& scores) { return scores.*value; });
    return values;
}

// Over scenes, of each the mean over its views, as the protocol has it.
Values meansOf(const EvaluationReport& report, std::optional<double> ViewScores::*value) {
    Values means;
    for (const EvaluatedStudy& scene : report.scenes) {
        const auto spread = spreadOf(valuesOf(scene.evaluation, value));
        means.push_back(spread ? std::optional(spread->mean) : std::nullopt);
    }
    return means;
}

Json toJson(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

Json toJson(const EvaluatedStudy& scene) {
    const SceneEvaluation& e = scene.evaluation;
    Json json{{"study", scene.studyDigest},
              {"preset", scene.preset},
              {"voxels", {scene.voxels.x, scene.voxels.y, scene.voxels.z}},
              {"tableRemoved", scene.tableRemoved},
              {"seenMm", {{"low", toJson(e.seenMm.low)}, {"high", toJson(e.seenMm.high)}}},
              {"splats", e.splats},
              {"seconds",
               {{"points", e.pointsSeconds},
                {"views", e.viewsSeconds},
                {"train", e.trainSeconds},
                {"truth", e.truthSeconds}}},
              {"drawMs", e.drawMs},
              {"viewsGivenUp", e.viewsGivenUp},
              {"truthNoise", e.truthNoise},
              {"truthFromCache", e.truthFromCache}};
    for (const Score& score : kScores)
        json["scores"][std::string(score.key)] = toJson(spreadOf(valuesOf(e, score.value)));
    json["views"] = Json::array();
    for (const ViewScores& scores : e.scores) {
        Json view;
        for (const Score& score : kScores) view[std::string(score.key)] = toJson(scores.*(score.value));
        json["views"].push_back(std::move(view));
    }
    return json;
}

// "20.51 [18.20 20.40 22.90]": mean, and p10, p50, p90.
std::string cell(const std::optional<Spread>& spread, int decimals) {
    if (!spread) return "nothing to compare";
    return fmt::format("{:.{}f} [{:.{}f} {:.{}f} {:.{}f}]", spread->mean, decimals, spread->p10, decimals,
                       spread->p50, decimals, spread->p90, decimals);
}

std::string rowOf(const std::string& name, const std::string& splats, const std::string& seconds,
                  const std::function<std::optional<Spread>(std::optional<double> ViewScores::*)>& spread) {
    return fmt::format("{:<32} {:>7} {:>7}  {:<27} {:<27} {:<27} {:<27} {:<27} {:<27}\n", name, splats,
                       seconds, cell(spread(&ViewScores::psnrDb), 2),
                       cell(spread(&ViewScores::maskedPsnrDb), 2), cell(spread(&ViewScores::maskedSsim), 3),
                       cell(spread(&ViewScores::flip), 3), cell(spread(&ViewScores::luminanceRatio), 3),
                       cell(spread(&ViewScores::coverageError), 3));
}

}  // namespace

Json toJson(const EvaluationReport& report) {
    const InitialEvaluationOptions& o = report.options;
    Json json{{"evaluation", "init"},
              {"version", MACULA_VERSION},
              {"device", report.device},
              {"lights", report.lights},
              {"clip", report.clip},
              {"model",
               {{"points", o.points.count},
                {"pathsPerPoint", o.points.paths},
                {"views", o.views},
                {"samplesPerPixel", o.samplesPerPixel},
                {"sizePx", o.sizePx},
                {"iterations", o.iterations},
                {"trial", o.trial}}},
              {"truth",
               {{"views", o.truthViews},
                {"samplesPerPixel", o.truth.samplesPerPixel},
                {"sizePx", o.truth.sizePx.x},
                {"bounces", o.truth.bounces}}},
              {"scenes", Json::array()}};
    for (const EvaluatedStudy& scene : report.scenes) json["scenes"].push_back(toJson(scene));
    for (const Score& score : kScores)
        json["overScenes"][std::string(score.key)] = toJson(spreadOf(meansOf(report, score.value)));
    return json;
}

std::string tableOf(const EvaluationReport& report) {
    const InitialEvaluationOptions& o = report.options;
    std::string table = fmt::format(
        "Truth: {} views of {} x {} pixels, {} samples, {} bounces. Model: {} points, {} views of {} "
        "samples, "
        "{} iterations.\nOf each number the mean over views, and [p10 p50 p90].\n\n",
        o.truthViews, o.truth.sizePx.x, o.truth.sizePx.y, o.truth.samplesPerPixel, o.truth.bounces,
        o.points.count, o.views, o.samplesPerPixel, o.iterations);
    table +=
        fmt::format("{:<32} {:>7} {:>7}  {:<27} {:<27} {:<27} {:<27} {:<27} {:<27}\n", "scene", "splats", "s",
                    "PSNR dB", "masked PSNR dB", "masked SSIM", "FLIP", "light / truth", "coverage error");
    for (const EvaluatedStudy& scene : report.scenes) {
        const SceneEvaluation& e = scene.evaluation;
        table += rowOf(fmt::format("{:.8} {}", scene.studyDigest, scene.preset), fmt::format("{}", e.splats),
                       fmt::format("{:.1f}", e.pointsSeconds + e.viewsSeconds + e.trainSeconds),
                       [&](auto value) { return spreadOf(valuesOf(e, value)); });
    }
    if (report.scenes.size() > 1)
        table += rowOf("over scenes, of their means", "", "",
                       [&](auto value) { return spreadOf(meansOf(report, value)); });
    for (const EvaluatedStudy& scene : report.scenes) {
        const SceneEvaluation& e = scene.evaluation;
        table += fmt::format(
            "\n{:.8} {}: points {:.2f} s, views {:.2f} s, training {:.2f} s, drawing {:.0f} ms; "
            "the truth's own noise is {:.4f} ({:.1f} dB)",
            scene.studyDigest, scene.preset, e.pointsSeconds, e.viewsSeconds, e.trainSeconds, e.drawMs,
            e.truthNoise, -20.0 * std::log10(std::max(e.truthNoise, 1e-6)));
        if (e.viewsGivenUp > 0)
            table += fmt::format("; {} views show less than was asked for", e.viewsGivenUp);
        table += ".";
    }
    return table + "\n";
}

}  // namespace macula::cli
