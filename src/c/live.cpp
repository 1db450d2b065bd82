// The live picture, and its model.
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/english.h"
#include "c/camera.h"
#include "c/device.h"
#include "c/handles.h"
#include "c/last_error.h"
#include "c/pixels.h"
#include "c/shared_image.h"
#include "c/sized.h"
#include "c/told_progress.h"
#include "c/view.h"
#include "live/frame/fidelity.h"
#include "live/frame/times_report.h"
#include "live/hosted/hosted_loop.h"
#include "pictures/output_files.h"
#include "scene/choice/catalogue.h"
#include "scene/choice/lights_choice.h"
#include "scene/drawing/drawing_of.h"
#include "scene/drawing/projection_windows.h"

struct macula_live {
    std::unique_ptr<macula::live::HostedLoop> loop;
    // Of the view that is shown.
    std::optional<macula::Camera> camera;
    std::optional<macula::ViewDirection> from = {};
    std::vector<std::string> notesOfView;
    // Of the last frame.
    std::vector<std::string> notes;
    std::string fidelity;
    std::string device;
    std::string times;
    bool isLent = false;    // the device is lent, so images on it can be drawn to
    bool isBroken = false;  // a check failed during a call: its state is unknown
};

namespace macula::c {

namespace {

Error broken() {
    return badArgument(Text("The live picture stopped because of a mistake of Macula itself."),
                       Text("Close it and open it again."));
}

// Calls body(live), which returns a Result<void>; refuses a live picture that is broken.
template <class Body>
macula_status with(macula_live* live, const Body& body) noexcept {
    std::optional<Held<macula_live>> of;
    const macula_status status = guarded([&]() -> Result<void> {
        MACULA_TRY(Held<macula_live> held, changing(live));
        of.emplace(std::move(held));
        if ((*of)->isBroken) return broken();
        return body(**of);
    });
    if (status == MACULA_FAULT && of) (*of)->isBroken = true;
    return status;
}

Result<void> show(macula_live& live, const macula_view& view, Progress& progress) {
    MACULA_TRY(scene::StudyState state, stateOf(view));
    if (!view.lights.empty()) {
        MACULA_TRY(trace::LightRig rig, scene::chooseLightRig(view.lights));
        state.lights = std::make_shared<const trace::LightRig>(std::move(rig));
    }
    MACULA_TRY(SeenView seen, seenBy(view, std::move(state), progress));
    MACULA_TRY(const scene::Catalogue catalogue, scene::builtInCatalogue());
    auto clip = seen.shown.clip.isNothing() ? nullptr : std::make_shared<const Clip>(seen.shown.clip);
    live::HostedScene scene;
    scene.volume = view.study.volume;
    scene.drawing =
        scene::drawingOf(seen.state, catalogue, scene::SeriesWindows(), view.study.volume, std::move(clip));
    MACULA_TRY_VOID(live.loop->show(std::move(scene), progress));
    live.camera = seen.state.camera;
    live.from = view.request.view;
    live.notesOfView = inEnglish(seen.notes);
    return {};
}

Result<live::HostedOptions> optionsOf(const macula_device& device, const macula_live_options& given) {
    if (given.model != MACULA_WITH_MODEL && given.model != MACULA_WITHOUT_MODEL)
        return badArgument(Text("Whether there is to be a model is not known."),
                           Text("Use MACULA_WITH_MODEL or MACULA_WITHOUT_MODEL."));
    live::HostedOptions options;
    options.way = device.way;
    options.usesModel = given.model == MACULA_WITH_MODEL;
    if (given.store != nullptr) options.store = std::filesystem::path(given.store);
    options.storeBytes = given.store_bytes;
    return options;
}

struct AskedFrame {
    macula_frame given;
    live::HostedFrameRequest request;
    std::optional<live::LentPicture> image;
    std::shared_ptr<const gpu::SharedMemory> shared;  // may be null
};

Result<std::optional<live::LentPicture>> imageOf(const macula_lent_image* given) {
    if (given == nullptr) return std::optional<live::LentPicture>();
    MACULA_TRY(const macula_lent_image image, taken(given));
    if (image.image == 0)
        return badArgument(Text("The image that is lent is none."), Text("Give a VkImage."));
    return std::optional(
        live::LentPicture{.image = image.image, .layer = image.layer, .layout = image.layout});
}

Result<std::shared_ptr<const gpu::SharedMemory>> sharedOf(const macula_frame& given) {
    if (given.shared == nullptr) return std::shared_ptr<const gpu::SharedMemory>();
    MACULA_TRY(const Held<const macula_shared_image> shared, reading(given.shared));
    const gpu::SharedMemoryHandles& made = shared->memory->options();
    if (made.width != std::uint32_t(given.width) || made.height != std::uint32_t(given.height))
        return badArgument(Text("The frame and the shared image are not of the same size."),
                           Text("Ask for a frame of the width and height of the image."));
    return shared->memory;
}

Result<AskedFrame> askedOf(const macula_live& live, const macula_frame* frame) {
    if (frame == nullptr) return nullHandle();
    AskedFrame asked;
    MACULA_TRY(asked.given, taken(frame));
    macula_frame& given = asked.given;
    MACULA_TRY_VOID(checkSize(given.width, given.height));
    if (given.rgba != nullptr) {
        MACULA_TRY(given.row_bytes,
                   rowBytesOf({given.rgba, given.bytes, given.row_bytes}, given.width, given.height));
    }
    MACULA_TRY(asked.image, imageOf(given.image));
    MACULA_TRY(asked.shared, sharedOf(given));
    if (asked.image && !live.isLent)
        return badArgument(Text("An image was lent, but no device."),
                           Text("Open the live picture with a device of macula_device_lend."));
    if (!std::isfinite(given.gaze[0]) || !std::isfinite(given.gaze[1]) || !(given.for_about_ms >= 0.0))
        return badArgument(Text("Where the eye looks, or the time for the frame, is no number."),
                           Text("Give finite numbers, the time 0 or above."));
    asked.request.sizePx = {given.width, given.height};
    asked.request.gaze = {given.gaze[0], given.gaze[1]};
    asked.request.isMoving = given.is_moving != 0;
    asked.request.forAboutMs = given.for_about_ms;
    asked.request.camera = live.camera;
    asked.request.from = live.from;
    if (given.camera != nullptr) {
        MACULA_TRY(const macula_camera camera, taken(given.camera));
        MACULA_TRY(asked.request.camera, cameraOf(camera));
    }
    return asked;
}

std::int32_t codeOf(live::OnScreen picture) {
    switch (picture) {
        case live::OnScreen::estimate:
        case live::OnScreen::model:
            return MACULA_SHOWN_MODEL;
        case live::OnScreen::fading:
            return MACULA_SHOWN_FADING;
        case live::OnScreen::traced:
            return MACULA_SHOWN_TRACED;
        case live::OnScreen::preview:
        case live::OnScreen::nothing:
            break;
    }
    return MACULA_SHOWN_SMALL;
}

macula_shown shownOf(const macula_live& live, const live::HostedFrame& frame,
                     const live::Fidelity& fidelity) {
    const live::FrameShown& shown = frame.shown;
    macula_shown told{};
    told.picture = codeOf(shown.picture);
    told.is_final = fidelity.isFinal ? 1 : 0;
    told.is_new = frame.isNew ? 1 : 0;
    told.is_denoised = shown.denoised ? 1 : 0;
    told.scale = shown.scale;
    told.samples_per_pixel = double(shown.samplesPerPixel);
    told.noise = shown.noise;
    told.latency_ms = shown.latencyMs;
    told.fovea_age_ms = shown.foveaAgeMs.value_or(-1.0);
    told.fidelity = live.fidelity.c_str();
    told.device = live.device.c_str();
    told.camera = toldOf(shown.camera);
    return told;
}

// Before anything is reported, so that no report describes a picture that did not arrive.
Result<void> deliver(const macula_live& live, const AskedFrame& asked) {
    live::HostPicture& picture = live.loop->picture();
    if (asked.given.rgba != nullptr)
        MACULA_TRY_VOID(picture.writeTo(asked.given.rgba, asked.given.row_bytes, asked.request.sizePx));
    if (asked.image) MACULA_TRY_VOID(picture.copyTo(*asked.image, asked.request.sizePx));
    if (asked.shared) MACULA_TRY_VOID(picture.shareTo(asked.shared));
    return {};
}

Result<void> drawFrame(macula_live& live, const AskedFrame& asked, Progress& progress, macula_shown* shown) {
    MACULA_TRY(const live::HostedFrame frame, live.loop->frame(asked.request, progress));
    MACULA_TRY_VOID(deliver(live, asked));
    const live::Fidelity fidelity = fidelityOf(frame.shown);
    live.fidelity = Text::joined(fidelity.because, ", ").english();
    live.device = live.loop->deviceName();
    live.notes = live.notesOfView;
    for (const Text& note : live.loop->notes()) live.notes.push_back(note.english());
    if (shown != nullptr) give(shownOf(live, frame, fidelity), shown);
    return {};
}

std::int32_t codeOf(hybrid::ModelStage stage) {
    switch (stage) {
        case hybrid::ModelStage::none:
            return MACULA_MODEL_NONE;
        case hybrid::ModelStage::searching:
            return MACULA_MODEL_SEARCHING;
        case hybrid::ModelStage::resuming:
            return MACULA_MODEL_RESUMING;
        case hybrid::ModelStage::learning:
            return MACULA_MODEL_LEARNING;
        case hybrid::ModelStage::resting:
            return MACULA_MODEL_RESTING;
        case hybrid::ModelStage::nothingToSee:
            return MACULA_MODEL_NOTHING_TO_SEE;
        case hybrid::ModelStage::noRoom:
            return MACULA_MODEL_NO_ROOM;
        case hybrid::ModelStage::failed:
            break;
    }
    return MACULA_MODEL_FAILED;
}

macula_model modelOf(const macula_live& live) {
    const hybrid::ModelNews news = live.loop->model();
    const auto report = live.loop->report();
    const bool isResumed =
        news.origin == hybrid::ModelOrigin::stored || news.origin == hybrid::ModelOrigin::shelf;
    macula_model told{};
    told.stage = codeOf(news.stage);
    told.is_resumed = isResumed ? 1 : 0;
    told.splats = news.splats;
    told.steps = news.steps;
    told.views = news.views;
    told.error = std::numeric_limits<double>::quiet_NaN();
    if (report) {
        told.error = report->error.value_or(told.error);
        told.seconds = report->trainingSeconds;
    }
    told.stage_name = nameOf(news.stage).data();  // literals
    told.origin = describe(news.origin).data();
    return told;
}

Result<live::TrainingRequest> requestOf(const macula_training* training) {
    MACULA_TRY(const macula_training given, taken(training));
    if (!std::isfinite(given.seconds) || given.seconds < 0.0)
        return badArgument(Text("The time for training is not usable."),
                           Text("Give seconds, or 0 for no end."));
    return live::TrainingRequest{.steps = given.steps, .seconds = given.seconds};
}

}  // namespace

extern "C" {

macula_status macula_live_open(const macula_device* device, const macula_view* view,
                               const macula_live_options* options, const macula_progress* progress,
                               macula_live** live) {
    if (live != nullptr) *live = nullptr;
    return guarded([&]() -> Result<void> {
        if (live == nullptr) return nullHandle();
        MACULA_TRY(const Held<const macula_device> on, reading(device));
        MACULA_TRY(const Held<const macula_view> of, reading(view));
        MACULA_TRY(const macula_live_options given, taken(options));
        MACULA_TRY(live::HostedOptions wanted, optionsOf(*on, given));
        return withProgress(progress, [&](Progress& to) -> Result<void> {
            auto made = std::make_unique<macula_live>();
            made->isLent = on->way.device.lent.has_value();
            MACULA_TRY(made->loop, live::HostedLoop::create(std::move(wanted)));
            MACULA_TRY_VOID(show(*made, *of, to));
            *live = opened(std::move(made));
            return {};
        });
    });
}

macula_status macula_live_show(macula_live* live, const macula_view* view, const macula_progress* progress) {
    return with(live, [&](macula_live& of) -> Result<void> {
        MACULA_TRY(const Held<const macula_view> shown, reading(view));
        return withProgress(progress, [&](Progress& to) { return show(of, *shown, to); });
    });
}

macula_status macula_live_frame(macula_live* live, const macula_frame* frame, const macula_progress* progress,
                                macula_shown* shown) {
    return with(live, [&](macula_live& of) -> Result<void> {
        if (shown != nullptr && !isSized(shown)) return wrongSize(shown);
        MACULA_TRY(const AskedFrame asked, askedOf(of, frame));
        return withProgress(progress, [&](Progress& to) { return drawFrame(of, asked, to, shown); });
    });
}

const char* macula_live_note(const macula_live* live, std::uint32_t index) {
    return textAt(
        live, index, [](const macula_live& of) -> const auto& { return of.notes; });
}

macula_status macula_live_times(macula_live* live, const char** json) {
    return with(live, [&](macula_live& of) -> Result<void> {
        if (json == nullptr)
            return badArgument(Text("There is no place for the times."),
                               Text("Give the address of a pointer."));
        of.times = live::toJson(of.loop->timesSpent()).dump();
        *json = of.times.c_str();
        return {};
    });
}

macula_status macula_live_model(const macula_live* live, macula_model* model) {
    return guarded([&]() -> Result<void> {
        MACULA_TRY(const Held<const macula_live> of, reading(live));
        if (of->isBroken) return broken();
        return give(modelOf(*of), model) ? Result<void>() : wrongSize(model);
    });
}

macula_status macula_live_train(macula_live* live, const macula_training* training,
                                const macula_progress* progress, macula_model* model) {
    return with(live, [&](macula_live& of) -> Result<void> {
        if (model != nullptr && !isSized(model)) return wrongSize(model);
        MACULA_TRY(const live::TrainingRequest request, requestOf(training));
        return withProgress(progress, [&](Progress& to) -> Result<void> {
            MACULA_TRY_VOID(of.loop->train(request, to));
            if (model != nullptr) give(modelOf(of), model);
            return {};
        });
    });
}

macula_status macula_live_save(macula_live* live, const macula_progress* progress) {
    return with(live, [&](macula_live& of) -> Result<void> {
        return withProgress(progress, [&](Progress& to) { return of.loop->save(to); });
    });
}

macula_status macula_live_write_model(macula_live* live, const char* path, std::int32_t overwrite,
                                      const macula_progress* progress) {
    return with(live, [&](macula_live& of) -> Result<void> {
        if (path == nullptr || *path == '\0')
            return badArgument(Text("No file was named."),
                               Text("Give a path that ends in .macula, .ply, .spz or .glb."));
        pictures::OutputFiles files(overwrite != 0);
        if (const Result<void> may = files.write(path); !may) {
            Error error = may.error();
            std::error_code unknown;
            // The hint of OutputFiles names an option of the command, which a caller of this does not have.
            if (overwrite == 0 && std::filesystem::exists(path, unknown))
                error.hint = Text("Have it overwritten, or choose another name.");
            return error;
        }
        return withProgress(progress, [&](Progress& to) { return of.loop->writeModel(path, to); });
    });
}

void macula_live_close(macula_live* live) {
    close(live);
}

}  // extern "C"

}  // namespace macula::c
