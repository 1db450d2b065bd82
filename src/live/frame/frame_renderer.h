// Makes pictures out of inputs, in steps short enough to stay responsive.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/timeline.h"
#include "live/frame/applied_scene.h"
#include "live/frame/course_steps.h"
#include "live/frame/frame_input.h"
#include "live/frame/interrupts.h"
#include "live/frame/model_pictures.h"
#include "live/frame/picture_on_screen.h"
#include "live/frame/render_device.h"
#include "live/frame/render_duty.h"
#include "live/frame/render_events.h"
#include "live/frame/render_reports.h"
#include "live/frame/scene_keeper.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/instance.h"

namespace macula::live {

Error noMemoryToShow();  // for FrameRenderer::fail

// Owns the device and everything on it. After a device loss it opens a new device, reports DeviceRestarting
// and renders the input again; after too many losses it reports RenderFailure and stops.
//
// RenderDuty decides what must be done before the course goes on; PictureCourse decides the steps of the
// course, and CourseSteps carries them out.
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
    // Reports an error from outside step(), then rests until the input changes. Throws nothing, whatever
    // `error` throws.
    void fail(Error (*error)());

    // Closes the screen: afterwards nothing refers to the place of the last input.
    void releaseScreen() { screen_.release(); }

    hybrid::ModelNews modelNews() const { return models_.news(); }
    // Report on the current model; nothing while there is none.
    std::optional<hybrid::PeripheralReport> modelReport() const { return models_.report(); }
    // The time that step() and accept() spent, by stage.
    const std::vector<StageTimes>& timesSpent() const { return timeline_.stages(); }

  private:
    void noteOtherRoom(const FrameInput& next);
    void noteDuty(const FrameInput& next);
    void giveModelIfAsked();
    Result<void> giveModel();
    Result<void> tryStep(const Interrupts& interrupts);
    Result<void> ensureDevice();
    Result<bool> applyScene(const Interrupts& interrupts);  // false: interrupted
    RenderDuty::Work work() const;
    void handle(Error error);
    void dropDevice();

    // Destroyed in reverse, after the destructor has closed the screen and put the model away: first the
    // input and the models, then the tracer with the device, and the listener last.
    Timeline timeline_;
    RenderReports reports_;
    RenderDevice device_;
    RenderDuty duty_;
    PictureOnScreen screen_;
    ModelPictures models_;
    FrameInput input_;
    AppliedScene scene_;
    CourseSteps steps_;
    std::uint64_t modelsGiven_ = 0;  // the last request that was answered
};

}  // namespace macula::live
