// The peripheral models of all phases of a study: learnt one after the other in the background, and drawn
// while phases are played.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "live/frame/frame_input.h"
#include "live/frame/render_device.h"
#include "live/frame/render_reports.h"
#include "live/frame/scene_model.h"
#include "pipeline/hybrid/frame/compositor.h"
#include "pipeline/hybrid/model/drawn_model.h"
#include "pipeline/hybrid/model/live_model.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::live {

// Learns the phases of FrameInput::phases beside the scene on screen, with a tracer of its own, so that two
// volumes are on the device while it works; both are freed when nothing is left to learn. A phase is first
// looked for on the shelf and in the store, and else begins with points: with the splats of a neighbour
// (LiveModel::show) it took more steps until it was fit to be shown, and was mottled
// (docs/measurements/window.md). Names, shelf and keeper are those of `scenes`.
//
// Used by the render thread alone. Methods that learn or draw require a device that is ready.
class PhaseModels {
  public:
    // A phase is learnt once its model is fit to be shown and has taken so many steps, so that phases that
    // follow each other are equally sharp.
    static constexpr std::uint64_t kStepsOfLearnt = 240;

    // What can be drawn of a phase.
    struct Drawable {
        std::shared_ptr<const splat::Splats> splats;
        double gain = 1.0;
        std::uint64_t steps = 0;  // of training
    };

    // All outlive it.
    PhaseModels(RenderDevice& device, RenderReports& reports, SceneModel& scenes)
        : device_(device), reports_(reports), scenes_(scenes) {}

    // What has changed. These put the model that is learnt away; dropDevice() only what is on the host of it.
    void forget();  // another study
    void putAway();
    void dropDevice();
    void roomChanged() { noRoom_ = false; }
    // The scene of that name is to be shown: its model goes back to the shelf, if it is the one being learnt.
    void release(const std::string& name);

    // Whether a phase is left to learn. `onScreen` is the name of the scene whose model learns by itself.
    bool hasWork(const FrameInput& input, const std::string& onScreen);
    void rest();  // frees the device, until there is work
    // A slice of it: asks the store, puts a phase on the device, or trains. Requires hasWork().
    Result<void> work(const FrameInput& input, double budgetMs, const std::function<bool()>& keepGoing);
    // After an error of work(): the phase is not tried again; without memory none is, until roomChanged().
    void giveUp(const FrameInput& input, const Error& error);
    // The model of a scene that was learnt on screen, and is fit to be shown; ignored if it is no phase.
    void note(const FrameInput& input, const std::string& name, Drawable drawable);

    // Whether the phase of the input is learnt.
    bool canDraw(const FrameInput& input);
    // Requires canDraw(). Valid until the next call.
    Result<hybrid::Periphery> periphery(const FrameInput& input);
    void doWithoutDrawing();  // what was drawn last cannot be drawn: forgets it
    hybrid::ModelNews newsOfDrawn() const;

  private:
    enum class Sought { no, inStore, done };
    struct Phase {
        PhaseScene scene;
        std::optional<Drawable> drawable;
        Sought sought = Sought::no;
        bool isLearnt = false;  // `drawable` is there, and good enough
        bool isGivenUp = false;
    };

    void takeWanted(const FrameInput& input);
    std::optional<std::size_t> indexOf(const std::string& name) const;
    std::optional<std::size_t> nextToLearn(const FrameInput& input) const;
    void seek(std::size_t index, const std::function<bool()>& goesOn);
    void takeFound(Phase& phase, const hybrid::StoredModel& found);
    Result<void> begin(std::size_t index);
    Result<void> bringToDevice(const PhaseScene& scene);
    Result<void> learn(double budgetMs, const std::function<bool()>& keepGoing);
    void endLearning();
    void freeDevice();
    void tell(const FrameInput& input);

    RenderDevice& device_;
    RenderReports& reports_;
    SceneModel& scenes_;
    std::shared_ptr<const PhaseScenes> wanted_;  // the input's, which phases_ and names_ are of
    std::uint64_t study_ = 0;
    std::vector<Phase> phases_;
    std::vector<std::string> names_;  // of the scenes of phases_
    std::string onScreen_;
    bool noRoom_ = false;
    std::chrono::steady_clock::time_point soughtSince_{};
    int searches_ = 0;  // of the phase that is sought in the store: an answer may go astray

    // On the device. The model traces the scene of the tracer.
    std::optional<trace::PathTracer> tracer_;
    PhaseScene onDevice_;
    std::optional<hybrid::LiveModel> model_;
    std::optional<std::size_t> learning_;  // index of the phase of model_
    hybrid::DrawnModel drawn_;
    std::uint64_t drawnSteps_ = 0;
    std::string drawnName_;
    PhaseModelsChanged told_;
};

}  // namespace macula::live
