#include "xr/study_in_headset.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>
#include <utility>

#include "pipeline/gpu/recovery.h"
#include "scene/choice/catalogue.h"
#include "scene/drawing/drawing_of.h"
#include "scene/drawing/projection_windows.h"
#include "scene/drawing/shown_clip.h"
#include "study/open/loaded_study.h"
#include "xr/headset.h"

namespace macula::xr {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kListenEvery{20};
constexpr std::chrono::seconds kMostEnding{5};  // for the runtime to end the session
// For the headset's software to restart, or a headset to be plugged in again.
constexpr std::chrono::seconds kMostAway{10};
constexpr std::chrono::milliseconds kLookEvery{250};
constexpr std::uint64_t kShelfBytes = std::uint64_t(1) << 30;

Result<RoomScene> sceneOf(const HeadsetRequest& request, const Hears& note, Progress& progress) {
    MACULA_TRY(scene::StudyState state, pictures::stateOf(request.state));
    MACULA_TRY(const scene::Catalogue catalogue, scene::builtInCatalogue());
    if (!request.lights.empty()) {
        MACULA_TRY(state.lights, scene::findLights(catalogue, request.lights));
    }
    MACULA_TRY(study::LoadedStudy study,
               study::loadStudy(request.path, request.series, progress, 0, request.how));
    study::bringTo16Bits(study);
    MACULA_TRY_VOID(pictures::completeState(state, request.state, study));
    MACULA_TRY(scene::ShownClip shown, scene::shownClip(state, *study.volume, progress));
    for (const auto* sentences : {&study.notes, &shown.notes})
        for (const Text& sentence : *sentences) note(sentence.english());
    RoomScene scene;
    scene.volume = study.volume;
    scene.drawing = scene::drawingOf(
        state, catalogue, scene::SeriesWindows(), study.volume,
        shown.clip.isNothing() ? nullptr : std::make_shared<const Clip>(std::move(shown.clip)));
    return scene;
}

// What survives the loss of a session.
struct Kept {
    RoomScene scene;
    std::shared_ptr<RoomControls> controls;  // made from host and scene
    std::shared_ptr<hybrid::ModelShelf> shelf = std::make_shared<hybrid::ModelShelf>(kShelfBytes);
    std::optional<glm::dmat4> placed;
    HeadsetFigures figures;
    FrameStatistics statistics;
};

Result<std::shared_ptr<Runtime>> runtimeWithHeadset() {
    MACULA_TRY(auto runtime, Runtime::connect());
    MACULA_TRY_VOID(runtime->findHeadset());
    return runtime;
}

// After a loss: waits until the headset is back, the progress is cancelled, or kMostAway has passed.
Result<std::shared_ptr<Runtime>> runtimeAgain(const Progress& progress) {
    const Clock::time_point begun = Clock::now();
    while (true) {
        auto runtime = runtimeWithHeadset();
        const bool mayCome = !runtime && (runtime.error().code == ErrorCode::deviceNotUsable ||
                                          runtime.error().code == ErrorCode::deviceLost);
        if (!mayCome || progress.cancelled() || Clock::now() - begun > kMostAway) return runtime;
        std::this_thread::sleep_for(kLookEvery);
    }
}

// Runs until the wearer, the frame limit or the progress ends it.
Result<void> goOn(Headset& headset, const ShowOptions& request, Kept& kept, const Progress& progress) {
    std::optional<Clock::time_point> asked;
    while (true) {
        const bool isDone = request.frames > 0 && kept.figures.frames >= request.frames;
        if (!asked && (isDone || progress.cancelled())) {
            MACULA_TRY_VOID(headset.requestEnd());
            asked = Clock::now();
        }
        MACULA_TRY(const Headset::Step step, headset.step());
        kept.placed = headset.placed();
        switch (step) {
            case Headset::Step::ended:
                return {};
            case Headset::Step::waiting:
                kept.statistics.pause();
                std::this_thread::sleep_for(kListenEvery);
                break;
            case Headset::Step::empty:
                ++kept.figures.empty;
                [[fallthrough]];
            case Headset::Step::shown:
                if (kept.figures.frames++ >= request.warmUpFrames) kept.statistics.note(headset.times());
                break;
        }
        if (asked && Clock::now() - *asked > kMostEnding) return {};  // destroying the session also ends it
    }
}

Result<void> useOnce(std::shared_ptr<Runtime> runtime, const ShowOptions& request, Kept& kept,
                     const Progress& progress) {
    MACULA_TRY(const HeadsetDevice opened, openDevice(*runtime));
    kept.figures.device = opened.device->info().name;
    MACULA_TRY(RoomView view, RoomView::create(opened.device, kept.scene, kept.shelf));
    const auto show = [&]() -> Result<void> {
        MACULA_TRY(Headset headset,
                   Headset::open(std::move(runtime), opened.device, view, kept.placed,
                                 {.session = {.showsRoom = request.showsRoom}, .eyePx = request.eyePx},
                                 kept.controls));
        ++kept.figures.sessions;
        kept.figures.eyePx = headset.eyePx();
        kept.statistics.pause();
        Result<void> done = goOn(headset, request, kept, progress);
        kept.figures.unsubmitted += headset.session().unsubmitted();
        kept.figures.stepsDown += headset.governor().stepsDown();
        kept.figures.stepsUp += headset.governor().stepsUp();
        return done;
    };
    Result<void> shown = show();
    kept.scene = view.scene();  // includes the cuts
    if (shown)
        view.model().hide();
    else
        view.model().save();
    return shown;
}

}  // namespace

Text textOf(const HeadsetFigures& figures) {
    const double rate = figures.seconds > 0.0 ? double(figures.frames) / figures.seconds : 0.0;
    return Text("{}: {} frames in {:.1f} s, {:.1f} a second; {} without pictures.", figures.headset,
                figures.frames, figures.seconds, rate, figures.empty);
}

std::vector<std::shared_ptr<const TransferFunction>> presetsFor(const scene::Catalogue& catalogue,
                                                                const Volume& volume) {
    std::vector<std::shared_ptr<const TransferFunction>> presets;
    for (const auto& preset : catalogue.presets)
        if (suits(*preset, volume.unit())) presets.push_back(preset);
    return presets;
}

namespace {

Result<HeadsetFigures> showIn(std::shared_ptr<Runtime> runtime, RoomScene scene, RoomHost host,
                              Progress& progress, const ShowOptions& request) {
    const Hears note = host.note;
    const auto say = host.words.say;
    Kept kept;
    kept.figures.headset = runtime->offer().headset;
    kept.figures.runtime = runtime->offer().runtime;
    if (request.showsRoom && !runtime->offer().showsRoom && note)
        note(say(Text("This headset cannot show the room behind the anatomy.")));
    RoomState first;
    first.transferFunction = scene.drawing.transferFunction;
    first.clip = scene.drawing.clip;
    first.quality = scene.quality;
    host.isCalibrated = scene.volume->provenance().isCalibrated;
    kept.controls = std::make_shared<RoomControls>(std::move(host), std::move(first));
    kept.scene = std::move(scene);
    const Clock::time_point begun = Clock::now();
    gpu::LossCount losses;
    while (true) {
        const Result<void> used = useOnce(std::exchange(runtime, nullptr), request, kept, progress);
        kept.figures.times = kept.statistics.figures();
        kept.figures.seconds = std::chrono::duration<double>(Clock::now() - begun).count();
        if (used) return kept.figures;
        if (used.error().code != ErrorCode::deviceLost || !losses.mayGoOn()) return used.error();
        if (progress.cancelled()) return kept.figures;
        if (note) note(say(Text("{} It is begun again.", used.error().message)));
        auto again = runtimeAgain(progress);
        if (!again && progress.cancelled()) return kept.figures;
        if (!again) return again.error();
        runtime = *std::move(again);
    }
}

}  // namespace

Result<HeadsetFigures> showScene(RoomScene scene, RoomHost host, Progress& progress,
                                 const ShowOptions& request) {
    MACULA_TRY(std::shared_ptr<Runtime> runtime, runtimeWithHeadset());
    return showIn(std::move(runtime), std::move(scene), std::move(host), progress, request);
}

Result<HeadsetFigures> showStudy(const HeadsetRequest& request, const Hears& note, Progress& progress) {
    MACULA_TRY(std::shared_ptr<Runtime> runtime, runtimeWithHeadset());
    MACULA_TRY(RoomScene scene, sceneOf(request, note, progress));
    MACULA_TRY(const scene::Catalogue catalogue, scene::builtInCatalogue());
    RoomHost host;
    host.presets = presetsFor(catalogue, *scene.volume);
    host.pictures = request.pictures;
    host.note = note;
    MACULA_TRY(const HeadsetFigures figures,
               showIn(std::move(runtime), std::move(scene), std::move(host), progress, request.show));
    if (progress.cancelled())
        return Error{
            ErrorCode::cancelled, Text("Stopped."), "",
            request.pictures.empty() ? Text("Nothing was written.") : Text("Pictures that were taken stay.")};
    return figures;
}

}  // namespace macula::xr
