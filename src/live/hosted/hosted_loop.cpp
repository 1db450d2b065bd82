#include "live/hosted/hosted_loop.h"

#include <algorithm>
#include <exception>
#include <future>
#include <mutex>
#include <thread>
#include <utility>

#include "live/frame/traced_pictures.h"
#include "live/model/model_output.h"
#include "live/model/model_to_write.h"
#include "live/store/model_key_of_drawing.h"
#include "scene/camera/orbit_camera.h"
#include "scene/camera/usual_view.h"
#include "scene/choice/lights_choice.h"
#include "scene/state/study_state.h"
#include "scene/transfer/same_transfer.h"

namespace macula::live {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLeastMs = 15.0;  // a frame makes some progress, however little time it has
constexpr double kUsualFovDeg = 30.0;
constexpr int kTrainingSidePx = 256;  // a picture is drawn during training, but nobody sees it
constexpr std::size_t kTrainingTicks = 1000;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

Error stopped(Text sentence) {
    return {ErrorCode::cancelled, std::move(sentence), {}, {}};
}

// Whether the model will not change any more.
bool hasEnded(hybrid::ModelStage stage) {
    using hybrid::ModelStage;
    return stage == ModelStage::resting || stage == ModelStage::nothingToSee || stage == ModelStage::noRoom ||
           stage == ModelStage::failed;
}

// Fails if the drawing can have no model.
Result<void> checkHasModel(const scene::Drawing& drawing) {
    if (!trace::isPathTraced(drawing.settings.look))
        return Error{ErrorCode::usage,
                     Text("Only what is path-traced has a peripheral model."),
                     {},
                     Text("Choose the look cinematic or clear.")};
    return scene::checkPatientLights(trace::Environment::fromRig(*drawing.lights), {});
}

// The renderer compares parts of a scene by address: equal parts take the address from before, so that they
// stay on the device, and so does the model.
void keepWhatIsSame(scene::Drawing& drawing, const scene::Drawing& before) {
    const auto isSameClip = [](const std::shared_ptr<const Clip>& a, const std::shared_ptr<const Clip>& b) {
        return a && b ? *a == *b : a == b;
    };
    if (scene::isSame(*drawing.transferFunction, *before.transferFunction))
        drawing.transferFunction = before.transferFunction;
    if (*drawing.lights == *before.lights) drawing.lights = before.lights;
    if (isSameClip(drawing.clip, before.clip)) drawing.clip = before.clip;
}

std::int64_t nowMs() {
    return std::chrono::duration_cast<std::chrono::milliseconds>(
               std::chrono::system_clock::now().time_since_epoch())
        .count();
}

Result<void> whatBecameOf(const hybrid::ModelNews& news) {
    using hybrid::ModelStage;
    switch (news.stage) {
        case ModelStage::nothingToSee:
            return Error{ErrorCode::inputNotUsable,
                         Text("There is nothing to be seen that a model could learn."),
                         {},
                         Text("Choose another preset or clip.")};
        case ModelStage::noRoom:
            return Error{ErrorCode::outOfMemory,
                         Text("The graphics device has no memory for a model."),
                         {},
                         Text("Close other programs, or show less of the volume.")};
        case ModelStage::failed:
            return Error{ErrorCode::deviceNotUsable,
                         Text("The model could not be made on this graphics device."),
                         {},
                         Text("Try another device.")};
        default:
            return {};
    }
}

}  // namespace

// Collects the errors that the keeper reports on its thread.
class HostedLoop::Troubles {
  public:
    void add(const Error& error) {
        const std::lock_guard lock(mutex_);
        errors_.push_back(error);
    }
    std::vector<Error> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(errors_, {});
    }

  private:
    mutable std::mutex mutex_;
    std::vector<Error> errors_;
};

Result<std::unique_ptr<HostedLoop>> HostedLoop::create(HostedOptions options) {
    MACULA_TRY(gpu::Instance instance, gpu::Instance::create(options.way.instance));
    return std::unique_ptr<HostedLoop>(new HostedLoop(std::move(options), std::move(instance)));
}

HostedLoop::HostedLoop(HostedOptions options, gpu::Instance instance)
    : options_(std::move(options)), troubles_(std::make_shared<Troubles>()) {
    if (options_.store && options_.usesModel) {
        session::StoreOptions store;
        if (!options_.store->empty()) store.folder = *options_.store;
        if (options_.storeBytes > 0) store.modelCapBytes = options_.storeBytes;
        keeper_ = std::make_shared<StudyKeeper>(
            std::move(store), [troubles = troubles_](const Error& error) { troubles->add(error); });
    }
    renderer_ = std::make_unique<FrameRenderer>(std::move(instance), options_.way.device, keeper_,
                                                [this](RenderEvent event) { hear(std::move(event)); });
    input_.place = placeOf(picture_);
    input_.visible = true;
    input_.usesModel = options_.usesModel;
}

HostedLoop::~HostedLoop() {
    renderer_.reset();  // it may report and store until it is destroyed
}

void HostedLoop::hear(RenderEvent event) {
    if (auto* ready = std::get_if<DeviceReady>(&event)) device_ = ready->description;
    if (auto* outline = std::get_if<OutlineFound>(&event)) outlineMm_ = outline->pointsMm;
    if (auto* shown = std::get_if<FrameShown>(&event)) {
        shown_ = std::move(*shown);
        knowsModel_ = true;
    }
    if (std::holds_alternative<PictureRemoved>(event)) shown_.reset();
    if (auto* taken = std::get_if<ModelSnapshot>(&event)) taken_ = std::move(*taken);
    if (auto* failure = std::get_if<RenderFailure>(&event)) failure_ = failure->error;
    if (std::holds_alternative<DeviceRestarting>(event))
        notes_.push_back(Text("The graphics device stopped responding and was started again."));
    if (auto* preparing = std::get_if<Preparing>(&event); preparing && progress_)
        progress_->beginStage(preparing->what, 1);
}

void HostedLoop::publish(const FrameInput& input) {
    if (!isSamePicture(input_, input)) {
        shown_.reset();
        failure_.reset();
    }
    input_ = input;
    ++input_.sequence;
    input_.published = Clock::now();
    renderer_->accept(input_);
}

Result<void> HostedLoop::goOn(const std::function<bool()>& isDone, const std::function<bool()>& isTimeUp,
                              Progress& progress) {
    // Reports what the renderer prepares to this caller, while it works for them.
    struct Told {
        Told(Progress*& place, Progress& told) : place_(place) { place_ = &told; }
        Told(const Told&) = delete;
        Told& operator=(const Told&) = delete;
        ~Told() { place_ = nullptr; }
        Progress*& place_;
    } const told(progress_, progress);
    const Interrupts interrupts{.newInput = isTimeUp, .stopping = [&] { return progress.cancelled(); }};
    while (true) {
        if (failure_) return *failure_;
        if (progress.cancelled()) return stopped(Text("Stopped."));
        if (isDone() || !renderer_->hasWork()) return {};
        renderer_->step(interrupts);
    }
}

Result<void> HostedLoop::waitForStore(Progress& progress, Text stage) {
    if (!keeper_) return {};
    progress.beginStage(std::move(stage), 1);
    while (!keeper_->isIdle()) {
        if (progress.cancelled()) return stopped(Text("Stopped while stored sessions were waited for."));
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    progress.advance();
    return {};
}

Result<void> HostedLoop::show(HostedScene scene, Progress& progress) {
    MACULA_CHECK(scene.volume && scene.drawing.transferFunction && scene.drawing.lights);
    HostedScene before{.volume = input_.volume, .drawing = input_.drawing};
    change(std::move(scene));
    Result<void> waited = waitForStore(progress, Text("Looking for a stored model"));
    if (!waited && before.volume) change(std::move(before));
    return waited;
}

void HostedLoop::change(HostedScene scene) {
    FrameInput input = input_;
    const bool isOther = scene.volume != input.volume;
    if (isOther) ++input.study;
    if (!isOther) keepWhatIsSame(scene.drawing, input.drawing);
    // The outline depends on these; the renderer finds it again when it applies the scene.
    if (isOther || scene.drawing.transferFunction != input.drawing.transferFunction ||
        scene.drawing.clip != input.drawing.clip)
        outlineMm_.reset();
    if (isOther || scene.drawing != input.drawing) knowsModel_ = false;
    input.volume = std::move(scene.volume);
    input.drawing = std::move(scene.drawing);
    input.background = scene::backgroundInWindow(input.drawing);
    publish(input);
}

Result<Camera> HostedLoop::fittingCamera(FrameInput input, std::optional<ViewDirection> asked,
                                         Progress& progress) {
    const ViewDirection from = scene::firstDirection(asked, *input.volume);
    const auto corners = cornersOf(input.volume->worldBox());
    const double aspect = double(input.width) / double(input.height);
    if (!outlineMm_) {
        input.camera = scene::toCamera(scene::framed(corners, from, kUsualFovDeg, aspect));
        publish(input);
        // The renderer reports the outline once for each scene that it brings to the device.
        MACULA_TRY_VOID(goOn([this] { return outlineMm_ != nullptr; }, [] { return false; }, progress));
    }
    const bool fitsAll =
        !outlineMm_ || outlineMm_->empty() || trace::isProjection(input.drawing.settings.look);
    return scene::toCamera(fitsAll ? scene::framed(corners, from, kUsualFovDeg, aspect)
                                   : scene::framed(*outlineMm_, from, kUsualFovDeg, aspect));
}

Result<HostedFrame> HostedLoop::frame(const HostedFrameRequest& request, Progress& progress) {
    MACULA_CHECK(input_.volume && request.sizePx.x > 0 && request.sizePx.y > 0);
    const Clock::time_point start = Clock::now();
    const std::uint64_t before = picture_->count();
    FrameInput input = input_;
    input.width = request.sizePx.x;
    input.height = request.sizePx.y;
    input.gaze = request.gaze;
    input.interacting = request.isMoving;
    input.sampleLimit = FrameInput().sampleLimit;
    if (request.camera) {
        input.camera = *request.camera;
    } else {
        MACULA_TRY(input.camera, fittingCamera(input, request.from, progress));
    }
    MACULA_TRY_VOID(basis(input.camera));
    publish(input);
    const double mostMs = std::max(request.forAboutMs, kLeastMs);
    const auto isTimeUp = [&] { return millisecondsSince(start) >= mostMs; };
    MACULA_TRY_VOID(goOn([&] { return hasPicture() && isTimeUp(); }, isTimeUp, progress));
    if (!hasPicture())
        return Error{ErrorCode::deviceNotUsable,
                     Text("There is no picture of this."),
                     {},
                     Text("Draw it again; if that does not help, open another device.")};
    return HostedFrame{.shown = *shown_, .isNew = picture_->count() != before};
}

Result<void> HostedLoop::train(const TrainingRequest& request, Progress& progress) {
    MACULA_CHECK(input_.volume != nullptr);
    if (!options_.usesModel)
        return Error{
            ErrorCode::usage, Text("This was opened without a model."), {}, Text("Open it with one.")};
    MACULA_TRY_VOID(checkHasModel(input_.drawing));
    const Clock::time_point start = Clock::now();
    FrameInput input = input_;
    input.width = input.height = kTrainingSidePx;
    input.interacting = false;
    // With one sample, the rest of the time is for the model.
    input.sampleLimit = 1;
    MACULA_TRY(input.camera, fittingCamera(input, ViewDirection::anterior, progress));
    publish(input);

    progress.beginStage(Text("Training"), kTrainingTicks);
    std::size_t ticks = 0;
    const auto advanceTo = [&](double share) {
        const auto wanted = std::size_t(std::clamp(share, 0.0, 1.0) * double(kTrainingTicks));
        if (wanted > ticks) progress.advance(wanted - std::exchange(ticks, std::max(ticks, wanted)));
    };
    std::optional<std::uint64_t> firstStep;
    const auto isSpent = [&] {
        return request.seconds > 0.0 && millisecondsSince(start) >= 1000.0 * request.seconds;
    };
    const auto isDone = [&] {
        if (!knowsModel_) return isSpent();
        const hybrid::ModelNews news = model();
        const bool learns = news.stage == hybrid::ModelStage::learning || hasEnded(news.stage);
        const bool isResumed =
            news.origin == hybrid::ModelOrigin::stored || news.origin == hybrid::ModelOrigin::shelf;
        if (!firstStep && learns) firstStep = isResumed ? news.steps : 0;
        const std::uint64_t made = news.steps - std::min(news.steps, firstStep.value_or(news.steps));
        double share = request.seconds > 0.0 ? millisecondsSince(start) / (1000.0 * request.seconds) : 0.0;
        if (request.steps > 0) share = std::max(share, double(made) / double(request.steps));
        advanceTo(share);
        return hasEnded(news.stage) || isSpent() || (request.steps > 0 && made >= request.steps);
    };
    // For a model that is learning already, only further steps count.
    if (knowsModel_ && model().stage == hybrid::ModelStage::learning) firstStep = model().steps;
    MACULA_TRY_VOID(goOn(isDone, isSpent, progress));
    advanceTo(1.0);
    return whatBecameOf(model());
}

Result<ModelSnapshot> HostedLoop::snapshotModel(bool withTraining) {
    FrameInput input = input_;
    if (isParallel(input.camera)) input.camera = inPerspective(input.camera);  // models need perspective
    ++input.modelRequests;
    input.requestsTraining = withTraining;
    taken_.reset();
    publish(input);
    if (!taken_ || (!taken_->error && !taken_->splats))
        return Error{ErrorCode::inputNotUsable,
                     Text("There is no model of what is shown yet."),
                     {},
                     Text("Train it first.")};
    ModelSnapshot taken = *std::exchange(taken_, std::nullopt);
    if (taken.error) return *taken.error;
    return taken;
}

Result<void> HostedLoop::save(Progress& progress) {
    if (!keeper_)
        return Error{
            ErrorCode::usage, Text("No folder was given to keep models in."), {}, Text("Open it with one.")};
    MACULA_TRY(const ModelSnapshot taken, snapshotModel(true));
    if (!taken.state)
        return Error{ErrorCode::inputNotUsable,
                     Text("The model has learnt nothing yet that could be kept."),
                     {},
                     Text("Train it first.")};
    for (const Error& error : troubles_->take()) note(error);  // errors from before this call
    const std::int64_t begunMs = nowMs();
    keeper_->keep(taken.state);
    MACULA_TRY_VOID(waitForStore(progress, Text("Saving the model")));
    MACULA_TRY_VOID(checkIsStored(begunMs));
    return {};
}

// Asks the store itself: the keeper reports each error only once, and says nothing if it does not replace a
// model.
Result<void> HostedLoop::checkIsStored(std::int64_t sinceMs) {
    const std::vector<Error> troubles = troubles_->take();
    if (!troubles.empty()) return troubles.front();
    PartDigests& known = keeper_->digests();
    const session::ModelKey key = modelKeyOf(known.of(input_.volume), *input_.volume, input_.drawing, known);
    const auto asked = std::make_shared<std::promise<Result<void>>>();
    std::future<Result<void>> answer = asked->get_future();
    keeper_->withStore([asked, key, sinceMs](session::Store* store) {
        const auto look = [&]() -> Result<void> {
            if (store != nullptr) {
                MACULA_TRY(const std::optional<session::ModelInfo> found, store->findModel(key));
                if (found && found->savedMs >= sinceMs) return {};
                if (found)
                    return Error{
                        ErrorCode::outputNotWritable,
                        Text("The stored model was not replaced: it has learnt more than this one, or "
                             "could not be written."),
                        {},
                        Text("Train this one for longer, or check free space and permissions.")};
            }
            return Error{ErrorCode::outputNotWritable,
                         Text("The model could not be kept."),
                         {},
                         Text("Check free space and permissions of the folder that was given for models.")};
        };
        try {
            asked->set_value(look());
        } catch (...) {
            asked->set_exception(std::current_exception());  // answer.get() throws it
        }
    });
    return answer.get();
}

Result<void> HostedLoop::writeModel(const std::filesystem::path& path, Progress& progress) {
    MACULA_TRY_VOID(checkModelName(path));
    MACULA_TRY(ModelSnapshot taken, snapshotModel(holdsTraining(path)));
    const ModelToWrite model{.splats = std::move(taken.splats),
                             .gain = taken.gain,
                             .state = std::move(taken.state),
                             .volume = input_.volume,
                             .drawing = input_.drawing};
    MACULA_TRY([[maybe_unused]] const std::size_t limited, writeModelFile(path, model, false, progress));
    return {};
}

void HostedLoop::note(const Error& error) {
    notes_.push_back(Text::joined({error.message, error.hint}, " "));
}

std::vector<Text> HostedLoop::notes() {
    for (const Error& error : troubles_->take()) note(error);
    std::vector<Text> notes = std::exchange(notes_, {});
    if (!shown_) return notes;
    for (const Message& message : shown_->messages)
        notes.push_back(Text::joined({message.sentence, message.action}, " "));
    return notes;
}

}  // namespace macula::live
