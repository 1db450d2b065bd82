#include "pictures/render_request.h"

#include <utility>

#include "pictures/output_files.h"
#include "pictures/picture_file.h"
#include "scene/choice/clip_choice.h"
#include "scene/choice/lights_choice.h"
#include "scene/choice/typed_values.h"
#include "scene/drawing/drawing_of.h"
#include "scene/drawing/projection_windows.h"

namespace macula::pictures {

namespace {

// A PNG without options of effort is denoised, and traced until its noise before that is below this.
constexpr double kUsualError = 0.1;
constexpr std::uint32_t kMostUsualSamples = 256;

bool endsByUsualError(const RenderRequest& request, trace::Look look) {
    const EffortRequest& effort = request.effort;
    return effort.quality.empty() && !effort.samplesPerPixel && !(effort.error > 0.0) &&
           trace::isPathTraced(look) && !isExr(request.output);
}

Result<void> checkFiles(const RenderRequest& request) {
    MACULA_TRY_VOID(checkPictureName(request.output));
    OutputFiles files(request.overwrite);
    for (const std::filesystem::path& input : filesOf(request.state)) files.read(input);
    for (const std::filesystem::path& input : filesOf(request.additions)) files.read(input);
    for (const std::filesystem::path& input :
         {request.path, std::filesystem::path(request.effort.quality), std::filesystem::path(request.lights)})
        files.read(input);
    MACULA_TRY_VOID(files.write(request.output));
    return files.write(request.json);
}

Result<void> setLights(RequestedPicture& picture, const std::string& typed) {
    if (typed.empty() && picture.state.lights) {
        picture.request.scene.environment = trace::Environment::fromRig(*picture.state.lights);
        picture.lights = scene::publicLightsName(*picture.state.lights);
        return {};
    }
    const std::string name =
        typed.empty() ? std::string(scene::defaultLightsFor(picture.state.settings.look)) : typed;
    MACULA_TRY(picture.request.scene.environment, scene::chooseLights(name));
    picture.lights = scene::publicLightsName(name);
    return {};
}

Result<void> setEffects(RequestedPicture& picture, const RenderRequest& request) {
    PictureEffects& effects = picture.request.effects;
    effects = request.effects;
    if (!request.focus.empty()) {
        MACULA_TRY(effects.focusMm, parseFocus(request.focus));
    }
    return check(effects);
}

Result<void> setBackground(RequestedPicture& picture, const std::string& typed) {
    picture.request.isTransparent = typed == scene::kTransparent;
    if (!typed.empty() && !picture.request.isTransparent) {
        MACULA_TRY(picture.state.background, scene::backgroundOf(typed));
    }
    picture.request.background = picture.state.background.value_or(scene::kBlackBackground);
    return {};
}

std::string publicClip(const RenderRequest& request, const scene::StudyState& state) {
    const std::string clip = state.clip && request.state.clip.empty()
                                 ? scene::publicClipName(*state.clip)
                                 : scene::publicClipName(request.state.clip);
    return state.cuts.isNothing() ? clip : clip + " and cuts";
}

// Whether the parameter describes a surface: a preset without one does not use it.
bool isOfSurface(std::string_view matter) {
    return matter == "surfaceGradientPerMm" || matter == "roughness" || matter == "reflectance";
}

}  // namespace

Text looksListed(bool (*isMeant)(trace::Look)) {
    std::vector<Text> names;
    for (const trace::LookTraits& look : trace::kLooks)
        if (isMeant(look.look)) names.push_back(Text::verbatim(look.name));
    if (names.size() < 2) return Text::joined(std::move(names), ", ");
    Text last = std::move(names.back());
    names.pop_back();
    return Text("{} and {}", Text::joined(std::move(names), ", "), std::move(last));
}

std::vector<Text> optionsWithoutEffect(const RenderRequest& request, trace::Look look,
                                       const TransferFunction& drawn) {
    const bool isTraced = trace::isPathTraced(look);
    const auto isGiven = [&](std::string_view id) { return request.state.numbers.contains(id); };
    std::vector<Text> notes;
    const auto check = [&](bool isVain, std::string_view option, const Text& of) {
        if (isVain) notes.push_back(Text("{} does nothing in this look: it is of {}.", option, of));
    };
    check(!request.state.window.empty() && !isProjection(look), "--window", looksListed(trace::isProjection));
    check(request.effort.bounces && !isTraced, "--bounces", Text::verbatim("cinematic"));
    const auto filter = request.effort.filter.value_or(trace::Filter::trilinear);
    check(trace::filterOf(look, filter) != filter, fmt::format("--filter {}", trace::nameOf(filter)),
          looksListed(trace::isSpline(filter) ? trace::showsMatter : trace::isPathTraced));
    check(request.shading && look != trace::Look::dvr, "--shading", Text::verbatim("dvr"));
    const Text traced = looksListed(trace::isPathTraced);
    const Text allButProjections = Text("all but projections");
    check(!request.lights.empty() && !isTraced, "--lights", traced);
    check(isGiven("lightRotationDeg") && !isTraced, "--light-rotation", traced);
    check(isGiven("lightStrength") && !isTraced, "--light-strength", traced);
    check(request.metersExposure && isProjection(look), "--auto-exposure", allButProjections);
    for (const auto& [id, value] : request.state.matter) {
        const std::string_view option = scene::matterParameter(id).option;
        if (id == "steepGradientPerMm") {
            check(isProjection(look), option, allButProjections);
            if (!isProjection(look) && !usesSteepCurves(drawn))
                notes.push_back(
                    Text("{} does nothing, as the preset has no curves for steep matter.", option));
            continue;
        }
        check(!isTraced, option, traced);
        if (isTraced && drawn.surface.weight == 0.0 && isOfSurface(id))
            notes.push_back(
                Text("{} does nothing, as the preset has no surface: --surface gives it one.", option));
    }
    check(isGiven("exposure") && isProjection(look), "--exposure", allButProjections);
    check(request.state.toneMap && isProjection(look), "--tone-map", allButProjections);
    check(request.effects.fogMm > 0.0 && isProjection(look), "--fog-mm", allButProjections);
    check(request.effects.lensMm > 0.0 && !isTraced, "--lens-mm", traced);
    if (!request.focus.empty() && !(request.effects.lensMm > 0.0))
        notes.emplace_back(Text("--focus-mm does nothing without --lens-mm: all is sharp."));
    if (request.effort.denoise.value_or(false) && !isTraced)
        notes.emplace_back(Text("This look is never denoised: --denoise does nothing."));
    if (!request.background.empty() && isExr(request.output))
        notes.emplace_back(Text("--background does nothing in an EXR, which has coverage instead."));
    if (request.keepUnfinished && request.effort.error <= 0.0 && !endsByUsualError(request, look))
        notes.emplace_back(
            Text("--keep-unfinished does nothing without --error: nothing is written when stopped."));
    return notes;
}

Result<RequestedPicture> requestedPicture(const RenderRequest& request) {
    MACULA_TRY_VOID(checkFiles(request));
    MACULA_TRY(const auto sizePx, scene::parseSize(request.size));
    StateRequest ofState = request.state;
    ofState.aspectWidthOverHeight = double(sizePx.x) / double(sizePx.y);
    // Unlike the viewer, a picture shades ray casts only if the options ask for it.
    MACULA_TRY(scene::StudyState state, stateOf(ofState, {.settings = {}}));
    RequestedPicture picture{.state = std::move(state), .request = {}, .lights = {}, .clip = {}};
    MACULA_TRY(picture.additions, resolveAdditions(request.additions, request.path, picture.state));
    PictureRequest& drawn = picture.request;
    drawn.sizePx = sizePx;
    MACULA_TRY(const Effort effort, effortOf(request.effort, picture.state.settings));
    drawn.samplesPerPixel = effort.samplesPerPixel;
    picture.state.settings = effort.settings;
    if (endsByUsualError(request, effort.settings.look)) {
        drawn.samplesPerPixel = kMostUsualSamples;
        picture.state.settings.errorThreshold = kUsualError;
        if (!request.effort.denoise) picture.state.settings.denoising = trace::Denoising::on;
    }
    picture.state.settings.seed = request.seed;
    MACULA_TRY_VOID(setLights(picture, request.lights));
    MACULA_TRY_VOID(setBackground(picture, request.background));
    MACULA_TRY_VOID(setEffects(picture, request));
    picture.clip = publicClip(request, picture.state);
    drawn.camera = picture.state.camera;
    drawn.from = request.state.view;
    if (request.state.fovDeg > 0.0) drawn.verticalFovDeg = request.state.fovDeg;
    drawn.isParallel = request.state.isParallel;
    drawn.keepUnfinished = request.keepUnfinished;
    drawn.isLinear = isExr(request.output);
    drawn.metersExposure = request.metersExposure;
    drawn.memory = request.memory;
    return picture;
}

trace::Settings settingsToDraw(const RenderRequest& request, const scene::StudyState& state,
                               const Volume& volume) {
    trace::Settings settings = scene::settingsOf(state, scene::SeriesWindows(), &volume);
    if (request.shading) settings.shading = trace::Shading::headlight;
    return settings;
}

}  // namespace macula::pictures
