#include <chrono>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/elapsed.h"
#include "base/english.h"
#include "c/camera.h"
#include "c/device.h"
#include "c/handles.h"
#include "c/last_error.h"
#include "c/pixels.h"
#include "c/sized.h"
#include "c/told_progress.h"
#include "c/view.h"
#include "pictures/drawn_picture.h"
#include "pictures/picture_effort.h"
#include "pictures/render_record.h"
#include "scene/choice/clip_choice.h"
#include "scene/choice/lights_choice.h"
#include "scene/drawing/drawing_of.h"
#include "scene/drawing/projection_windows.h"

namespace macula::c {

namespace {

Result<pictures::EffortRequest> effortRequestOf(const macula_picture& picture) {
    pictures::EffortRequest request;
    if (picture.quality != nullptr) request.quality = picture.quality;
    if (picture.samples_per_pixel > pictures::kMostSamplesPerPixel)
        return badArgument(Text("That many samples per pixel cannot be drawn."),
                           Text("Take at most {}.", pictures::kMostSamplesPerPixel));
    if (picture.samples_per_pixel > 0) request.samplesPerPixel = picture.samples_per_pixel;
    if (!(picture.most_noise >= 0.0 && picture.most_noise <= 1.0))
        return badArgument(Text("The noise of the picture is no share of black to white."),
                           Text("Give 0 to 1; 0 leaves it open."));
    request.error = picture.most_noise;
    if (picture.denoise < MACULA_AS_QUALITY || picture.denoise > MACULA_PLAIN)
        return badArgument(Text("How the picture is denoised is not known."),
                           Text("Use MACULA_AS_QUALITY, MACULA_DENOISED or MACULA_PLAIN."));
    if (picture.denoise != MACULA_AS_QUALITY) request.denoise = picture.denoise == MACULA_DENOISED;
    return request;
}

pictures::PictureEffects effectsOf(const macula_picture& picture) {
    pictures::PictureEffects effects{.lensMm = picture.lens_mm, .fogMm = picture.fog_mm};
    if (picture.focus_mm != 0.0) effects.focusMm = picture.focus_mm;
    return effects;
}

// Also puts in the row_bytes that 0 stands for.
Result<macula_picture> checked(const macula_picture* given) {
    if (given == nullptr) return nullHandle();
    MACULA_TRY(macula_picture picture, taken(given));
    MACULA_TRY_VOID(checkSize(picture.width, picture.height));
    MACULA_TRY_VOID(check(effectsOf(picture)));
    MACULA_TRY(picture.row_bytes,
               rowBytesOf({picture.rgba, picture.bytes, picture.row_bytes}, picture.width, picture.height));
    return picture;
}

struct Scene {
    pictures::PictureRequest request;
    pictures::RenderRecord record;  // record of the view, with its notes
};

Result<trace::Environment> lightsOf(const macula_view& view, const scene::StudyState& state) {
    if (view.lights.empty() && state.lights) return trace::Environment::fromRig(*state.lights);
    return scene::chooseLights(lightsNamed(view, state));
}

// The scene that the view and the picture ask for.
Result<Scene> sceneOf(const macula_view& view, const macula_picture& picture, Progress& progress) {
    MACULA_TRY(scene::StudyState state, stateOf(view));
    MACULA_TRY(const pictures::EffortRequest asked, effortRequestOf(picture));
    MACULA_TRY(const pictures::Effort effort, pictures::effortOf(asked, state.settings));
    state.settings = effort.settings;
    state.settings.seed = picture.seed;
    MACULA_TRY(SeenView seen, seenBy(view, std::move(state), progress));

    Scene scene;
    pictures::PictureRequest& request = scene.request;
    request.scene.volume = view.study.volume;
    request.scene.function = seen.preset.function;
    request.scene.clip = seen.shown.clip;
    MACULA_TRY(request.scene.environment, lightsOf(view, seen.state));
    request.camera = seen.state.camera;
    request.from = view.request.view;
    request.background = seen.state.background.value_or(scene::kBlackBackground);
    request.sizePx = {picture.width, picture.height};
    request.settings = scene::settingsOf(seen.state, scene::SeriesWindows(), view.study.volume.get());
    request.samplesPerPixel = effort.samplesPerPixel;
    request.effects = effectsOf(picture);
    scene.record.seriesDigest = view.study.seriesDigest;
    scene.record.preset = std::move(seen.preset.publicName);
    scene.record.presetFitted = seen.preset.function.fitToVolume.has_value();
    scene.record.lights = view.lights.empty() && seen.state.lights
                              ? scene::publicLightsName(*seen.state.lights)
                              : scene::publicLightsName(lightsNamed(view, seen.state));
    scene.record.clip =
        seen.state.clip ? scene::publicClipName(*seen.state.clip) : scene::publicClipName(std::string());
    scene.record.tableRemoved = seen.shown.tableRemoved;
    if (seen.shown.clip.mask) scene.record.masked = seen.shown.clip.mask->remark.english();
    scene.record.window = request.settings.window;
    scene.record.notes = std::move(seen.notes);
    return scene;
}

void copyRows(const std::vector<std::uint8_t>& rgba, const macula_picture& picture) {
    const std::size_t row = 4 * std::size_t(picture.width);
    for (std::size_t y = 0; y < std::size_t(picture.height); ++y)
        std::memcpy(picture.rgba + y * picture.row_bytes, rgba.data() + y * row, row);
}

// Draws with the scene that the last picture left on the device, as far as it is the same. After a failure or
// an exception nothing is left, because a scene that is half changed must not be drawn.
Result<pictures::DrawnPicture> drawOn(const std::shared_ptr<gpu::Device>& device,
                                      std::optional<pictures::PictureDrawer>& left,
                                      const pictures::PictureRequest& request, Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    std::optional<pictures::PictureDrawer> drawer = std::exchange(left, std::nullopt);
    MACULA_TRY_VOID(pictures::PictureDrawer::adapt(drawer, device, request, progress));
    MACULA_TRY(pictures::DrawnPicture drawn, drawer->draw(request.camera, progress));
    drawn.seconds = secondsSince(start);
    left = std::move(drawer);
    return drawn;
}

Result<void> draw(macula_device& device, macula_view& view, const macula_picture& picture, Progress& progress,
                  macula_drawn* told) {
    MACULA_TRY(Scene scene, sceneOf(view, picture, progress));
    device.told->clear();
    device.lastScene.be(view.scene);
    pictures::DrawnPicture drawn;
    MACULA_TRY_VOID(device.lasting.run([&](const std::shared_ptr<gpu::Device>& on) -> Result<void> {
        MACULA_TRY(drawn,
                   view.scene->use(&device.lastScene, [&](std::optional<pictures::PictureDrawer>& left) {
                       return drawOn(on, left, scene.request, progress);
                   }));
        return {};
    }));
    std::vector<std::string> notes = inEnglish(scene.record.notes);
    for (const pictures::PictureNote& note : notesOf(drawn, scene.request))
        notes.push_back(
            (note.action.empty() ? note.sentence : Text("{} {}", note.sentence, note.action)).english());
    notes.insert(notes.end(), device.told->begin(), device.told->end());
    scene.record.add(scene.request, drawn);
    view.record = toJson(scene.record).dump(4, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    view.notes = std::move(notes);
    view.preset = scene.record.preset;
    view.device = drawn.device;
    view.drawnFrom = drawn.camera;
    copyRows(drawn.rgba, picture);
    if (told == nullptr) return {};
    macula_drawn all{};
    all.is_denoised = drawn.statistics.denoised ? 1 : 0;
    all.is_empty = isEmpty(drawn, scene.request) ? 1 : 0;
    all.is_coarse = drawn.statistics.voxels.coarseBlocks > 0 ? 1 : 0;
    all.samples_per_pixel = drawn.statistics.meanSamplesPerPixel;
    all.noise = drawn.statistics.estimatedError;
    all.seconds = drawn.seconds;
    all.preset = view.preset.c_str();
    all.device = view.device.c_str();
    all.camera = toldOf(drawn.camera);
    give(all, told);
    return {};
}

}  // namespace

extern "C" {

macula_status macula_view_record(const macula_view* view, const char** json) {
    if (json != nullptr) *json = nullptr;
    return guarded([&]() -> Result<void> {
        if (json == nullptr) return nullHandle();
        MACULA_TRY(const Held<const macula_view> of, reading(view));
        if (of->record.empty())
            return badArgument(Text("The view was not drawn yet."), Text("Draw it first."));
        *json = of->record.c_str();
        return {};
    });
}

macula_status macula_draw(macula_device* device, macula_view* view, const macula_picture* picture,
                          const macula_progress* progress, macula_drawn* drawn) {
    return guarded([&]() -> Result<void> {
        MACULA_TRY(const Held<macula_device> on, changing(device));
        MACULA_TRY(const Held<macula_view> of, changing(view));
        if (drawn != nullptr && !isSized(drawn)) return wrongSize(drawn);
        MACULA_TRY(const macula_picture asked, checked(picture));
        return withProgress(progress, [&](Progress& to) { return draw(*on, *of, asked, to, drawn); });
    });
}

}  // extern "C"

}  // namespace macula::c
