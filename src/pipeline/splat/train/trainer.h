// Trains a model to look like given pictures, step by step, for as long as the caller wants.
//
// A step draws one view, compares it with its picture over a random background, and moves every visible splat
// a little (Kerbl et al. 2023). It begins with small pictures: they cost little, and large errors show in
// them too. The next view and its background are functions of the seed and the number of the step, so that
// training that was stopped continues as if it had not been: see training_state.h.
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
    // Means over views with colours, each as it was when last drawn.
    double loss = 0.0;  // by weight; 0 before all views were drawn
    double l1 = 0.0;    // mean of |render - picture|, as compared, over the drawn views
    std::uint32_t splats = 0;
};

// Used by one thread at a time, the one that uses the device. Numbers that are not finite move nothing, and a
// step that could not be submitted has moved nothing. When reading back or regrouping fails, goBack()
// restores a consistent state; when the device is lost, lastGood() remains, and resume() continues with it on
// another device.
class Trainer {
  public:
    // The model must be valid and of degree 0 or 1; usage when an option is out of its range. `lists`: where
    // tile lists are made, which affects only the time.
    static Result<Trainer> create(const std::shared_ptr<gpu::Device>& device, const Splats& model,
                                  const TrainerOptions& options, ListMaker lists = ListMaker::fast);
    // Resumes the training of `state`: on the same device, with the same bits as if it had never stopped.
    // inputNotUsable as TrainingState::validate and addView.
    static Result<Trainer> resume(const std::shared_ptr<gpu::Device>& device, const TrainingState& state);

    // From the next step on, trains with other options and another degree of colour (0 or 1; new coefficients
    // start at 0). Keeps everything learnt: splats, the optimiser's state, views, steps, statistics. Also
    // makes room for more splats; never for fewer than there are. usage as create; outOfMemory, and then
    // training can continue as before.
    Result<void> goOnWith(const TrainerOptions& options, int shDegree);

    // Adds a view, which takes part from the next step on. inputNotUsable when the picture is not of the
    // view's size, has no finite pixel, or its weight is not above 0 and at most kMaxViewWeight; outOfMemory
    // when the device cannot hold the picture, or the buffers to compare it (loss.h). The picture stays on
    // the host as well, and is shared with states.
    Result<void> addView(TrainingView view);
    // Replaces the picture of the view at `index` by a better one, of the same view and size. Its loss when
    // last drawn still counts, scaled to the new weight. Fails as addView, and then nothing has changed.
    Result<void> replaceView(std::size_t index, TrainingView view);
    // Drops all stand-ins and outlines (ViewKind), once pictures show the same.
    void forgetStandIns();
    std::size_t viewCount() const { return views_.size(); }
    // The views in the order in which they were added.
    const TrainingView& view(std::size_t index) const { return *views_[index].given; }
    bool wasDrawn(std::size_t index) const { return views_[index].loss >= 0.0; }
    // Mean of |render - picture|, as compared, when the view was last drawn; 0 before.
    double lastDifference(std::size_t index) const { return views_[index].l1; }

    // Mean of |render - picture|, as compared, over black, for any view, which need not be one of the
    // trainer's; nothing is learnt. Fails as addView.
    Result<double> differenceTo(const TrainingView& view);

    // Makes `steps` steps, or fewer if `keepGoing` (may be empty), which is called after each, returns false.
    // usage without views. A view for which the device has no room, mostly for its pairs, is left out until
    // splats are regrouped or goOnWith is called; outOfMemory when there is room for no view.
    Result<TrainingReport> step(std::uint64_t steps, const std::function<bool()>& keepGoing = {});

    // The model as it is now. Waits.
    Result<Splats> snapshot() const;
    // Everything that resume needs. Waits.
    Result<TrainingState> state() const;
    // A copy of the state on the host, which no loss of the device can destroy. It exists from create or
    // resume on, has all views added since, and while steps are made is at most TrainerOptions::keepEveryMs
    // and one step old.
    const TrainingState& lastGood() const { return lastGood_; }
    // Goes back to lastGood(), with the current views: for use after a step that failed and may have changed
    // only some of the parts that belong together. Allocates nothing on the device.
    Result<void> goBack();
    TrainingReport report() const;

  private:
    Trainer(std::shared_ptr<gpu::Device> device, TrainerOptions options, Splats like,
            std::shared_ptr<const LossKernels> lossKernels, SplatBuffer parameters, SplatBuffer gradients,
            Rasterizer rasterizer, Optimizer optimizer);

    Result<void> addView(std::shared_ptr<const TrainingView> given);
    Result<void> restore(const TrainingState& state);  // everything except views
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
    Splats like_;  // no splats; has the origin, axes, colour space and low-pass
    std::uint32_t count_ = 0;
    std::uint64_t steps_ = 0;
    std::shared_ptr<const LossKernels> lossKernels_;
    SplatBuffer parameters_;
    SplatBuffer gradients_;
    Rasterizer rasterizer_;
    Optimizer optimizer_;
    TrainedViews views_;
    std::optional<Loss> loss_;  // for as many pixels as the largest picture has
    TrainingState lastGood_;
    std::chrono::steady_clock::time_point keptAt_;
};

}  // namespace macula::splat
