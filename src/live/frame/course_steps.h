// Carries out the steps that PictureCourse decides, and shows their pictures.
#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include "base/result.h"
#include "live/frame/frame_input.h"
#include "live/frame/hand_rhythm.h"
#include "live/frame/interrupts.h"
#include "live/frame/model_pictures.h"
#include "live/frame/picture_course.h"
#include "live/frame/picture_on_screen.h"
#include "live/frame/render_device.h"
#include "live/frame/render_duty.h"

namespace macula::live {

// The parts of a renderer that the steps use. All outlive CourseSteps.
struct RendererParts {
    const FrameInput& input;  // the newest
    RenderDevice& device;
    RenderDuty& duty;
    PictureOnScreen& screen;
    ModelPictures& models;
};

// Small pictures and pictures of the model are always finished: otherwise the view would never follow a hand
// that keeps moving. A new input interrupts all other work at once.
//
// Used by the render thread alone. Steps require a device that is ready and an open screen.
class CourseSteps {
  public:
    explicit CourseSteps(const RendererParts& parts)
        : input_(parts.input),
          device_(parts.device),
          duty_(parts.duty),
          screen_(parts.screen),
          models_(parts.models) {}

    // Takes note of every new input: from their rhythm follows how long training may take between two frames.
    void hear(const FrameInput& input);
    // The new input has another drawing.
    void otherDrawing() { editShownAt_.reset(); }
    // The sample limit rose or the noise target fell.
    void goOnTracing() { course_.goOnTracing(); }
    // Frees an estimate that is not needed any more, and updates the facts by which the course decides.
    void tellCourse();

    // Whether the course has a step before the next input.
    bool hasStep() const { return course_.next(Clock::now()) != Step::none; }
    // Does one step.
    Result<void> takeNext(const Interrupts& interrupts);
    // The scene is on the device: starts its course, with its traced picture if there is one already.
    void begin();
    // Shows an estimate of an edited scene while the tracer does not have the scene yet: bringing it there
    // takes long, and can wait until no edit has come for a moment. Returns true if a newer input came
    // meanwhile.
    Result<bool> showEstimate(const Interrupts& interrupts);
    // Shows the splats of a learnt phase, while the tracer has another scene. Returns whether that is all:
    // true while phases are played; false if the scene is to follow, or the input's phase is not learnt.
    Result<bool> showPlayed();
    // Shows the current picture once more, over another background.
    Result<void> showAgain();

  private:
    using Clock = std::chrono::steady_clock;

    bool learnsBesideHand() const;
    bool isQuick() const;
    Result<void> take(Step step, const Interrupts& interrupts);
    Result<void> showModel();
    Result<void> showPreview(const Interrupts& interrupts);
    Result<void> trace(const Interrupts& interrupts);
    Result<void> showTraced();
    Result<void> fade();
    Result<void> search(const Interrupts& interrupts);
    Result<void> learn(const Interrupts& interrupts);
    Result<void> learnBesideHand(const std::function<bool()>& keepGoing);
    Result<void> learnPhases(const Interrupts& interrupts);
    Result<void> withoutSplats(bool isEstimate, const Error& error);
    Result<void> noteWork(const Result<void>& done);
    Result<void> show(const gpu::Image& picture);
    Result<void> addTraced(FrameShown& frame);

    const FrameInput& input_;
    RenderDevice& device_;
    RenderDuty& duty_;
    PictureOnScreen& screen_;
    ModelPictures& models_;
    PictureCourse course_;
    HandRhythm rhythm_;
    bool hasLearntBesideHand_ = false;              // since the last input
    std::optional<Clock::time_point> editShownAt_;  // when an estimate of this drawing was first shown
};

}  // namespace macula::live
