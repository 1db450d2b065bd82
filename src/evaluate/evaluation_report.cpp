#include "evaluate/evaluation_report.h"

#include <algorithm>
#include <iterator>

namespace macula::evaluate {

namespace {

using Json = nlohmann::ordered_json;

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

Json toJson(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

Json toJson(const std::vector<ViewScores>& views) {
    Json json;
    for (const Score& score : kScores) json[std::string(score.key)] = toJson(spreadOf(views, score.value));
    return json;
}

// Over all pixels of all views together, so that no view drops out because of its noise.
Json lessNoiseJson(const std::vector<ViewScores>& views) {
    const auto error = squareErrorOver(views);
    if (!error) return {};
    return {{"mse", error->mean},
            {"mseStandardError", error->standardError},
            {"psnrDb", toJson(image::psnrOf(*error))},
            {"psnrStandardErrorDb", toJson(image::psnrErrorOf(*error))}};
}

// The states of a model during its training.
Json snapshotsJson(const std::vector<Snapshot>& snapshots) {
    Json json = Json::array();
    for (const Snapshot& snapshot : snapshots)
        json.push_back({{"iterations", snapshot.steps},
                        {"splats", snapshot.splats},
                        {"trainSeconds", snapshot.trainSeconds},
                        {"overViewsLessNoise", lessNoiseJson(snapshot.scores)},
                        {"scores", toJson(snapshot.scores)}});
    return json;
}

Json toJson(const EvaluatedStudy& scene, bool refined) {
    const SceneEvaluation& e = scene.evaluation;
    Json json{{"study", scene.studyDigest},
              {"preset", scene.preset},
              {"voxels", {scene.voxels.x, scene.voxels.y, scene.voxels.z}},
              {"tableRemoved", scene.tableRemoved},
              {"seenMm", {{"low", toJson(e.seenMm.low)}, {"high", toJson(e.seenMm.high)}}},
              {"splats", e.last().splats},
              {"seconds",
               {{"points", e.pointsSeconds},
                {"views", e.viewsSeconds},
                {"train", e.last().trainSeconds},
                {"truth", e.truthSeconds}}},
              {"drawMs", e.drawMs},
              {"viewsGivenUp", e.viewsGivenUp},
              {"viewsFromCache", e.viewsFromCache},
              {"truthNoise", e.truthNoise()},
              {"truthFromCache", e.truthFromCache}};
    if (refined) {
        const GreatestFall fall = greatestFall(e.snapshots);
        json["seconds"]["moreViews"] = e.moreViewsSeconds;
        json["greatestFallDb"] = {{"mean", fall.meanDb}, {"p50", fall.medianDb}};
    }
    if (e.snapshots.size() > 1) json["snapshots"] = snapshotsJson(e.snapshots);
    json["overViewsLessNoise"] = lessNoiseJson(e.last().scores);
    json["scores"] = toJson(e.last().scores);
    json["views"] = Json::array();
    for (std::size_t i = 0; i < e.last().scores.size(); ++i) {
        const ViewScores& scores = e.last().scores[i];
        Json view{{"distance", glm::distance(e.truthCameras[i].positionMm, e.seenMm.centre()) /
                                   (0.5 * e.seenMm.diagonal())}};  // in half-diagonals R
        for (const Score& score : kScores) view[std::string(score.key)] = toJson(scores.*(score.value));
        json["views"].push_back(std::move(view));
    }
    return json;
}

}  // namespace

std::optional<Spread> spreadOverScenes(const EvaluationReport& report,
                                       std::optional<double> ViewScores::*value) {
    std::vector<std::optional<double>> means;
    for (const EvaluatedStudy& scene : report.scenes) {
        const auto spread = spreadOf(scene.evaluation.last().scores, value);
        means.push_back(spread ? std::optional(spread->mean) : std::nullopt);
    }
    return spreadOf(means);
}

Json toJson(const EvaluationReport& report) {
    const EvaluationOptions& o = report.options;
    const hybrid::FirstModelOptions& m = o.model;
    Json json{{"evaluation", o.live         ? "live"
                             : o.refinement ? "refine"
                                            : "init"},
              {"version", MACULA_VERSION},
              {"device", report.device},
              {"lights", report.lights},
              {"clip", report.clip},
              {"model",
               {{"points", m.points.count},
                {"pathsPerPoint", m.points.paths},
                {"views", m.views},
                {"samplesPerPixel", m.samplesPerPixel},
                {"directions", m.directions},
                {"sizePx", m.sizePx},
                {"iterations", m.iterations},
                {"trial", m.trial},
                {"degree", m.shDegree}}},
              {"truth",
               {{"views", o.truthViews},
                {"samplesPerPixel", o.truth.samplesPerPixel},
                {"sizePx", o.truth.sizePx.x},
                {"bounces", o.truth.bounces}}},
              {"scenes", Json::array()}};
    if (o.refinement)
        json["refinement"] = {{"views", o.refinement->views},
                              {"samplesPerPixel", o.refinement->samplesPerPixel},
                              {"iterations", o.refinement->iterations},
                              {"capacity", o.refinement->capacity}};
    if (o.live) json["live"] = {{"seconds", o.live->seconds}, {"snapshotEvery", o.live->snapshotEvery}};
    for (const EvaluatedStudy& scene : report.scenes)
        json["scenes"].push_back(toJson(scene, o.refinement.has_value()));
    for (const Score& score : kScores)
        json["overScenes"][std::string(score.key)] = toJson(spreadOverScenes(report, score.value));
    return json;
}

}  // namespace macula::evaluate
