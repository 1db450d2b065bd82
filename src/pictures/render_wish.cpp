#include "pictures/render_wish.h"

#include <utility>

#include "pictures/output_files.h"
#include "pictures/picture_file.h"
#include "scene/choice/clip_choice.h"
#include "scene/choice/lights_choice.h"
#include "scene/choice/typed_values.h"
#include "scene/drawing/drawing_of.h"
#include "scene/drawing/projection_windows.h"

namespace macula::app {

namespace {

// Where nobody says how much work a PNG is worth, it is filtered, and ended by the noise that it has before.
constexpr double kUsualError = 0.1;
constexpr std::uint32_t kMostUsualSamples = 256;

bool endsByUsualError(const RenderWish& wish, trace::Look look) {
    const EffortWish& effort = wish.effort;
    return effort.quality.empty() && !effort.samplesPerPixel && !(effort.error > 0.0) &&
           trace::isPathTraced(look) && !isExr(wish.output);
}

Result<void> checkFiles(const RenderWish& wish) {
    MACULA_TRY_VOID(checkPictureName(wish.output));
    OutputFiles files(wish.overwrite);
    for (const std::filesystem::path& input : filesOf(wish.state)) files.read(input);
    for (const std::filesystem::path& input : filesOf(wish.additions)) files.read(input);
    for (const std::filesystem::path& input :
         {wish.path, std::filesystem::path(wish.effort.quality), std::filesystem::path(wish.lights)})
        files.read(input);
    MACULA_TRY_VOID(files.write(wish.output));
    return files.write(wish.json);
}

Result<void> setLights(WishedPicture& picture, const std::string& typed) {
    if (typed.empty() && picture.state.lights) {
        picture.request.scene.environment = trace::Environment::fromRig(*picture.state.lights);
        picture.lights = publicLightsName(*picture.state.lights);
        return {};
    }
    const std::string name =
        typed.empty() ? std::string(defaultLightsFor(picture.state.settings.look)) : typed;
    MACULA_TRY(picture.request.scene.environment, chooseLights(name));
    picture.lights = publicLightsName(name);
    return {};
}

Result<void> setEffects(WishedPicture& picture, const RenderWish& wish) {
    PictureEffects& effects = picture.request.effects;
    effects = wish.effects;
    if (!wish.focus.empty()) {
        MACULA_TRY(effects.focusMm, parseFocus(wish.focus));
    }
    return check(effects);
}

Result<void> setBackground(WishedPicture& picture, const std::string& typed) {
    picture.request.isTransparent = typed == kTransparent;
    if (!typed.empty() && !picture.request.isTransparent) {
        MACULA_TRY(picture.state.background, backgroundOf(typed));
    }
    picture.request.background = picture.state.background.value_or(kBlackBackground);
    return {};
}

std::string publicClip(const RenderWish& wish, const StudyState& state) {
    const std::string clip =
        state.clip && wish.state.clip.empty() ? publicClipName(*state.clip) : publicClipName(wish.state.clip);
    return state.cuts.isNothing() ? clip : clip + " and cuts";
}

// Whether it says what a surface is like, which a preset without one has no use for.
bool isOfSurface(std::string_view matter) {
    return matter == "surfaceGradientPerMm" || matter == "roughness" || matter == "reflectance";
}

}  // namespace

std::string looksListed(bool (*isMeant)(trace::Look)) {
    std::string listed;
    std::string_view last;
    for (const trace::LookTraits& look : trace::kLooks) {
        if (!isMeant(look.look)) continue;
        if (!last.empty()) listed += (listed.empty() ? "" : ", ") + std::string(last);
        last = look.name;
    }
    return listed.empty() ? std::string(last) : fmt::format("{} and {}", listed, last);
}

std::vector<std::string> optionsWithoutEffect(const RenderWish& wish, trace::Look look,
                                              const TransferFunction& drawn) {
    const bool isTraced = trace::isPathTraced(look);
    const auto isGiven = [&](std::string_view id) { return wish.state.numbers.contains(id); };
    std::vector<std::string> notes;
    const auto check = [&](bool isVain, std::string_view option, const std::string& of) {
        if (isVain) notes.push_back(fmt::format("{} does nothing in this look: it is of {}.", option, of));
    };
    check(!wish.state.window.empty() && !isProjection(look), "--window", looksListed(trace::isProjection));
    check(wish.effort.bounces && !isTraced, "--bounces", "cinematic");
    const auto filter = wish.effort.filter.value_or(trace::Filter::trilinear);
    check(trace::filterOf(look, filter) != filter, fmt::format("--filter {}", trace::nameOf(filter)),
          looksListed(trace::isSpline(filter) ? trace::showsMatter : trace::isPathTraced));
    check(wish.shading && look != trace::Look::dvr, "--shading", "dvr");
    const std::string traced = looksListed(trace::isPathTraced);
    check(!wish.lights.empty() && !isTraced, "--lights", traced);
    check(isGiven("lightRotationDeg") && !isTraced, "--light-rotation", traced);
    check(isGiven("lightStrength") && !isTraced, "--light-strength", traced);
    check(wish.metersExposure && isProjection(look), "--auto-exposure", "all but projections");
    for (const auto& [id, value] : wish.state.matter) {
        const std::string_view option = matterParameter(id).option;
        if (id == "steepGradientPerMm") {
            check(isProjection(look), option, "all but projections");
            if (!isProjection(look) && !usesSteepCurves(drawn))
                notes.push_back(
                    fmt::format("{} does nothing, as the preset has no curves for steep matter.", option));
            continue;
        }
        check(!isTraced, option, traced);
        if (isTraced && drawn.surface.weight == 0.0 && isOfSurface(id))
            notes.push_back(fmt::format(
                "{} does nothing, as the preset has no surface: --surface gives it one.", option));
    }
    check(isGiven("exposure") && isProjection(look), "--exposure", "all but projections");
    check(wish.state.toneMap && isProjection(look), "--tone-map", "all but projections");
    check(wish.effects.fogMm > 0.0 && isProjection(look), "--fog-mm", "all but projections");
    check(wish.effects.lensMm > 0.0 && !isTraced, "--lens-mm", traced);
    if (!wish.focus.empty() && !(wish.effects.lensMm > 0.0))
        notes.emplace_back("--focus-mm does nothing without --lens-mm: all is sharp.");
    if (wish.effort.denoise.value_or(false) && !isTraced)
        notes.emplace_back("This look is never denoised: --denoise does nothing.");
    if (!wish.background.empty() && isExr(wish.output))
        notes.emplace_back("--background does nothing in an EXR, which has coverage instead.");
    if (wish.keepUnfinished && wish.effort.error <= 0.0 && !endsByUsualError(wish, look))
        notes.emplace_back(
            "--keep-unfinished does nothing without --error: nothing is written when stopped.");
    return notes;
}

Result<WishedPicture> wishedPicture(const RenderWish& wish) {
    MACULA_TRY_VOID(checkFiles(wish));
    // Unlike the viewer, a picture shades ray casts only where that is asked for.
    MACULA_TRY(const auto sizePx, parseSize(wish.size));
    StateWish wished = wish.state;
    wished.aspectWidthOverHeight = double(sizePx.x) / double(sizePx.y);
    MACULA_TRY(StudyState state, stateOf(wished, {.settings = {}}));
    WishedPicture picture{.state = std::move(state), .request = {}, .lights = {}, .clip = {}};
    MACULA_TRY(picture.additions, additionChoice(wish.additions, wish.path, picture.state));
    PictureRequest& request = picture.request;
    request.sizePx = sizePx;
    MACULA_TRY(const Effort effort, effortOf(wish.effort, picture.state.settings));
    request.samplesPerPixel = effort.samplesPerPixel;
    picture.state.settings = effort.settings;
    if (endsByUsualError(wish, effort.settings.look)) {
        request.samplesPerPixel = kMostUsualSamples;
        picture.state.settings.errorThreshold = kUsualError;
        if (!wish.effort.denoise) picture.state.settings.denoising = trace::Denoising::on;
    }
    picture.state.settings.seed = wish.seed;
    MACULA_TRY_VOID(setLights(picture, wish.lights));
    MACULA_TRY_VOID(setBackground(picture, wish.background));
    MACULA_TRY_VOID(setEffects(picture, wish));
    picture.clip = publicClip(wish, picture.state);
    request.camera = picture.state.camera;
    request.from = wish.state.view;
    if (wish.state.fovDeg > 0.0) request.verticalFovDeg = wish.state.fovDeg;
    request.isParallel = wish.state.isParallel;
    request.keepUnfinished = wish.keepUnfinished;
    request.isLinear = isExr(wish.output);
    request.metersExposure = wish.metersExposure;
    request.memory = wish.memory;
    return picture;
}

trace::Settings settingsToDraw(const RenderWish& wish, const StudyState& state, const Volume& volume) {
    trace::Settings settings = settingsOf(state, SeriesWindows(), &volume);
    if (wish.shading) settings.shading = trace::Shading::headlight;
    return settings;
}

}  // namespace macula::app
