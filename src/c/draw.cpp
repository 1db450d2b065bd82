#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <utility>

#include "app/choice/lights_choice.h"
#include "app/frame/projection_windows.h"
#include "app/picture/drawn_picture.h"
#include "app/picture/picture_effort.h"
#include "app/state/drawing_of.h"
#include "app/study/shown_clip.h"
#include "c/last_error.h"
#include "c/sized.h"
#include "c/told_progress.h"
#include "c/view.h"
#include "pipeline/gpu/instance.h"
#include "pipeline/gpu/recovery.h"

struct macula_device {
    macula::gpu::LastingDevice lasting;
    // Of devices that were lost and replaced since the last picture was begun.
    std::shared_ptr<std::vector<std::string>> told;
};

namespace macula::c {

namespace {

Result<app::EffortWish> effortWishOf(const macula_picture& picture) {
    app::EffortWish wish;
    if (picture.quality != nullptr) wish.quality = picture.quality;
    if (picture.samples_per_pixel > app::kMostSamplesPerPixel)
        return badArgument("That many samples per pixel cannot be drawn.",
                           fmt::format("Take at most {}.", app::kMostSamplesPerPixel));
    if (picture.samples_per_pixel > 0) wish.samplesPerPixel = picture.samples_per_pixel;
    if (!(picture.most_noise >= 0.0 && picture.most_noise <= 1.0))
        return badArgument("The noise of the picture is no share of black to white.",
                           "Give 0 to 1; 0 leaves it open.");
    wish.error = picture.most_noise;
    if (picture.denoise < MACULA_AS_QUALITY || picture.denoise > MACULA_PLAIN)
        return badArgument("How the picture is denoised is not known.",
                           "Use MACULA_AS_QUALITY, MACULA_DENOISED or MACULA_PLAIN.");
    if (picture.denoise != MACULA_AS_QUALITY) wish.denoise = picture.denoise == MACULA_DENOISED;
    return wish;
}

// With row_bytes as it is meant.
Result<macula_picture> checked(const macula_picture* given) {
    if (given == nullptr) return nullHandle();
    MACULA_TRY(macula_picture picture, taken(given));
    if (picture.width < 1 || picture.height < 1 || picture.width > trace::kMaxPictureSide ||
        picture.height > trace::kMaxPictureSide)
        return badArgument("The picture cannot have that size.",
                           fmt::format("Take 1 to {} pixels for each side.", trace::kMaxPictureSide));
    const std::uint64_t row = 4 * std::uint64_t(picture.width);
    if (picture.row_bytes == 0) picture.row_bytes = row;
    // The last row may end at its last pixel. By division: a product of what the caller gave may overflow.
    const bool hasRoom = picture.rgba != nullptr && picture.row_bytes >= row && picture.bytes >= row &&
                         (picture.bytes - row) / picture.row_bytes >= std::uint64_t(picture.height) - 1;
    if (!hasRoom)
        return badArgument(
            "There is no room for the pixels.",
            fmt::format("Give {} bytes, in rows of {} or more.", row * std::uint64_t(picture.height), row));
    return picture;
}

struct Scene {
    app::PictureRequest request;
    std::string preset;  // what may be told of it
    std::vector<std::string> notes;
};

// All that the view and the picture come to.
Result<Scene> sceneOf(const macula_view& view, const macula_picture& picture, Progress& progress) {
    // Unlike the viewer, a picture shades no ray cast by itself: as `macula render`.
    MACULA_TRY(app::StudyState state, app::stateOf(view.wish, {.settings = {}}));
    MACULA_TRY(const app::EffortWish wish, effortWishOf(picture));
    MACULA_TRY(const app::Effort effort, app::effortOf(wish, state.settings));
    state.settings = effort.settings;
    state.settings.seed = picture.seed;
    state.clip = view.clip;
    app::StudyInput study = view.study;
    MACULA_TRY(app::StudyPreset preset, app::completeState(state, view.wish, study));
    if (view.window) state.windows.at(std::size_t(state.settings.look)) = view.window;
    MACULA_TRY(app::ShownClip shown, app::shownClip(state, *study.volume, progress));

    Scene scene{.request = {}, .preset = std::move(preset.publicName), .notes = std::move(study.notes)};
    scene.notes.insert(scene.notes.end(), shown.notes.begin(), shown.notes.end());
    app::PictureRequest& request = scene.request;
    request.scene.volume = study.volume;
    request.scene.function = std::move(preset.function);
    request.scene.clip = std::move(shown.clip);
    const std::string lights =
        view.lights.empty() ? std::string(app::defaultLightsFor(state.settings.look)) : view.lights;
    MACULA_TRY(request.scene.environment, app::chooseLights(lights));
    request.camera = view.camera;
    request.from = view.wish.view.value_or(request.from);
    request.sizePx = {picture.width, picture.height};
    request.settings = app::settingsOf(state, app::SeriesWindows(), study.volume.get());
    request.samplesPerPixel = effort.samplesPerPixel;
    return scene;
}

macula_camera toldOf(const Camera& camera) {
    macula_camera told{};
    told.size = sizeof told;
    for (int axis = 0; axis < 3; ++axis) {
        told.position_mm[axis] = camera.positionMm[axis];
        told.target_mm[axis] = camera.targetMm[axis];
        told.up[axis] = camera.up[axis];
    }
    told.vertical_fov_deg = camera.verticalFovDeg;
    told.parallel_height_mm = camera.parallelHeightMm;
    return told;
}

void copyRows(const std::vector<std::uint8_t>& rgba, const macula_picture& picture) {
    const std::size_t row = 4 * std::size_t(picture.width);
    for (std::size_t y = 0; y < std::size_t(picture.height); ++y)
        std::memcpy(picture.rgba + y * picture.row_bytes, rgba.data() + y * row, row);
}

Result<void> draw(macula_device& device, macula_view& view, const macula_picture& picture, Progress& progress,
                  macula_drawn* told) {
    MACULA_TRY(Scene scene, sceneOf(view, picture, progress));
    device.told->clear();
    app::DrawnPicture drawn;
    MACULA_TRY_VOID(device.lasting.run([&](const std::shared_ptr<gpu::Device>& on) -> Result<void> {
        MACULA_TRY(drawn, app::drawPicture(on, scene.request, progress));
        return {};
    }));
    for (const app::PictureNote& note : notesOf(drawn, scene.request))
        scene.notes.push_back(note.action.empty() ? note.sentence : note.sentence + " " + note.action);
    scene.notes.insert(scene.notes.end(), device.told->begin(), device.told->end());
    view.notes = std::move(scene.notes);
    view.preset = std::move(scene.preset);
    view.device = drawn.device;
    copyRows(drawn.rgba, picture);
    if (told == nullptr) return {};
    macula_drawn all{};
    all.is_denoised = drawn.statistics.denoised ? 1 : 0;
    all.is_empty = isEmpty(drawn) ? 1 : 0;
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

macula_status macula_device_open(const char* preferred, macula_device** device) {
    if (device != nullptr) *device = nullptr;
    return guarded([&]() -> Result<void> {
        if (device == nullptr) return nullHandle();
        auto told = std::make_shared<std::vector<std::string>>();
        MACULA_TRY(gpu::Instance instance, gpu::Instance::create());
        gpu::DeviceOptions options;
        if (preferred != nullptr) options.preferred = preferred;
        options.isAnnounced = false;
        MACULA_TRY(
            gpu::LastingDevice lasting,
            gpu::LastingDevice::open(std::move(instance), std::move(options),
                                     [told](std::string_view sentence) { told->emplace_back(sentence); }));
        *device = new macula_device{std::move(lasting), std::move(told)};
        return {};
    });
}

void macula_device_close(macula_device* device) {
    delete device;
}

macula_status macula_draw(macula_device* device, macula_view* view, const macula_picture* picture,
                          const macula_progress* progress, macula_drawn* drawn) {
    return guarded([&]() -> Result<void> {
        if (device == nullptr || view == nullptr) return nullHandle();
        if (drawn != nullptr && !isSized(drawn)) return wrongSize();
        MACULA_TRY(const macula_picture asked, checked(picture));
        return withProgress(progress, [&](Progress& to) { return draw(*device, *view, asked, to, drawn); });
    });
}

}  // extern "C"

}  // namespace macula::c
