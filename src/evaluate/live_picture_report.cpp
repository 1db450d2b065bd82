#include "evaluate/live_picture_report.h"

#include <nlohmann/json.hpp>

namespace macula::evaluate {

namespace {

using Json = nlohmann::ordered_json;

Json orNull(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

Json toJson(const pictures::MotionFigures& motion) {
    const auto ms = [&](double value) { return motion.frames > 0 ? Json(value) : Json(); };
    return {{"frames", motion.frames},
            {"framesWithFovea", motion.withFovea},
            {"framesPerSecond", motion.framesPerSecond},
            {"latencyMs", {{"median", ms(motion.latencyMs)}, {"p95", ms(motion.lateMs)}}}};
}

Json toJson(const RestPicture& picture) {
    return {{"atS", picture.atS},
            {"picture", nameOf(picture.picture)},
            {"samplesPerPixel", picture.samplesPerPixel > 0 ? Json(picture.samplesPerPixel) : Json()},
            {"flip", picture.flip},
            {"maskedPsnrDb", orNull(picture.maskedPsnrDb)}};
}

Json toJson(const RestCourse& rest) {
    Json series = Json::array();
    for (const RestPicture& picture : rest.pictures) series.push_back(toJson(picture));
    return {{"toFlip002S", orNull(nearFromS(rest.pictures))},
            {"lastFlip", rest.pictures.empty() ? Json() : Json(rest.pictures.back().flip)},
            {"referenceFlip", rest.referenceFlip},
            {"worstSetback", orNull(worstSetback(rest.pictures))},
            {"worstRise", orNull(worstRise(rest.pictures))},
            {"series", std::move(series)}};
}

Json toJson(const PresetChange& change) {
    return {{"preset", change.preset},
            {"firstNewS", orNull(change.times.firstNewS)},
            {"firstFullS", orNull(change.times.firstFullS)},
            {"stale", {{"longestMs", 1e3 * change.times.longestStaleS}, {"wasSaid", change.times.wasSaid}}},
            {"rest", toJson(change.rest)}};
}

}  // namespace

Json toJson(const LivePictureReport& report) {
    return {{"motion", toJson(report.motion)},
            {"firstModelS", orNull(report.firstModelS)},
            {"rest", toJson(report.rest)},
            {"change", report.change ? toJson(*report.change) : Json()},
            {"picturesLeftOut", report.isFull}};
}

Json reportOf(const BenchStudy& study, const LivePictureOptions& options, const LivePictureReport& report) {
    const live::RecordingOptions& recording = options.recording;
    Json json = describe("live-picture", study);
    json["bounces"] = report.bounces;
    json["truthSamplesPerPixel"] = options.truthSamples;
    json["turnS"] = recording.turnS;
    json["movingS"] = recording.movingS;
    json["learningS"] = recording.learningS;
    json["restingS"] = recording.restingS;
    json["picturesPerS"] = recording.picturesPerS;
    json.update(toJson(report));
    return json;
}

}  // namespace macula::evaluate
