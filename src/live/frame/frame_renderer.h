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
#include "live/frame/scene_keeper.h"
#include "live/frame/scene_names.h"
#include "live/frame/screen.h"
#include "live/frame/traced_pictures.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/instance.h"
#include "pipeline/gpu/recovery.h"
#include "pipeline/hybrid/frame/hybrid_frame.h"
#include "pipeline/hybrid/model/live_model.h"

namespace macula::app {

// Asked between dispatches. Both must be cheap.
struct Interrupts {
    std::function<bool()> newInput;
    std::function<bool()> stopping;
};

// Owns the device and all that is on it. A device that is lost is replaced, and the picture made anew from
// the input; who listens is told, and when it is lost again and again it is left at that.
//
// What comes next is decided by PictureCourse; this does it. Small pictures and those of the model always get
// finished, or the view would never follow a steady hand; all else is given up at once when a new input
// comes.
//
// Used by one thread, the render thread.
class FrameRenderer {
  public:
    // The device is opened, or lent, as told; places add their extensions. `keeper` keeps models between
    // runs; null: nobody does.
    FrameRenderer(gpu::Instance instance, gpu::DeviceOptions device, std::shared_ptr<SceneKeeper> keeper,
                  RenderListener listener);
    ~FrameRenderer();

    void accept(FrameInput input);

    // Whether step() has anything to do before the next input.
    bool hasWork() const;
    // Does at most one pass over the picture. Throws nothing.
    void step(const Interrupts& interrupts);
    // Reports an error from outside of step(), and rests until something changes. Throws nothing.
    void fail(ErrorCode code, const char* message, const char* hint);

    // Afterwards nothing refers to the place of the last input.
    void releaseScreen();

    hybrid::ModelNews modelNews() const;
    // Of the model that learns; nothing while there is none.
    std::optional<hybrid::PeripheralReport> modelReport() const;
    // Where the time of step() and accept() went.
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
    Result<bool> showEstimate(const Interrupts& interrupts);  // whether something else is wanted already
    Result<bool> applyScene(const Interrupts& interrupts);    // whether all of it is there
    Result<void> applyModel();
    void lookForModel();
    bool canHaveModel() const;
    void putModelAway();
    void dropModelAfter(void (hybrid::LiveModel::*keep)());
    Result<void> withoutModel(const Error& error);
    RenderDuty::Work work() const;
    Result<void> takeNext(const Interrupts& interrupts);
    bool isComplete() const;  // the input says all that a picture needs
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
    Result<void> takeModel(ModelTaken& taken);
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
    std::optional<hybrid::HybridFrame> hybrid_;                 // of what the model is of
    Drawing modelOf_;                                           // the one whose name is model_->key()
    std::optional<EstimatedModel> estimate_;                    // goes with the study
    bool estimateHasRoom_ = true;                               // as foveaHasRoom_
    std::optional<Clock::time_point> editShownAt_;  // when the drawing that is wanted was first shown so
    hybrid::Frame lastFrame_;                       // without its pictures
    bool mixesModel_ = false;                       // the last traced picture, as FrameShown::mixesModel
    bool foveaHasRoom_ = true;  // for what one takes beside the model; false: until that changes
    // Models of this volume; outlives the device.
    std::shared_ptr<hybrid::ModelShelf> shelf_;
    std::shared_ptr<SceneKeeper> keeper_;
    std::string lookedFor_;  // the name of the scene that the keeper was last asked for
    SceneNames sceneNames_;

    FrameInput input_;
    // What was brought to the device. The comparison with the input tells what has to be brought next.
    struct Applied {
        std::shared_ptr<const Volume> volume;
        std::shared_ptr<const TransferFunction> transferFunction;
        std::shared_ptr<const trace::LightRig> lights;
        std::optional<std::shared_ptr<const Clip>> clip;                      // none: nobody knows which
        std::optional<std::shared_ptr<const Additions>> additions = nullptr;  // likewise
        VkExtent2D window{};
        std::uint64_t exposures = 0;
    } applied_;
    std::optional<std::uint64_t>
        outlineOf_;  // the study whose outline was reported, for the scene that is applied

    PictureCourse course_;
    RenderDuty duty_;
    HandRhythm rhythm_;
    bool hasLearntBesideHand_ = false;     // since the last input
    std::deque<Clock::time_point> shown_;  // when pictures of one kind were shown lately
    OnScreen shownKind_ = OnScreen::nothing;
    std::uint64_t modelsGiven_ = 0;  // the last wish that was answered
    hybrid::ModelNews modelTold_;
    Clock::time_point modelToldAt_{};
    gpu::LossCount losses_;
    // What the picture that the screen keeps was made of.
    struct Shown {
        Camera camera;
        int width;
        int height;

        bool operator==(const Shown&) const = default;
    };
    std::optional<Shown> kept_;
    std::optional<FrameShown> unreported_;  // of the picture that the screen keeps, while nobody sees it
};

}  // namespace macula::app
