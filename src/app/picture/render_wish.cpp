#include "app/picture/render_wish.h"

#include <utility>

#include "app/camera/camera_file.h"
#include "app/choice/lights_choice.h"
#include "app/choice/typed_values.h"
#include "app/frame/projection_windows.h"
#include "app/output/output_files.h"
#include "app/picture/picture_file.h"
#include "app/study/study_preset.h"
#include "pipeline/volume/window.h"

namespace macula::app {

namespace {

// Nothing: one that what is seen fills.
Result<std::optional<Camera>> givenCamera(const RenderWish& wish) {
    if (wish.camera.empty()) return std::optional<Camera>();
    MACULA_TRY(Camera camera, readCamera(wish.camera));
    if (wish.fovDeg > 0.0) camera.verticalFovDeg = wish.fovDeg;
    return std::optional(camera);
}

Result<void> checkFiles(const RenderWish& wish) {
    MACULA_TRY_VOID(checkPictureName(wish.output));
    OutputFiles files(wish.overwrite);
    for (const std::filesystem::path& input :
         {wish.path, std::filesystem::path(wish.preset), wish.camera,
          std::filesystem::path(wish.effort.quality), std::filesystem::path(wish.lights),
          std::filesystem::path(wish.clip)})
        files.read(input);
    MACULA_TRY_VOID(files.write(wish.output));
    return files.write(wish.json);
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

std::vector<std::string> optionsWithoutEffect(const RenderWish& wish) {
    const trace::Settings usual;
    const trace::Settings& given = wish.settings;
    const bool isTraced = trace::isPathTraced(given.look);
    std::vector<std::string> notes;
    const auto check = [&](bool isGiven, const char* option, const std::string& of) {
        if (isGiven) notes.push_back(fmt::format("{} does nothing in this look: it is of {}.", option, of));
    };
    check(!wish.window.empty() && !isProjection(given.look), "--window", looksListed(trace::isProjection));
    check(wish.effort.bounces && !isTraced, "--bounces", "cinematic");
    check(given.shading != usual.shading && given.look != trace::Look::dvr, "--shading", "dvr");
    const std::string traced = looksListed(trace::isPathTraced);
    check(!wish.lights.empty() && !isTraced, "--lights", traced);
    check(given.lightRotationDeg != usual.lightRotationDeg && !isTraced, "--light-rotation", traced);
    check(given.lightStrength != usual.lightStrength && !isTraced, "--light-strength", traced);
    check(given.exposure != usual.exposure && isProjection(given.look), "--exposure", "all but projections");
    if (wish.effort.denoise.value_or(false) && !isTraced)
        notes.emplace_back("This look is never denoised: --denoise does nothing.");
    if (wish.keepUnfinished && wish.effort.error <= 0.0)
        notes.emplace_back(
            "--keep-unfinished does nothing without --error: nothing is written when stopped.");
    return notes;
}

Result<std::optional<DisplayWindow>> projectionWindow(const RenderWish& wish, const TransferFunction& preset,
                                                      const Volume& volume) {
    if (!isProjection(wish.settings.look)) return std::optional<DisplayWindow>();
    if (!wish.window.empty()) {
        MACULA_TRY(const DisplayWindow window, parseWindow(wish.window));
        return std::optional(window);
    }
    std::optional<DisplayWindow> window;
    if (!wish.preset.empty()) window = presetWindow(preset, volume);
    return window ? window : std::optional(SeriesWindows().of(wish.settings.look, volume));
}

Result<PictureRequest> requested(const RenderWish& wish, const std::string& lights) {
    MACULA_TRY_VOID(checkFiles(wish));
    PictureRequest request{.scene = {}, .from = wish.view, .keepUnfinished = wish.keepUnfinished};
    MACULA_TRY(request.sizePx, parseSize(wish.size));
    MACULA_TRY(Effort effort, effortOf(wish.effort, wish.settings));
    request.samplesPerPixel = effort.samplesPerPixel;
    request.settings = std::move(effort.settings);
    MACULA_TRY(request.scene.environment, chooseLights(lights));
    if (!wish.window.empty()) MACULA_TRY_VOID(parseWindow(wish.window));
    if (!wish.preset.empty()) MACULA_TRY_VOID(presetToDraw(wish.preset, wish.fit));
    MACULA_TRY(request.camera, givenCamera(wish));
    if (wish.fovDeg > 0.0) request.verticalFovDeg = wish.fovDeg;
    request.isLinear = isExr(wish.output);
    request.memory = wish.memory;
    return request;
}

}  // namespace macula::app
