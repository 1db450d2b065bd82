// The live picture of a program that shows it itself: the window's renderer without a window, frame by frame
// on that program's thread, and its peripheral model, which can be taught, kept and resumed.
//
//     loop.show({volume, drawing}, progress);
//     loop.frame({.sizePx = {640, 480}, .camera = camera, .isMoving = true}, progress);
//     loop.picture().writeTo(pixels, 4 * 640, {640, 480});
//     loop.train({.seconds = 10.0}, progress);
//     loop.save(progress);
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/camera.h"
#include "base/progress.h"
#include "base/result.h"
#include "live/frame/frame_input.h"
#include "live/frame/frame_renderer.h"
#include "live/frame/render_events.h"
#include "live/hosted/host_picture.h"
#include "live/hosted/lent_handles.h"
#include "live/store/model_keeper.h"

namespace macula::app {

struct HostedOptions {
    DeviceWay way;
    bool usesModel = true;
    // Where models are kept between runs: session::StoreOptions::folder and modelCapBytes, 0 the usual.
    // Nothing: nowhere.
    std::optional<std::filesystem::path> store = {};
    std::uint64_t storeBytes = 0;
};

struct HostedScene {
    std::shared_ptr<const Volume> volume;  // in 16 bits
    Drawing drawing;                       // complete
};

struct HostedWish {
    glm::ivec2 sizePx{0};
    std::optional<Camera> camera = {};       // nothing: what is seen fills the picture, from `from`
    std::optional<ViewDirection> from = {};  // nothing: usualView
    glm::dvec2 gaze{0.0};                    // as FrameInput
    bool isMoving = false;                   // a hand or a head moves: stay fast
    // How long there is for it; the first picture of a pose may take longer. 0: a slice.
    double forAboutMs = 0.0;
};

struct HostedFrame {
    FrameShown shown;    // what picture() holds
    bool isNew = false;  // shown since the frame before
};

struct TrainingWish {
    std::uint64_t steps = 0;  // so many more; 0: no end
    double seconds = 0.0;     // for so long; 0: no end
};

// Used by one thread at a time. A device that is lost is replaced by the renderer, unless it was lent.
class HostedLoop {
  public:
    // Opens nothing but the instance: the device comes with the first frame. Fails as Instance::create.
    static Result<std::unique_ptr<HostedLoop>> create(HostedOptions options);

    HostedLoop(const HostedLoop&) = delete;
    HostedLoop& operator=(const HostedLoop&) = delete;
    ~HostedLoop();  // what was learnt is kept

    // From now on frames are of that. Waits for what the store knows of it. `cancelled`: of what they were
    // before.
    Result<void> show(HostedScene scene, Progress& progress);

    // Fails with what the renderer fails with, and goes on failing until something changes; `cancelled`.
    Result<HostedFrame> frame(const HostedWish& wish, Progress& progress);
    // Of the last frame; none after a failure.
    HostPicture& picture() { return *picture_; }

    // Teaches the model of what is shown, until an end or until it has learnt what its pictures can teach it.
    // usage where what is shown has none; `cancelled`, and what was learnt stays.
    Result<void> train(const TrainingWish& wish, Progress& progress);
    // Of what was shown or trained last.
    hybrid::ModelNews model() const { return renderer_->modelNews(); }
    std::optional<hybrid::PeripheralReport> report() const { return renderer_->modelReport(); }
    const std::vector<StageTimes>& timesSpent() const { return renderer_->timesSpent(); }
    // To the store, and returns when it is there. usage without one; inputNotUsable when there is nothing to
    // keep yet; fails as the store, and `cancelled`: then it is saved later.
    Result<void> save(Progress& progress);
    // As writeTakenModel.
    Result<void> writeModel(const std::filesystem::path& path, Progress& progress);

    const std::string& deviceName() const { return device_; }
    // What happened since they were asked for last that a person should know, and what there is to know of
    // the picture.
    std::vector<std::string> notes();

  private:
    class Troubles;  // of the store

    HostedLoop(HostedOptions options, gpu::Instance instance);
    void hear(RenderEvent event);
    void change(HostedScene scene);
    void publish(const FrameInput& input);
    // Until it is done, or there is nothing more to do. `isTimeUp` is asked between dispatches.
    Result<void> goOn(const std::function<bool()>& isDone, const std::function<bool()>& isTimeUp,
                      Progress& progress);
    Result<Camera> fittingCamera(FrameInput input, std::optional<ViewDirection> asked, Progress& progress);
    Result<void> waitForStore(Progress& progress, const char* stage);
    Result<ModelTaken> takeModel(bool withTraining);
    Result<void> checkIsStored(std::int64_t sinceMs);
    void note(const Error& error);
    bool hasPicture() const { return shown_ && picture_->isThere(); }

    HostedOptions options_;
    std::shared_ptr<HostPicture> picture_ = std::make_shared<HostPicture>();
    std::shared_ptr<Troubles> troubles_;
    std::shared_ptr<ModelKeeper> keeper_;  // null: no store
    std::unique_ptr<FrameRenderer> renderer_;
    FrameInput input_;
    Progress* progress_ = nullptr;  // while goOn() runs
    bool knowsModel_ = false;       // model() is of what is shown, and not of what was before
    std::string device_;
    std::shared_ptr<const std::vector<glm::dvec3>> outlineMm_;  // of the scene
    std::optional<FrameShown> shown_;
    std::optional<Error> failure_;  // of the input
    std::optional<ModelTaken> taken_;
    std::vector<std::string> notes_;
};

}  // namespace macula::app
