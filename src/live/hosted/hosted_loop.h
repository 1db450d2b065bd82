// The live picture for a program that displays it itself: the window's renderer without a window, run frame
// by frame on the caller's thread. Its peripheral model can be trained, stored and resumed.
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
#include "live/store/study_keeper.h"

namespace macula::live {

struct HostedOptions {
    DeviceWay way;
    bool usesModel = true;
    // Where models are stored between runs, as session::StoreOptions::folder (empty: its default), and their
    // limit, as modelCapBytes (0: its default). Nothing: not stored.
    std::optional<std::filesystem::path> store = {};
    std::uint64_t storeBytes = 0;
};

struct HostedScene {
    std::shared_ptr<const Volume> volume;  // stored16
    scene::Drawing drawing;                // complete
};

struct HostedFrameRequest {
    glm::ivec2 sizePx{0};
    std::optional<Camera> camera = {};       // nothing: fits what is visible, seen from `from`
    std::optional<ViewDirection> from = {};  // nothing: usualView
    glm::dvec2 gaze{0.0};                    // as FrameInput::gaze
    bool isMoving = false;                   // the view moves: stay fast
    // Time for the frame in ms; the first picture of a pose may take longer. 0: a short time slice.
    double forAboutMs = 0.0;
};

struct HostedFrame {
    FrameShown shown;    // describes picture()
    bool isNew = false;  // a picture was shown during this call
};

struct TrainingRequest {
    std::uint64_t steps = 0;  // further steps; 0: no limit
    double seconds = 0.0;     // 0: no limit
};

// Used by one thread at a time. The renderer replaces a lost device, unless it was lent.
class HostedLoop {
  public:
    // Opens the instance alone: the first frame opens the device. Fails as Instance::create.
    static Result<std::unique_ptr<HostedLoop>> create(HostedOptions options);

    HostedLoop(const HostedLoop&) = delete;
    HostedLoop& operator=(const HostedLoop&) = delete;
    ~HostedLoop();  // stores what the model has learnt

    // Sets the scene of the next frames. Waits until the store has looked for its model. `cancelled` restores
    // the previous scene, if there was one.
    Result<void> show(HostedScene scene, Progress& progress);

    // Fails with the renderer's errors, again and again until the input changes; and with `cancelled`.
    Result<HostedFrame> frame(const HostedFrameRequest& request, Progress& progress);
    // The picture of the last frame; none after a failure.
    HostPicture& picture() { return *picture_; }

    // Trains the model of the current scene, until a limit or until its training has nothing left to learn.
    // Fails with usage if the scene can have no model; `cancelled` keeps what was learnt.
    Result<void> train(const TrainingRequest& request, Progress& progress);
    // State of the model last shown or trained.
    hybrid::ModelNews model() const { return renderer_->modelNews(); }
    std::optional<hybrid::PeripheralReport> report() const { return renderer_->modelReport(); }
    const std::vector<StageTimes>& timesSpent() const { return renderer_->timesSpent(); }
    // Stores the model; returns when it is on disk. Fails with usage without a store; with inputNotUsable
    // when nothing is learnt yet; as the store; and with `cancelled`, after which it is still stored later.
    Result<void> save(Progress& progress);
    // Writes the model as a file. Fails as writeModelFile.
    Result<void> writeModel(const std::filesystem::path& path, Progress& progress);

    const std::string& deviceName() const { return device_; }
    // Sentences for the user on events since the last call, and on the current picture.
    std::vector<Text> notes();

  private:
    class Troubles;  // errors of the store

    HostedLoop(HostedOptions options, gpu::Instance instance);
    void hear(RenderEvent event);
    void change(HostedScene scene);
    void publish(const FrameInput& input);
    // Runs the renderer until `isDone`, or until no work is left. `isTimeUp` is called between dispatches.
    Result<void> goOn(const std::function<bool()>& isDone, const std::function<bool()>& isTimeUp,
                      Progress& progress);
    Result<Camera> fittingCamera(FrameInput input, std::optional<ViewDirection> asked, Progress& progress);
    Result<void> waitForStore(Progress& progress, Text stage);
    Result<ModelSnapshot> snapshotModel(bool withTraining);
    Result<void> checkIsStored(std::int64_t sinceMs);
    void note(const Error& error);
    bool hasPicture() const { return shown_ && picture_->isThere(); }

    HostedOptions options_;
    std::shared_ptr<HostPicture> picture_ = std::make_shared<HostPicture>();
    std::shared_ptr<Troubles> troubles_;
    std::shared_ptr<StudyKeeper> keeper_;  // null: no store
    std::unique_ptr<FrameRenderer> renderer_;
    FrameInput input_;
    Progress* progress_ = nullptr;  // while goOn() runs
    bool knowsModel_ = false;       // model() describes the current scene, not the previous one
    std::string device_;
    std::shared_ptr<const std::vector<glm::dvec3>> outlineMm_;  // outline of the scene
    std::optional<FrameShown> shown_;
    std::optional<Error> failure_;  // failure of the current input
    std::optional<ModelSnapshot> taken_;
    std::vector<Text> notes_;
};

}  // namespace macula::live
