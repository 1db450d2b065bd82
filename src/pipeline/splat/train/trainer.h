// Makes a model look like pictures of the same thing, step by step, for as long as one wants.
//
// A step draws one view, compares it with its picture over a random background, and moves every splat that
// showed a little (Kerbl et al. 2023). It begins with small pictures: they cost little, and what is far from
// right is far from right in them too. Which view is next, and over what, is a function of the seed and the
// number of the step, so training that was stopped goes on as if it had not been: see training_state.h.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/splat/draw/rasterizer.h"
#include "pipeline/splat/model/density_control.h"
#include "pipeline/splat/train/loss.h"
#include "pipeline/splat/train/optimizer.h"
#include "pipeline/splat/train/picture_pyramid.h"
#include "pipeline/splat/train/trained_views.h"
#include "pipeline/splat/train/trainer_options.h"
#include "pipeline/splat/train/training_state.h"
#include "pipeline/splat/train/training_view.h"

namespace macula::splat {

struct TrainingReport {
    std::uint64_t steps = 0;  // since the start
    // The means over views with colours, each as it was last drawn.
    double loss = 0.0;  // by weight; 0 before all were drawn
    double l1 = 0.0;    // mean of |render - picture|, as compared; of those that were drawn
    std::uint32_t splats = 0;
};

// Used by one thread at a time, the one that uses the device. Nothing is moved by numbers that are not
// finite, and a step that could not be submitted has moved nothing. When reading back or regrouping fails,
// goBack() makes it whole again; when the device is lost, lastGood() is what is left, and resume(), on
// another one, goes on with it.
class Trainer {
  public:
    // The model must be valid and of degree 0 or 1; usage when an option is out of its range. `lists`: where
    // tiles are sorted, which changes nothing but time.
    static Result<Trainer> create(const std::shared_ptr<gpu::Device>& device, const Splats& model,
                                  const TrainerOptions& options, ListMaker lists = ListMaker::fast);
    // Resumes the training of `state`: the same bits as if it had never stopped, on the same device.
    // inputNotUsable as TrainingState::validate and addView.
    static Result<Trainer> resume(const std::shared_ptr<gpu::Device>& device, const TrainingState& state);

    // From the next step on training is done in another way, and of that degree of colour (0 or 1; new
    // coefficients begin at 0). All that was learnt stays: splats, what the optimiser knows, views, steps,
    // statistics. Room for more splats is made here; there is never less than for those it has. usage as
    // create; outOfMemory, and it goes on as before.
    Result<void> goOnWith(const TrainerOptions& options, int shDegree);

    // Adds a view, which takes part from the next step on. inputNotUsable when the picture is not of the
    // view's size, or has not one finite pixel, or a weight that is not above 0 and at most kMaxViewWeight;
    // outOfMemory when the device cannot hold it, or not what comparing it takes (loss.h). The picture stays
    // on the host as well, and is shared with states.
    Result<void> addView(TrainingView view);
    // Replaces the picture of the view at `index` by a better one, of the same view and size.
    // How far that was from the model when it was drawn last still counts, by the weight of the new one.
    // Fails as addView, and then nothing has changed.
    Result<void> replaceView(std::size_t index, TrainingView view);
    // Drops all views but pictures (ViewKind): stand-ins and outlines, once pictures show the same.
    void forgetStandIns();
    std::size_t viewCount() const { return views_.size(); }
    // The views in the order in which they were added.
    const TrainingView& view(std::size_t index) const { return *views_[index].given; }
    bool wasDrawn(std::size_t index) const { return views_[index].loss >= 0.0; }
    // Mean of |render - picture|, as compared, when it was drawn last; 0 before.
    double lastDifference(std::size_t index) const { return views_[index].l1; }

    // Mean of |render - picture| of a view that it need not have, as compared, over black; nothing is learnt.
    // Fails as addView.
    Result<double> differenceTo(const TrainingView& view);

    // `steps` steps; fewer when `keepGoing` (may be empty), which is asked after each, says no. usage without
    // views. A view for which the device has no room, of pairs most of all, is left out until splats are
    // regrouped or training goes on in another way; outOfMemory when there is room for none.
    Result<TrainingReport> step(std::uint64_t steps, const std::function<bool()>& keepGoing = {});

    // The model as it is now. Waits.
    Result<Splats> snapshot() const;
    // All that resume needs. Waits.
    Result<TrainingState> state() const;
    // A copy of the state, at most TrainerOptions::keepEveryMs and a step old while steps are made, with all
    // views added since; from create or resume on. It is on the host: no loss of the device takes it away.
    const TrainingState& lastGood() const { return lastGood_; }
    // Goes back to lastGood(), with the views that there are: for when a step failed and may have moved a
    // part of what belongs together. Makes nothing new on the device.
    Result<void> goBack();
    TrainingReport report() const;

  private:
    Trainer(std::shared_ptr<gpu::Device> device, TrainerOptions options, Splats like,
            std::shared_ptr<const LossKernels> lossKernels, SplatBuffer parameters, SplatBuffer gradients,
            Rasterizer rasterizer, Optimizer optimizer);

    Result<void> addView(std::shared_ptr<const TrainingView> given);
    Result<void> restore(const TrainingState& state);  // all but views
    Result<void> keep();
    Result<void> oneStep();
    Result<shared::SplatLossResult> stepOf(TrainedView& view);
    Result<bool> tryStep(const PictureLevel& level, Loss& loss, const LossStep& over);
    Result<bool> tryStepTwice(const PictureLevel& level, Loss& loss, const LossStep& over);
    bool isTimeToRegroup() const;
    Result<void> regroupSplats();
    TrainingStage stageNow() const;
    Result<Loss*> lossFor(glm::ivec2 sizePx);

    std::shared_ptr<gpu::Device> device_;
    TrainerOptions options_;
    Splats like_;  // without splats: origin, axes, colours
    std::uint32_t count_ = 0;
    std::uint64_t steps_ = 0;
    std::shared_ptr<const LossKernels> lossKernels_;
    SplatBuffer parameters_;
    SplatBuffer gradients_;
    Rasterizer rasterizer_;
    Optimizer optimizer_;
    TrainedViews views_;
    std::optional<Loss> loss_;  // of as many pixels as the largest picture has
    TrainingState lastGood_;
    std::chrono::steady_clock::time_point keptAt_;
};

}  // namespace macula::splat
