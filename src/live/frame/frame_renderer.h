// Makes pictures out of inputs, in steps short enough to stay responsive.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/timeline.h"
#include "live/frame/estimated_model.h"
#include "live/frame/frame_input.h"
#include "live/frame/hand_rhythm.h"
#include "live/frame/picture_course.h"
#include "live/frame/render_duty.h"
#include "live/frame/render_events.h"
#include "live/frame/scene_ids.h"
#include "live/frame/scene_keeper.h"
#include "live/frame/screen.h"
#include "live/frame/traced_pictures.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/instance.h"
#include "pipeline/gpu/recovery.h"
#include "pipeline/hybrid/frame/hybrid_frame.h"
#include "pipeline/hybrid/model/live_model.h"

namespace macula::live {

// Asked between dispatches. Both must be cheap.
struct Interrupts {
    std::function<bool()> newInput;
    std::function<bool()> stopping;
};

// Owns the device and everything on it. After a device loss it opens a new device, reports DeviceRestarting
// and renders the input anew; after too many losses it reports RenderFailure and stops.
//
// PictureCourse decides the next step, and this class carries it out. Small pictures and those of the model
// are always finished, or the view would never follow a steady hand; a new input interrupts all other work at
// once.
//
// Used by the render thread alone.
class FrameRenderer {
  public:
    // `device` says which device to open, or lends one; the input's place adds its extensions. `keeper`
    // stores models between runs; null: none are stored.
    FrameRenderer(gpu::Instance instance, gpu::DeviceOptions device, std::shared_ptr<SceneKeeper> keeper,
                  RenderListener listener);
    ~FrameRenderer();

    void accept(FrameInput input);

    // Whether step() has work before the next input.
    bool hasWork() const;
    // Does at most one step of the course. Throws nothing.
    void step(const Interrupts& interrupts);
    // Reports an error from outside step(), then rests until the input changes. Throws nothing.
    void fail(ErrorCode code, const char* message, const char* hint);

    // Closes the screen: afterwards nothing refers to the place of the last input.
    void releaseScreen();

    hybrid::ModelNews modelNews() const;
    // Report on the current model; nothing while there is none.
    std::optional<hybrid::PeripheralReport> modelReport() const;
    // The time that step() and accept() spent, by stage.
    const std::vector<StageTimes>& timesSpent() const { return timeline_.stages(); }

  private:
    using Clock = std::chrono::steady_clock;

    Result<void> tryStep(const Interrupts& interrupts);
    Result<void> ensureDevice();
    Result<void> ensureScreen();
    Result<void> closeScreen();
    Result<void> clearWindow();
    void noteLearnt();
    Result<void> makeEstimate();
    Result<void> withoutEstimate(const Error& error);
    Result<bool> showEstimate(const Interrupts& interrupts);  // true: a newer input has come
    Result<bool> applyScene(const Interrupts& interrupts);    // false: interrupted
    Result<void> applyModel();
    void lookForModel();
    bool canHaveModel() const;
    void putModelAway();
    void dropModelAfter(void (hybrid::LiveModel::*keep)());
    Result<void> withoutModel(const Error& error);
    RenderDuty::Work work() const;
    Result<void> takeNext(const Interrupts& interrupts);
    bool isComplete() const;  // the input has all that a picture needs
    void tellCourse();
    Result<void> take(Step step, const Interrupts& interrupts);
    Result<void> showModel();
    Result<void> showPreview(const Interrupts& interrupts);
    Result<void> trace(const Interrupts& interrupts);
    Result<void> showTraced();
    Result<void> fade();
    Result<void> search(const Interrupts& interrupts);
    Result<void> workOnModel(const std::function<Result<void>()>& work);
    Result<void> learnBesideHand(const std::function<bool()>& keepGoing);
    bool learnsBesideHand() const;
    bool isQuick();
    Result<void> learn(const Interrupts& interrupts);
    Result<void> showAgain();
    bool canDrawModel() const { return hybrid_ && model_ && model_->canBeDrawn(); }
    bool drawsEstimate() const;
    bool hasOtherMarks() const;
    Result<const gpu::Image*> frame(float tracedShare);
    Result<const gpu::Image*> tracedPicture();
    bool hasFitModel() const;
    double foveaMsPerSample() const;
    bool wantsFovea() const;
    hybrid::FoveaAim nextFovea() const;
    Result<bool> traceFovea(const Interrupts& interrupts);
    Result<void> keepForMotion();
    void doWithoutFovea();
    Result<void> show(const gpu::Image& picture);
    void tellOfModel();
    void tellOfTime();
    Result<void> giveModel();
    Result<void> snapshotModel(ModelSnapshot& taken);
    void handle(Error error);
    void dropDevice();
    double framesPerSecond() const;

    Timeline timeline_;
    Clock::time_point timeToldAt_{};
    gpu::Instance instance_;
    gpu::DeviceOptions deviceOptions_;
    RenderListener listener_;

    std::shared_ptr<gpu::Device> device_;
    std::unique_ptr<Screen> screen_;
    std::optional<TracedPictures> traced_;
    std::optional<hybrid::LiveModel> model_;
    hybrid::ModelStage whyNoModel_ = hybrid::ModelStage::none;  // why model_ is empty
    std::optional<hybrid::HybridFrame> hybrid_;                 // draws the model with its fovea
    scene::Drawing modelOf_;                                    // the drawing that model_->key() names
    std::optional<EstimatedModel> estimate_;                    // reset when the study or volume changes
    bool estimateHasRoom_ = true;                               // like foveaHasRoom_
    std::optional<Clock::time_point> editShownAt_;  // when an estimate of this drawing was first shown
    hybrid::Frame lastFrame_;                       // its data; not its pictures
    bool mixesModel_ = false;                       // FrameShown::mixesModel of the last traced picture
    bool foveaHasRoom_ = true;  // false: no memory for a fovea until the scene or size changes
    // Models of this volume; outlives the device.
    std::shared_ptr<hybrid::ModelShelf> shelf_;
    std::shared_ptr<SceneKeeper> keeper_;
    std::string lookedFor_;  // the scene name last passed to the keeper
    SceneIds sceneNames_;

    FrameInput input_;
    // The scene on the device. Comparing it with the input shows what to upload next.
    struct Applied {
        std::shared_ptr<const Volume> volume;
        std::shared_ptr<const TransferFunction> transferFunction;
        std::shared_ptr<const trace::LightRig> lights;
        std::optional<std::shared_ptr<const Clip>> clip;                      // none: unknown
        std::optional<std::shared_ptr<const Additions>> additions = nullptr;  // none: unknown
        VkExtent2D window{};
        std::uint64_t exposures = 0;
    } applied_;
    std::optional<std::uint64_t>
        outlineOf_;  // the study whose outline was reported for the scene that is applied

    PictureCourse course_;
    RenderDuty duty_;
    HandRhythm rhythm_;
    bool hasLearntBesideHand_ = false;     // since the last input
    std::deque<Clock::time_point> shown_;  // recent times at which shownKind_ was shown
    OnScreen shownKind_ = OnScreen::nothing;
    std::uint64_t modelsGiven_ = 0;  // the last request that was answered
    hybrid::ModelNews modelTold_;
    Clock::time_point modelToldAt_{};
    gpu::LossCount losses_;
    // The view of the picture that the screen keeps.
    struct Shown {
        Camera camera;
        int width;
        int height;

        bool operator==(const Shown&) const = default;
    };
    std::optional<Shown> kept_;
    std::optional<FrameShown> unreported_;  // for the kept picture, until it is visible
};

}  // namespace macula::live
