// A peripheral model that decides for itself how long to learn, and from where it needs another view; it
// takes any picture that it is offered. The owner has the device and the tracer, and calls in turn:
//
//     model.step(20.0);                                // does nothing while it is paused
//     draw(model.shown());                             // a copy on the host, which outlives a lost device
//     if (wanted = model.wantedView()) model.offer(traced(wanted->camera));
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/light/traced_view.h"
#include "pipeline/hybrid/model/error_trend.h"
#include "pipeline/hybrid/model/held_out_pictures.h"
#include "pipeline/hybrid/model/model_start.h"
#include "pipeline/hybrid/model/peripheral_state.h"
#include "pipeline/hybrid/views/candidate_poses.h"
#include "pipeline/hybrid/views/training_views.h"
#include "pipeline/splat/train/trainer.h"

namespace macula::hybrid {

struct PeripheralOptions {
    std::uint64_t firstSteps = 700;       // of the first round (first_model.h)
    std::uint64_t roundSteps = 1000;      // of each later round (refinement.h)
    std::uint64_t settlingSteps = 100;    // in which rates fall once a round brings no more gain
    std::uint32_t firstCapacity = 11000;  // splats
    double splatsGrow = 1.5;              // each later round may have so many times as many
    std::uint32_t mostSplats = 50000;     // but no more than this
    int shDegree = 1;                     // of colours, from the first step; at least that of the start
    // A later round begins when the number of views has grown by this part since the last one.
    double newViewsForRound = 0.25;
    // Limit of learnt and held-out views together. A picture of 512 x 512 takes 5 MB on the device and 4 MB
    // on the host.
    std::size_t mostViews = 256;
    // The largest part that views may take of device memory that is free or already theirs.
    double viewsShare = 0.5;
    // Larger training views are halved until they fit: so few splats cannot show more detail.
    int learntSidePx = 1024;
    int heldOutSidePx = 256;  // larger ones are halved likewise
    // The model is judged so rarely that the pixels drawn for it are at most this part of those drawn for
    // training.
    double judgingShare = 0.1;
    // The trained model replaces the shown one if its held-out error is at most this part above that of the
    // best model that was shown.
    double shownMayBeWorse = 0.01;
    ErrorTrendOptions trend;
    CandidateOptions wanted;
    std::uint32_t seed = 0;
};

enum class Pause {
    none,
    noViews,      // there are no views to learn from yet
    flat,         // the held-out error hardly falls any more
    notJudged,    // the round is over, and too few pictures are held out to decide on more
    outOfMemory,  // a step failed, and would fail again
};
// A sentence for a person: "It has learnt what its pictures can teach it."
std::string_view describe(Pause pause);

// What the model did with an offered view.
enum class Offered { learnt, heldOut, nothingNew, full };

struct ShownModel {
    std::shared_ptr<const splat::Splats> splats;  // valid; never null
    // Grows whenever `splats` change, also across resume().
    std::uint64_t generation = 0;
};

struct PeripheralReport {
    Pause pause = Pause::none;
    splat::TrainingReport training;
    double trainingSeconds = 0.0;  // wall time since begin() or resume(), with judging
    double judgingSeconds = 0.0;   // the part of trainingSeconds that judging took
    std::size_t views = 0;         // learnt
    std::size_t heldOut = 0;
    std::optional<double> error;       // of the trained model, mean over the held-out pictures
    std::optional<double> shownError;  // of the shown model, over the same pictures
    // True once a shown model had no larger error than coarse pictures (coarselyShown); nothing while too
    // few pictures are held out.
    std::optional<bool> isSharp;
    std::optional<double> fallPerSecond;  // ErrorTrend
    std::uint64_t rounds = 0;
    bool noRoom = false;  // no device memory for more splats; training continues with the present ones
};

// Used by one thread at a time, the one that uses the device. Decisions depend on numbers of steps and views.
// Only whether the error still falls depends on time: if it does not, learning rates settle early, and then
// the model pauses. What it learns is a function of the seed, of the offered views and the steps at which
// they came, and of when it settled and paused.
class PeripheralModel {
  public:
    // Shows the start at once. Fails with usage and inputNotUsable as Trainer::create does, and outOfMemory.
    static Result<PeripheralModel> begin(const std::shared_ptr<gpu::Device>& device, const ModelStart& start,
                                         const PeripheralOptions& options);
    // Continues from state() or lastGood() of another model, for example after a lost device or from a file
    // (peripheral_file.h), and shows the same splats. Training continues bit for bit; the model finds out
    // again whether to pause. Fails as Trainer::resume does.
    static Result<PeripheralModel> resume(const std::shared_ptr<gpu::Device>& device,
                                          const PeripheralState& state, const PeripheralOptions& options);

    // Learns for about `budgetMs`, at least one training step or one comparison, and pauses when it is done;
    // asks `keepGoing` (may be empty) after each. Does nothing while it is paused. After deviceLost, shown()
    // and lastGood() remain. After outOfMemory it pauses, and continues from lastGood() when it wakes.
    Result<void> step(double budgetMs, const std::function<bool()>& keepGoing = {});
    bool isPaused() const { return pause_ != Pause::none; }

    // The pose from which a new picture would teach the model most (candidate_poses.h), among poses that show
    // enough of it; never a known one, nor one of the last eight it asked for. Nothing if the model is full
    // or no pose shows enough. Draws a few small pictures, and more only if the first ones show too little.
    Result<std::optional<CandidatePose>> wantedView();

    // Takes a picture of any field of view and size; reduces a large one. The model learns from it if it
    // shows something new (admit), and then wakes. It holds a few pictures out instead (held_out.h) if
    // `mayBeHeldOut`, or as long as fewer than two are; a model that paused as notJudged wakes when it can be
    // judged. Pass false for a view that a person looks at: the model should learn it. A picture with exactly
    // the same view as a learnt one replaces that one if it has more samples. Fails as Trainer::addView does,
    // and then nothing has changed.
    Result<Offered> offer(TracedView view, bool mayBeHeldOut = true);

    ShownModel shown() const { return {shown_, generation_}; }
    PeripheralReport report() const;

    // What resume() needs. state() waits for the device; lastGood() is at most two seconds of training older,
    // and already on the host.
    Result<PeripheralState> state() const;
    PeripheralState lastGood() const;

  private:
    PeripheralModel(std::shared_ptr<gpu::Device> device, const PeripheralOptions& options,
                    splat::Trainer trainer, PeripheralState notes);

    static Result<splat::Trainer> beginTrainer(const std::shared_ptr<gpu::Device>& device,
                                               const ModelStart& start, const PeripheralOptions& options);
    Result<void> takeHeldOut(std::span<const std::shared_ptr<const splat::TrainingView>> pictures);
    bool isFull() const;
    bool isKnown(const splat::RasterView& view) const;
    std::vector<KnownPose> knownViews() const;
    std::uint64_t stepsBetweenJudging() const;
    Result<void> beginRoundIfDue();
    Result<bool> beginRound(std::uint32_t capacity);
    Result<bool> goOnWith(const splat::TrainerOptions& options, int shDegree);
    Result<void> learn(const std::function<bool()>& goesOn);
    Result<void> judgeNext();
    Result<void> showIfBetter();
    void noteSharpness();
    Result<void> pauseOrSettle();
    void wake();

    std::shared_ptr<gpu::Device> device_;
    PeripheralOptions options_;
    splat::Trainer trainer_;
    PeripheralState notes_;  // without `training`, `heldOut`, `shown` and `best`
    HeldOutPictures heldOut_;
    AskedViews asked_;
    std::shared_ptr<const splat::Splats> shown_;
    std::shared_ptr<const splat::Splats> best_;  // of those that were shown
    std::uint64_t generation_;
    ErrorTrend trend_;
    bool isJudging_ = false;
    Pause pause_ = Pause::noViews;
    std::uint64_t rounds_ = 1;
    bool noRoom_ = false;
    bool isTaught_ = false;  // it began from an older model
    bool wasSharp_ = false;
    bool isTorn_ = false;                   // a step failed: the trainer must go back to lastGood()
    mutable std::vector<double> coverage_;  // judgedCoverage of the trainer's first views
    double trainingSeconds_ = 0.0;
    double judgingSeconds_ = 0.0;
};

}  // namespace macula::hybrid
