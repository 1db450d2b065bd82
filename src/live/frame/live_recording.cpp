#include "live/frame/live_recording.h"

#include <chrono>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include "base/check.h"
#include "live/frame/render_thread.h"
#include "pipeline/gpu/transfer.h"
#include "scene/camera/orbit_camera.h"
#include "scene/camera/usual_view.h"

namespace macula::live {

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kHandInterval = std::chrono::milliseconds(16);  // as often as a usual mouse and display

double secondsBetween(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

// The recording so far. The render thread adds pictures and reports, the thread that moves the camera adds
// inputs and waits for pictures.
class Tape {
  public:
    Tape(double picturesPerS, std::uint64_t bytesOfPicture)
        : interval_(std::chrono::duration_cast<Clock::duration>(
              std::chrono::duration<double>(1.0 / std::max(picturesPerS, 1e-6)))),
          mostPictures_(std::max<std::uint64_t>(kEndsOfRests + 1, kMostRecordedBytes / bytesOfPicture) -
                        kEndsOfRests) {}

    // Render thread. The picture comes before the FrameShown that describes it.
    Result<void> take(const gpu::Image& picture) {
        const Clock::time_point now = Clock::now();
        {
            const std::lock_guard lock(mutex_);
            pixels_.clear();
            isSpare_ = lastKept_ && now - *lastKept_ < interval_;
            if (!isSpare_ && kept_ >= mostPictures_) isSpare_ = isFull_ = true;
            // At rest the last picture matters, and any may be the last: keep it until the next comes.
            if (isSpare_ && (inputs_.empty() || inputs_.back().phase == RecordingPhase::moving)) return {};
        }
        MACULA_TRY(std::vector<glm::u8vec4> pixels, gpu::read<glm::u8vec4>(picture));
        const std::lock_guard lock(mutex_);
        pixels_ = std::move(pixels);
        sizePx_ = {int(picture.extent().width), int(picture.extent().height)};
        if (!isSpare_) {
            lastKept_ = now;
            ++kept_;
        }
        return {};
    }
    void add(const FrameShown& shown) {
        const std::lock_guard lock(mutex_);
        if (shown.inputSequence >= inputs_.size() + 1 || shown.inputSequence == 0) return;
        const RecordedInput& input = inputs_[shown.inputSequence - 1];
        const auto endsRest = [&] {
            return input.phase == RecordingPhase::changed && frames_.back().phase != input.phase;
        };
        if (lastIsSpare_ && !endsRest() && !lastBeginsRest()) frames_.back().rgba.clear();
        lastIsSpare_ = isSpare_ && !pixels_.empty();
        frames_.push_back(
            {secondsSinceStart(), input.phase, input.camera, shown, sizePx_, std::exchange(pixels_, {})});
        hasTraced_ = hasTraced_ || shown.picture == OnScreen::traced;
    }
    void setOutline(std::shared_ptr<const std::vector<glm::dvec3>> pointsMm) {
        const std::lock_guard lock(mutex_);
        outlineMm_ = std::move(pointsMm);
    }
    void setDevice(const std::string& name) {
        const std::lock_guard lock(mutex_);
        device_ = name;
    }
    void note(Text what) {
        const std::lock_guard lock(mutex_);
        notices_.push_back({secondsSinceStart(), std::move(what)});
    }
    void spent(std::vector<StageTimes> stages) {
        const std::lock_guard lock(mutex_);
        spent_ = std::move(stages);
    }
    void fail(const Error& error) {
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = error;
    }

    // Thread that moves the camera: before each input is published. Inputs are numbered from 1, without gaps.
    void sends(RecordingPhase phase, const Camera& camera) {
        const std::lock_guard lock(mutex_);
        if (!inputs_.empty() && inputs_.back().phase != phase) endPhase();
        inputs_.push_back({secondsSinceStart(), phase, camera});
    }
    std::optional<Error> failure() const {
        const std::lock_guard lock(mutex_);
        return failure_;
    }
    std::shared_ptr<const std::vector<glm::dvec3>> outlineMm() const {
        const std::lock_guard lock(mutex_);
        return outlineMm_;
    }
    bool hasTraced() const {
        const std::lock_guard lock(mutex_);
        return hasTraced_;
    }
    // Whether the last frame shows the last pose and drawing. It may be from an earlier input: a final
    // picture is not shown again for the same pose.
    bool hasFollowed() const {
        const std::lock_guard lock(mutex_);
        if (frames_.empty() || frames_.back().camera != inputs_.back().camera) return false;
        return inputs_.back().phase != RecordingPhase::changed ||
               frames_.back().phase == RecordingPhase::changed;
    }
    // Ends the recording: frames that are shown later are dropped.
    LiveRecording result() {
        const std::lock_guard lock(mutex_);
        if (!inputs_.empty()) endPhase();
        return {.device = device_,
                .inputs = std::exchange(inputs_, {}),
                .frames = std::exchange(frames_, {}),
                .notices = std::exchange(notices_, {}),
                .times = std::exchange(times_, {}),
                .seconds = secondsSinceStart(),
                .isFull = isFull_};
    }

  private:
    static constexpr std::uint64_t kEndsOfRests =
        4;  // first and last of the rest, and of the changed drawing

    // The first picture of a rest is kept, because later ones are compared with it.
    bool lastBeginsRest() const {
        const RecordingPhase phase = frames_.back().phase;
        if (phase != RecordingPhase::resting && phase != RecordingPhase::changed) return false;
        return frames_.size() == 1 || frames_[frames_.size() - 2].phase != phase;
    }
    void endPhase() {
        const double nowS = secondsSinceStart();
        times_.push_back({inputs_.back().phase, nowS - phaseBeganAtS_, since(spentBefore_, spent_)});
        spentBefore_ = spent_;
        phaseBeganAtS_ = nowS;
    }
    double secondsSinceStart() const { return secondsBetween(start_, Clock::now()); }

    const Clock::time_point start_ = Clock::now();
    const Clock::duration interval_;
    const std::uint64_t mostPictures_;
    mutable std::mutex mutex_;
    std::string device_;
    std::vector<RecordedInput> inputs_;
    std::vector<RecordedFrame> frames_;
    std::vector<RecordedNotice> notices_;
    std::vector<RecordedTimes> times_;     // for phases that have ended
    std::vector<StageTimes> spent_;        // since the start
    std::vector<StageTimes> spentBefore_;  // when this phase began
    double phaseBeganAtS_ = 0.0;
    std::vector<glm::u8vec4> pixels_;  // pixels of the picture whose FrameShown comes next
    glm::ivec2 sizePx_{0};
    std::optional<Clock::time_point> lastKept_;
    std::uint64_t kept_ = 0;
    bool isFull_ = false;
    bool isSpare_ = false;      // pixels_ are kept only until the next picture
    bool lastIsSpare_ = false;  // likewise for the pixels of the last frame
    bool hasTraced_ = false;
    std::shared_ptr<const std::vector<glm::dvec3>> outlineMm_;
    std::optional<Error> failure_;
};

// A screen that is always visible; pictures keep the size in which they were drawn.
class TapeScreen final : public Screen {
  public:
    TapeScreen(std::shared_ptr<Tape> tape, std::shared_ptr<gpu::Device> device)
        : tape_(std::move(tape)), device_(std::move(device)) {}

    Result<void> resize(VkExtent2D) override { return {}; }
    void setText(std::shared_ptr<const PictureText> text) override { text_ = std::move(text); }
    void setMarks(std::shared_ptr<const PictureText> marks) override { marks_ = std::move(marks); }
    const std::shared_ptr<const PictureText>& marks() const override { return marks_; }
    const std::shared_ptr<const PictureText>& text() const override { return text_; }
    Result<bool> show(const gpu::Image& picture) override {
        // A picture counts as shown once the device has drawn it.
        MACULA_TRY_VOID(device_->waitForAll());
        MACULA_TRY_VOID(tape_->take(picture));
        return true;
    }
    Result<bool> showAgain() override { return false; }
    bool owes() const override { return false; }
    void forget() override {}
    Result<bool> showColour(const VkClearColorValue&) override { return true; }

  private:
    std::shared_ptr<Tape> tape_;
    std::shared_ptr<gpu::Device> device_;
    std::shared_ptr<const PictureText> text_;
    std::shared_ptr<const PictureText> marks_;
};

class TapePlace final : public ScreenPlace {
  public:
    explicit TapePlace(std::shared_ptr<Tape> tape) : tape_(std::move(tape)) {}
    std::vector<const char*> deviceExtensions() const override { return {}; }
    Result<std::unique_ptr<Screen>> open(const std::shared_ptr<gpu::Device>& device,
                                         VkExtent2D) const override {
        return std::unique_ptr<Screen>(std::make_unique<TapeScreen>(tape_, device));
    }

  private:
    std::shared_ptr<Tape> tape_;
};

RenderListener listenerOf(const std::shared_ptr<Tape>& tape) {
    return [tape](const RenderEvent& event) {
        if (const auto* frame = std::get_if<FrameShown>(&event)) tape->add(*frame);
        if (const auto* spent = std::get_if<TimeSpent>(&event)) tape->spent(spent->stages);
        if (const auto* ready = std::get_if<DeviceReady>(&event)) tape->setDevice(ready->name);
        if (const auto* outline = std::get_if<OutlineFound>(&event)) tape->setOutline(outline->pointsMm);
        if (const auto* preparing = std::get_if<Preparing>(&event)) tape->note(preparing->what);
        if (std::holds_alternative<PictureRemoved>(event)) tape->note(Text("The picture was removed"));
        if (std::holds_alternative<DeviceRestarting>(event)) tape->note(Text("The device is started again"));
        if (const auto* failure = std::get_if<RenderFailure>(&event)) tape->fail(failure->error);
    };
}

class Recording {
  public:
    Recording(FrameInput scene, const RecordingOptions& options, gpu::Instance instance, Progress& progress)
        : options_(options),
          progress_(progress),
          input_(std::move(scene)),
          tape_(std::make_shared<Tape>(
              options.picturesPerS,
              std::uint64_t(4) * std::uint64_t(options.sizePx.x) * std::uint64_t(options.sizePx.y))),
          thread_(std::move(instance), options.device, options.keeper, listenerOf(tape_)) {
        input_.place = std::make_shared<const TapePlace>(tape_);
        input_.width = options.sizePx.x;
        input_.height = options.sizePx.y;
        input_.visible = true;
        input_.study = 1;
    }

    Result<LiveRecording> run() {
        MACULA_TRY(const scene::CameraPath path, open());
        MACULA_TRY_VOID(move(path));
        MACULA_TRY_VOID(rest(RecordingPhase::resting, path.stops.back().camera));
        if (options_.thenDrawing) {
            input_.drawing = *options_.thenDrawing;
            MACULA_TRY_VOID(rest(RecordingPhase::changed, path.stops.back().camera));
        }
        return tape_->result();
    }

  private:
    void publish(RecordingPhase phase, const Camera& camera) {
        input_.camera = camera;
        input_.interacting = phase == RecordingPhase::moving;
        tape_->sends(phase, camera);
        thread_.publish(input_);
    }

    // Waits until `isDone`, which is called as often as a hand moves.
    template <class IsDone>
    Result<void> wait(const IsDone& isDone) {
        while (!isDone()) {
            if (const auto failure = tape_->failure()) return *failure;
            if (progress_.cancelled())
                return Error{ErrorCode::cancelled, Text("The recording was cancelled."), {}, {}};
            std::this_thread::sleep_for(kHandInterval);
        }
        return {};
    }
    Result<void> waitSeconds(double seconds) {
        const Clock::time_point start = Clock::now();
        return wait([&] { return secondsBetween(start, Clock::now()) >= seconds; });
    }

    Result<scene::CameraPath> open() {
        progress_.beginStage(Text("Opening"), 1);
        scene::CameraPath path;
        if (options_.path) {
            path = *options_.path;
            publish(RecordingPhase::opening, path.stops.front().camera);
        } else {
            // What is visible is known only on the device, so the first view fits the whole volume.
            const double aspect = double(options_.sizePx.x) / double(options_.sizePx.y);
            const auto corners = cornersOf(input_.volume->worldBox());
            scene::OrbitCamera start =
                scene::turnedTo({}, scene::firstDirection(options_.from, *input_.volume));
            start.isParallel = options_.isParallel;
            publish(RecordingPhase::opening, scene::toCamera(scene::fitted(start, corners, aspect)));
            MACULA_TRY_VOID(wait([&] { return tape_->outlineMm() != nullptr; }));
            std::vector<glm::dvec3> outlineMm = *tape_->outlineMm();
            if (outlineMm.empty() || trace::isProjection(input_.drawing.settings.look))
                outlineMm.assign(corners.begin(), corners.end());
            const Camera first = scene::toCamera(scene::fitted(start, outlineMm, aspect));
            path = scene::turntable(first, options_.turnS, options_.movingS);
            publish(RecordingPhase::opening, first);
        }
        MACULA_TRY_VOID(wait([&] { return tape_->hasTraced(); }));
        MACULA_TRY_VOID(waitSeconds(options_.learningS));
        progress_.advance();
        return path;
    }

    Result<void> move(const scene::CameraPath& path) {
        progress_.beginStage(Text("Moving"), 1);
        const Clock::time_point start = Clock::now();
        const auto atS = [&] { return secondsBetween(start, Clock::now()); };
        MACULA_TRY_VOID(wait([&] {
            if (atS() >= path.seconds()) return true;
            publish(RecordingPhase::moving, scene::cameraAt(path, atS()));
            return false;
        }));
        progress_.advance();
        return {};
    }

    Result<void> rest(RecordingPhase phase, const Camera& camera) {
        progress_.beginStage(
            phase == RecordingPhase::changed ? Text("Resting, drawn otherwise") : Text("Resting"), 1);
        publish(phase, camera);
        MACULA_TRY_VOID(waitSeconds(options_.restingS));
        MACULA_TRY_VOID(wait([&] { return tape_->hasFollowed(); }));
        progress_.advance();
        return {};
    }

    const RecordingOptions& options_;
    Progress& progress_;
    FrameInput input_;
    std::shared_ptr<Tape> tape_;
    RenderThread thread_;
};

}  // namespace

std::string_view nameOf(RecordingPhase phase) {
    switch (phase) {
        case RecordingPhase::opening:
            return "opening";
        case RecordingPhase::moving:
            return "moving";
        case RecordingPhase::resting:
            return "resting";
        case RecordingPhase::changed:
            return "changed";
    }
    return {};
}

Result<LiveRecording> recordLive(FrameInput scene, const RecordingOptions& options, Progress& progress) {
    MACULA_CHECK(options.thenDrawing != scene.drawing);  // otherwise no other picture would come
    MACULA_TRY(gpu::Instance instance, gpu::Instance::create());
    Recording recording(std::move(scene), options, std::move(instance), progress);
    return recording.run();
}

}  // namespace macula::live
