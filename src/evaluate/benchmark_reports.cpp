#include "evaluate/benchmark_reports.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/parallel.h"
#include "live/frame/times_report.h"
#include "scene/camera/camera_file.h"

namespace macula::evaluate {

namespace {

using Json = nlohmann::ordered_json;

Json spentJson(const Spent& spent) {
    return {{"wallMs", spent.wallMs}, {"cpuMs", spent.cpuMs}};
}

// The time for one sample of every pixel.
Json sampleJson(const Spent& spent, const trace::View& view) {
    return {{"secondsPerSample", spent.wallMs / 1e3},
            {"cpuSecondsPerSample", spent.cpuMs / 1e3},
            {"microsecondsPerPixel", spent.wallMs / (double(view.width) * view.height) * 1e3}};
}

Json toJson(const TimeToError& time) {
    if (!time.reached) return {{"reached", false}, {"samples", time.samples}, {"flip", time.flip}};
    return {{"reached", true}, {"samples", time.samples}, {"ms", time.ms}, {"flip", time.flip}};
}

Json toJson(const TradeoffPoint& point) {
    return {{"filter", trace::nameOf(point.filter)},
            {"denoised", point.isDenoised()},
            {"bounces", point.bounces},
            {"samples", point.samples},
            {"traceMs", point.traceMs},
            {"displayMs", point.displayMs},
            {"psnrDb", point.psnrDb},
            {"ssim", point.ssim},
            {"flip", point.flip}};
}

Json toJson(const std::optional<Loading>& loading) {
    if (!loading) return nullptr;
    return {{"seconds", loading->seconds},
            {"peakBytes", loading->peakBytes},
            {"secondsOverOurs", loading->secondsOverOurs}};
}

Json toJson(const CastTime& time) {
    return {{"firstSeconds", time.firstSeconds},
            {"secondsPerPicture", time.secondsPerPicture},
            {"flipToConverged", time.flip}};
}

Json toJson(const CastBenchmark& benchmark) {
    Json json = {{"look", benchmark.subject}, {"ours", toJson(benchmark.ours)}, {"vtk", nullptr}};
    if (!benchmark.vtk) return json;
    json["vtk"] = toJson(benchmark.vtk->time);
    json["vtk"]["stepMm"] = benchmark.vtk->stepMm;
    json["vtk"]["secondsInThirdSteps"] = benchmark.vtk->secondsInThirdSteps;
    json["vtk"]["flipInThirdSteps"] = benchmark.vtk->flipInThirdSteps;
    json["oursOverVtk"] = benchmark.oursOverVtk;
    return json;
}

Json toJson(const SizedTrainingBenchmark& sized) {
    Json stages = Json::object();
    for (const auto& [name, stage] : stagesOf(sized.training)) {
        stages[name] = {{"device", spentJson(stage.device)},
                        {"reference", stage.reference ? spentJson(*stage.reference) : Json()},
                        {"wallRatio", stage.reference ? Json(stage.ratio.wall) : Json()},
                        {"cpuRatio", stage.reference ? Json(stage.ratio.cpu) : Json()}};
    }
    return {{"picture", {sized.sizePx.x, sized.sizePx.y}},
            {"pairs", sized.training.pairs},
            {"stages", std::move(stages)},
            {"stepsPerSecond", stepsPerSecond(sized.training)}};
}

// The spread over views.
Json toJson(const std::optional<Spread>& spread) {
    if (!spread) return nullptr;
    return {{"median", spread->p50}, {"p10", spread->p10}, {"p90", spread->p90}};
}

template <class Number>
Json spreadJson(const std::vector<QualityView>& views, const Number& of) {
    std::vector<std::optional<double>> values;
    std::transform(views.begin(), views.end(), std::back_inserter(values), of);
    return toJson(spreadOf(values));
}

Json regionJson(const std::vector<QualityView>& views, RegionScores FrameScores::*region) {
    const auto json = [&](std::optional<double> RegionScores::*value) {
        return spreadJson(views, [&](const QualityView& view) { return view.scores.*region.*value; });
    };
    return {{"maskedPsnrDb", json(&RegionScores::maskedPsnrDb)},
            {"maskedSsim", json(&RegionScores::maskedSsim)},
            {"flip", json(&RegionScores::flip)}};
}

}  // namespace

Json reportOf(const BenchStudy& study, const TraceBenchmarkOptions& options,
              std::span<const TraceBenchmark> results) {
    Json json = describe("trace", study);
    json["referenceThreads"] = coreCount();
    json["camera"] = scene::toJson(study.view.camera);
    json["bounces"] = options.bounces;
    json["samplesPerPixel"] = options.samplesPerPixel;
    json["repetitions"] = options.repetitions;
    json["results"] = Json::array();
    for (const TraceBenchmark& result : results) {
        json["results"].push_back({{"filter", trace::nameOf(result.filter)},
                                   {"device", sampleJson(result.device, study.view)},
                                   {"call", sampleJson(result.call, study.view)},
                                   {"reference", sampleJson(result.reference, study.view)},
                                   {"wallRatio", result.ratio.wall},
                                   {"cpuRatio", result.ratio.cpu},
                                   {"callOverDevice", result.calls.wall}});
    }
    return json;
}

Json reportOf(const BenchStudy& study, const FovealOptions& options, const FovealReport& result) {
    Json json = describe("foveal", study);
    json["referenceThreads"] = coreCount();
    json["camera"] = scene::toJson(study.view.camera);
    json["bounces"] = options.bounces;
    json["filter"] = trace::nameOf(options.filter);
    json["samplesPerPixel"] = options.samples;
    json["repetitions"] = options.repetitions;
    json["sideBySide"] = options.sideBySide > 0 ? Json(options.sideBySide) : Json();
    json["times"] = {{"traceMs", result.times.traceMs},
                     {"traceDispatches", result.times.dispatches},
                     {"guidesMs", result.times.guidesMs},
                     {"denoiseAndDisplayMs", result.times.displayMs},
                     {"totalMs", result.totalMs},
                     {"referenceTraceMs", result.times.referenceTraceMs},
                     {"totalOverReferenceTrace", result.ratio}};
    if (options.convergedSamples > 0) {
        json["timeToError"] = {{"flip", options.flip},
                               {"convergedSamples", options.convergedSamples},
                               {"flipOfItsHalf", result.convergedFlip},
                               {"plain", toJson(result.plain)},
                               {"denoised", toJson(result.denoised)},
                               {"adaptiveDenoised", toJson(result.adaptive)},
                               {"cached", toJson(result.cached)},
                               {"cachedDenoised", toJson(result.cachedDenoised)},
                               {"corrected", toJson(result.corrected)},
                               {"correctedDenoised", toJson(result.correctedDenoised)}};
        const auto ratio = [&](const char* name, const TimeToError& time) {
            if (time.reached && result.plain.reached) json["timeToError"][name] = time.ms / result.plain.ms;
        };
        ratio("denoisedOverPlain", result.denoised);
        ratio("adaptiveDenoisedOverPlain", result.adaptive);
        ratio("cachedOverPlain", result.cached);
        ratio("cachedDenoisedOverPlain", result.cachedDenoised);
        ratio("correctedOverPlain", result.corrected);
        ratio("correctedDenoisedOverPlain", result.correctedDenoised);
    }
    return json;
}

Json reportOf(const BenchStudy& study, const EditsOptions& options, const EditsReport& result) {
    const auto toJson = [](const EditScore& score) {
        return Json{{"flip", score.flip}, {"lacks", score.lacks}, {"remains", score.remains}};
    };
    Json json = describe("edits", study);
    json["picture"] = {options.sizePx.x, options.sizePx.y};
    json["smallPicture"] = {result.smallPx.x, result.smallPx.y};
    json["bounces"] = options.model.bounces;
    json["truthSamplesPerPixel"] = options.truthSamples;
    json["edits"] = Json::array();
    for (const Edit& edit : result.edits) {
        json["edits"].push_back({{"edit", edit.name},
                                 {"estimateMs", edit.estimateMs},
                                 {"stages", live::toJson(edit.stages)},
                                 {"drawMs", edit.drawMs},
                                 {"splats", edit.splats},
                                 {"estimated", toJson(edit.estimated)},
                                 {"small", toJson(edit.small)}});
    }
    return json;
}

namespace {

Json edgesJson(const image::EdgeVisibility& edges) {
    const auto steps = [](const image::LuminanceSteps& s) {
        return Json{{"mean", s.mean}, {"most", s.most}};
    };
    return {{"frame", steps(edges.frame)},
            {"reference", steps(edges.reference)},
            {"meanRatio", edges.meanRatio()},
            {"mostRatio", edges.mostRatio()}};
}

}  // namespace

Json reportOf(const BenchStudy& study, const MotionOptions& options, const MotionReport& result) {
    const auto toJson = [](const FrameScore& score) {
        Json json{{"flip", score.flip}, {"fovealFlip", score.fovealFlip}, {"backgroundPx", score.through}};
        if (score.seam)
            json["seam"] = {{"frame", score.seam->frame},
                            {"reference", score.seam->reference},
                            {"ratio", score.seam->ratio()}};
        if (score.silhouette) json["silhouette"] = edgesJson(*score.silhouette);
        if (score.mixed) json["mixed"] = edgesJson(*score.mixed);
        json["darkerPx"] = score.darker;
        return json;
    };
    Json json = describe("motion", study);
    json["picture"] = {options.sizePx.x, options.sizePx.y};
    json["bounces"] = options.model.bounces;
    json["foveaSamplesPerPixel"] = options.foveaSamples;
    json["truthSamplesPerPixel"] = options.truthSamples;
    json["splats"] = result.splats;
    json["foveaMs"] = result.foveaMs;
    json["frames"] = Json::array();
    for (const MovedFrame& frame : result.frames) {
        json["frames"].push_back({{"from", frame.from},
                                  {"moved", nameOf(frame.moved)},
                                  {frame.moved == Moved::step ? "mm" : "degrees", frame.amount},
                                  {"reprojected", toJson(frame.reprojected)},
                                  {"pasted", toJson(frame.pasted)},
                                  {"splats", toJson(frame.splats)},
                                  {"drawMs", frame.drawMs},
                                  {"splatsDrawMs", frame.splatsDrawMs}});
    }
    json["shareBest"] = result.best;
    json["shareBestInMiddle"] = result.fovealBest;
    return json;
}

namespace {

// The times of the frames' foveae, and the rest: splats, reprojection, composition. Null without foveae.
Json foveaTimesJson(const QualityRow& row) {
    using Times = hybrid::FoveaTimes;
    using Number = std::optional<double>;
    const auto json = [&row](double Times::*ms) {
        return spreadJson(row.views, [ms](const QualityView& view) {
            return view.foveaTimes ? Number((*view.foveaTimes).*ms) : Number();
        });
    };
    const auto rest = [](const QualityView& view) {
        if (!view.foveaTimes) return Number();
        const Times& times = *view.foveaTimes;
        return Number(view.frameMs - times.traceMs - times.developMs - times.captureMs);
    };
    return {{"trace", json(&Times::traceMs)},
            {"guidesAndFilter", json(&Times::developMs)},
            {"capture", json(&Times::captureMs)},
            {"rest", spreadJson(row.views, rest)}};
}

}  // namespace

Json toJson(const QualityRow& row) {
    using View = QualityView;
    using Number = std::optional<double>;
    const auto samples = [](const View& view) {
        return view.samplesPerPixel > 0 ? Number(view.samplesPerPixel) : Number();
    };
    const auto seam = [](const View& view) { return view.seam ? Number(view.seam->ratio()) : Number(); };
    const auto silhouette = [&row](double (image::EdgeVisibility::*ratio)() const) {
        return spreadJson(row.views, [ratio](const View& view) {
            return view.silhouette ? Number(((*view.silhouette).*ratio)()) : Number();
        });
    };
    return {{"way", row.way},
            {"model", row.model.empty() ? Json() : Json(row.model)},
            {"splats", row.splats > 0 ? Json(row.splats) : Json()},
            {"preparationSeconds", orNull(row.preparationSeconds)},
            {"frameMs", spreadJson(row.views, [](const View& view) { return Number(view.frameMs); })},
            {"stagesMs", foveaTimesJson(row)},
            {"samplesPerPixel", spreadJson(row.views, samples)},
            {"resolutionShare",
             spreadJson(row.views, [](const View& view) { return Number(view.resolutionShare); })},
            {"full", regionJson(row.views, &FrameScores::full)},
            {"msSsim", spreadJson(row.views, [](const View& view) { return view.scores.msSsim; })},
            {"seamRatio", spreadJson(row.views, seam)},
            {"silhouetteMeanRatio", silhouette(&image::EdgeVisibility::meanRatio)},
            {"silhouetteMostRatio", silhouette(&image::EdgeVisibility::mostRatio)},
            {"fovea", regionJson(row.views, &FrameScores::fovea)}};
}

Json reportOf(const BenchStudy& study, const QualityOptions& options, const QualityReport& result) {
    Json json = describe("quality", study);
    json["picture"] = {options.sizePx.x, options.sizePx.y};
    json["verticalFovDeg"] = options.poses.verticalFovDeg;
    json["foveaFieldDeg"] = trace::kFovealFieldDeg;
    json["bounces"] = options.bounces;
    json["views"] = options.views;
    json["viewsGivenUp"] = result.viewsGivenUp;
    json["truthSamplesPerPixel"] = options.truthSamples;
    json["rows"] = Json::array();
    for (const QualityRow& row : result.rows) json["rows"].push_back(toJson(row));
    json["gains"] = Json::array();
    for (const QualityGain& gain : result.gains)
        json["gains"].push_back({{"way", gain.way},
                                 {"model", gain.model},
                                 {"foveaGainDb", toJson(gain.foveaDb)},
                                 {"equalTimeShare", toJson(gain.equalTimeShare)},
                                 {"fullGainOverSplatsDb", toJson(gain.fullOverSplatsDb)}});
    return json;
}

Json reportOf(const BenchStudy& study, const TradeoffOptions& options, const Tradeoff& result) {
    Json json = describe("trace-tradeoff", study);
    json["converged"] = {{"samples", options.convergedSamples},
                         {"bounces", options.convergedBounces},
                         {"lost", result.convergedLost},
                         {"ms", result.convergedMs},
                         {"flipOfItsHalf", result.convergedFlip}};
    json["results"] = Json::array();
    for (const TradeoffPoint& point : result.points) json["results"].push_back(toJson(point));
    return json;
}

Json reportOf(const BenchStudy& study, int turns, std::span<const CastBenchmark> results) {
    Json json = describe("cast", study);
    json["threads"] = coreCount();
    json["repetitions"] = turns;
    json["results"] = Json::array();
    for (const CastBenchmark& result : results) json["results"].push_back(toJson(result));
    return json;
}

Json reportOf(std::string_view seriesDigest, const HeaderBenchmark& headers,
              const LoadBenchmarkOptions& options, const LoadBenchmark& loading) {
    const auto ratio = [](const std::optional<Loading>& contender) {
        return contender ? Json(contender->secondsOverOurs) : Json();
    };
    return {{"benchmark", "load"},
            {"version", MACULA_VERSION},
            {"threads", options.threads},
            {"rounds", options.rounds},
            {"study", seriesDigest},
            {"voxels", loading.voxels},
            {"headers",
             {{"files", headers.files},
              {"oursPerSecond", headers.headersPerSecond},
              {"dcmtkPerSecond", headers.bareDcmtkPerSecond},
              {"scanPerSecond", headers.scanPerSecond}}},
            {"loading",
             {{"bytesBefore", loading.bytesBefore},
              {"ours", toJson(loading.ours)},
              {"itk", toJson(loading.itk)},
              {"dcmtk", toJson(loading.dcmtk)},
              {"voxelsWhereItkDiffers", loading.itk ? Json(loading.differingVoxels) : Json()}}},
            {"results",
             {{"headersOverDcmtk", headers.headersPerSecond / headers.bareDcmtkPerSecond},
              {"itkOverOurs", ratio(loading.itk)},
              {"dcmtkOverOurs", ratio(loading.dcmtk)}}}};
}

Json beginningOf(const BenchStudy& study, const StudyTrainingOptions& options) {
    Json json = describe("train", study);
    json["deviceKind"] = gpu::deviceTypeName(study.device->info().type);
    json["referenceThreads"] = coreCount();
    json["repetitions"] = options.repetitions;
    json["shDegree"] = options.shDegree;
    return json;
}

Json toJson(const StudyTrainingReport& report) {
    Json json = {{"splats", report.splats}, {"results", Json::array()}};
    for (const SizedTrainingBenchmark& result : report.results) json["results"].push_back(toJson(result));
    if (report.fromVolume)
        json["fromVolume"] = {{"firstSplatsMs", report.fromVolume->firstSplatsMs},
                              {"firstPictureMs", report.fromVolume->firstPictureMs},
                              {"tracedViewMs", report.fromVolume->tracedViewMs},
                              {"samplesPerPixel", StudyTrainingBench::kSamplesPerPixel}};
    return json;
}

std::vector<std::pair<const char*, StageBenchmark>> stagesOf(const TrainingBenchmark& b) {
    return {{"project", b.project}, {"lists", b.lists}, {"deviceLists", b.deviceLists},
            {"raster", b.raster},   {"loss", b.loss},   {"backward", b.backward},
            {"adam", b.adam},       {"step", b.step}};
}

double stepsPerSecond(const TrainingBenchmark& benchmark) {
    return 1000.0 / benchmark.step.device.wallMs;
}

std::string_view trainingRatioOf(const gpu::Device& device) {
    return device.isCpu() ? "cpuRatio" : "wallRatio";
}

}  // namespace macula::evaluate
