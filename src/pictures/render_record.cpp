#include "pictures/render_record.h"

#include <nlohmann/json.hpp>

#include "base/english.h"
#include "base/installation_key.h"
#include "base/log.h"
#include "scene/camera/camera_file.h"
#include "scene/camera/usual_view.h"
#include "scene/camera/view_directions.h"
#include "scene/state/parameters.h"

namespace macula::pictures {

namespace {

using Json = nlohmann::ordered_json;

// Six significant digits at most: "-200,0,35".
std::string numbers(const glm::dvec3& vector) {
    return fmt::format("{:.6g},{:.6g},{:.6g}", vector.x, vector.y, vector.z);
}

std::string windowText(const std::optional<DisplayWindow>& window) {
    return window ? fmt::format("{:.6g},{:.6g}", window->center, window->width) : "none";
}

Json windowJson(const std::optional<DisplayWindow>& window) {
    return window ? Json{{"center", window->center}, {"width", window->width}} : Json();
}

// The effects that the look has; the others are off.
PictureEffects effectsThatCount(const PictureRequest& request, const DrawnPicture& picture) {
    PictureEffects effects = request.effects;
    const trace::Look look = request.settings.look;
    if (!trace::isPathTraced(look)) effects.lensMm = 0.0;
    effects.focusMm = effects.lensMm > 0.0 ? std::optional(picture.focusMm) : std::nullopt;
    if (trace::isProjection(look)) effects.fogMm = 0.0;
    return effects;
}

Json matterJson(const RenderRecord& record) {
    Json matter = Json::object();
    for (const auto& [id, value] : record.matter) matter[std::string(id)] = value;
    return matter;
}

}  // namespace

void RenderRecord::add(const PictureRequest& request, const DrawnPicture& picture) {
    device = picture.device;
    camera = picture.camera;
    width = request.sizePx.x;
    height = request.sizePx.y;
    settings = request.settings;
    effects = effectsThatCount(request, picture);
    if (!request.isLinear)
        background =
            request.isTransparent ? std::string(scene::kTransparent) : scene::hexOf(request.background);
    if (!request.camera) {
        const scene::UsualView usual = scene::usualView(*request.scene.volume);
        view = scene::nameOf(request.from.value_or(usual.from));
        whyView = request.from ? "chosen" : std::string(nameOf(usual.why));
    }
    matter.clear();
    for (const scene::MatterParameter& p : scene::matterParameters())
        matter.emplace_back(p.id, p.get(request.scene.function));
    settings.exposure = picture.exposure;
    unit = unitSymbol(request.scene.volume->unit());
    statistics = picture.statistics;
    traceSeconds = picture.seconds;
    for (PictureNote& note : notesOf(picture, request)) notes.push_back(std::move(note.sentence));
}

image::Metadata metadata(const RenderRecord& record) {
    const trace::Settings& settings = record.settings;
    image::Metadata all{
        {"Software", "Macula " MACULA_VERSION},
        {"macula:series", publicSeries(record.seriesDigest)},
        {"macula:look", std::string(trace::nameOf(record.settings.look))},
        {"macula:preset", record.preset},
        {"macula:lights", record.lights},
        {"macula:clip", record.clip},
        {"macula:tableRemoved", record.tableRemoved ? "yes" : "no"},
        {"macula:masked", record.masked.empty() ? "none" : record.masked},
        {"macula:additions", record.additions.empty() ? "none" : record.additions},
        {"macula:filter", std::string(trace::nameOf(record.settings.filter))},
        {"macula:samples", fmt::format("{:.6g}", record.statistics.meanSamplesPerPixel)},
        {"macula:bounces", fmt::to_string(record.settings.bounces)},
        {"macula:seed", fmt::to_string(record.settings.seed)},
        {"macula:denoised", record.statistics.denoised ? "yes" : "no"},
        {"macula:fitted", record.presetFitted ? "yes" : "no"},
        {"macula:shading", settings.shading == trace::Shading::headlight ? "headlight" : "none"},
        {"macula:window", windowText(record.window)},
        {"macula:unit", record.unit.empty() ? "none" : record.unit},
        {"macula:exposure", fmt::format("{:.6g}", settings.exposure)},
        {"macula:toneMap", std::string(trace::nameOf(settings.toneMap))},
        {"macula:lensMm", fmt::format("{:.6g}", record.effects.lensMm)},
        {"macula:focusMm", record.effects.focusMm ? fmt::format("{:.6g}", *record.effects.focusMm) : "none"},
        {"macula:fogMm", fmt::format("{:.6g}", record.effects.fogMm)},
        {"macula:lightRotationDeg", fmt::format("{:.6g}", settings.lightRotationDeg)},
        {"macula:lightStrength", fmt::format("{:.6g}", settings.lightStrength)},
        {"macula:cameraPositionMm", numbers(record.camera.positionMm)},
        {"macula:cameraTargetMm", numbers(record.camera.targetMm)},
        {"macula:cameraUp", numbers(record.camera.up)},
        {"macula:verticalFovDeg", fmt::format("{:.6g}", record.camera.verticalFovDeg)},
        {"macula:view", record.view.empty() ? "camera" : record.view},
        {"macula:whyView", record.whyView.empty() ? "camera" : record.whyView},
        {"macula:background", record.background.empty() ? "none" : record.background},
        {"macula:parallelHeightMm", isParallel(record.camera)
                                        ? fmt::format("{:.6g}", record.camera.parallelHeightMm)
                                        : std::string("none")},
        {"macula:notes", Text::joined(record.notes, " ").english()},
        {"macula:device", record.device}};
    for (const auto& [id, value] : record.matter)
        all.emplace_back(fmt::format("macula:{}", id), fmt::format("{:.6g}", value));
    return all;
}

Json toJson(const RenderRecord& record) {
    const double pixelSamples = record.statistics.meanSamplesPerPixel * record.width * record.height;
    return {
        {"version", MACULA_VERSION},
        {"series", record.seriesDigest},
        {"look", trace::nameOf(record.settings.look)},
        {"preset", record.preset},
        {"lights", record.lights},
        {"lightRotationDeg", record.settings.lightRotationDeg},
        {"lightStrength", record.settings.lightStrength},
        {"exposure", record.settings.exposure},
        {"toneMap", trace::nameOf(record.settings.toneMap)},
        {"lensMm", record.effects.lensMm},
        {"focusMm", record.effects.focusMm ? Json(*record.effects.focusMm) : Json()},  // null: all is sharp
        {"fogMm", record.effects.fogMm},
        {"matter", matterJson(record)},
        {"presetFitted", record.presetFitted},
        {"shading", record.settings.shading == trace::Shading::headlight ? "headlight" : "none"},
        {"window", windowJson(record.window)},
        {"unit", record.unit},
        {"clip", record.clip},
        {"tableRemoved", record.tableRemoved},
        {"masked", record.masked.empty() ? "none" : record.masked},
        {"additions", record.additions.empty() ? "none" : record.additions},
        {"filter", trace::nameOf(record.settings.filter)},
        {"device", record.device},
        {"camera", scene::toJson(record.camera)},
        {"view", record.view.empty() ? "camera" : record.view},
        {"whyView", record.whyView.empty() ? "camera" : record.whyView},
        {"background", record.background.empty() ? "none" : record.background},
        {"width", record.width},
        {"height", record.height},
        {"bounces", record.settings.bounces},
        {"seed", record.settings.seed},
        {"denoised", record.statistics.denoised},
        {"samplesPerPixel", record.statistics.samplesPerPixel},
        {"meanSamplesPerPixel", record.statistics.meanSamplesPerPixel},
        {"estimatedError", record.statistics.estimatedError},  // null: not known
        {"converged", record.statistics.converged},
        {"nonFiniteSamples", record.statistics.nonFiniteSamples},
        {"abandonedSamples", record.statistics.abandonedSamples},
        {"collisionsAboveBound", record.statistics.collisionsAboveBound},
        {"voxels",
         {{"visibleBricks", record.statistics.voxels.visibleBricks},
          {"shownBlocks", record.statistics.voxels.shownBlocks},
          {"coarseBlocks", record.statistics.voxels.coarseBlocks},
          {"poolBytes", record.statistics.voxels.poolBytes},
          {"gridBytes", record.statistics.voxels.gridBytes}}},
        {"loadSeconds", record.loadSeconds},
        {"traceSeconds", record.traceSeconds},
        {"deviceMs", record.statistics.deviceMs},
        {"nsPerSample", pixelSamples > 0.0 ? record.statistics.deviceMs * 1e6 / pixelSamples : 0.0},
        {"notes", inEnglish(record.notes)}};
}

std::string publicSeries(const std::string& seriesDigest) {
    if (seriesDigest.empty() || seriesDigest == "phantom") return seriesDigest;
    const auto key = InstallationKey::ofUser();
    if (key) return key->digestOf(seriesDigest);
    log::warning("Pictures do not say of which series they are: {}", key.error().message.english());
    return "unknown";
}

}  // namespace macula::pictures
