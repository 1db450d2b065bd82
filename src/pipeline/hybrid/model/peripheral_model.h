// The peripheral model as something that runs by itself: it learns for as long as that is of use, says from
// where it wants to see more, and takes in whatever picture it is offered. Whoever owns it has the device and
// the tracer, and does in turn:
//
//     model.step(20.0);                                // nothing while it is paused
//     if (draw(model.shown()); ...)                    // a copy on the host, which no loss takes away
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
#include "pipeline/hybrid/views/asked_views.h"
#include "pipeline/hybrid/views/candidate_poses.h"
#include "pipeline/hybrid/views/training_views.h"
#include "pipeline/splat/train/trainer.h"

namespace macula::hybrid {

struct PeripheralOptions {
    std::uint64_t firstSteps = 700;       // of the first round (first_model.h)
    std::uint64_t roundSteps = 1000;      // of each later one (refinement.h)
    std::uint64_t settlingSteps = 100;    // in which learning rates fall when a round is of no more use
    std::uint32_t firstCapacity = 11000;  // splats
    double splatsGrow = 1.5;              // a later round may have so many times those there are
    std::uint32_t mostSplats = 50000;     // and no more than that
    int shDegree = 1;                     // of colours, from the start on; never less than the start has
    // A later round begins when the model has so many more views, in parts of those it had at the last one.
    double newViewsForRound = 0.25;
    // Views learnt and held out, together. A picture of 512 x 512 takes 5 MB on the device and 4 MB on the
    // host.
    std::size_t mostViews = 256;
    // The most that views take of the device's memory that is free or theirs, as a part of it.
    double viewsShare = 0.5;
    // A larger picture to learn from is reduced by halves: so few splats show no more detail.
    int learntSidePx = 1024;
    int heldOutSidePx = 256;  // at most: larger ones are reduced
    // Held-out pictures are judged so seldom that their pixels are at most this part of those that training
    // draws.
    double judgingShare = 0.1;
    // The shown model is replaced by the trained one when the held-out error of that is at most this part
    // above the error of the best that was shown.
    double shownMayBeWorse = 0.01;
    ErrorTrendOptions trend;
    CandidateOptions wanted;
    std::uint32_t seed = 0;
};

enum class Pause {
    none,
    noViews,      // there is nothing to learn from yet
    flat,         // the held-out error falls no more by what is worth it
    notJudged,    // all rates have come to rest, and too few pictures are held out to tell more
    outOfMemory,  // the step that failed would fail again
};
// For a person: "It has learnt what its views can teach it."
std::string_view describe(Pause pause);

// What became of a view that was offered.
enum class Offered { learnt, heldOut, nothingNew, full };

struct ShownModel {
    std::shared_ptr<const splat::Splats> splats;  // valid; never null
    // A larger one whenever `splats` are others, in a model that goes on with another one's state too.
    std::uint64_t generation = 0;
};

struct PeripheralReport {
    Pause pause = Pause::none;
    splat::TrainingReport training;
    double trainingSeconds = 0.0;  // by the clock, since it began or was changed; judging included
    double judgingSeconds = 0.0;   // the part of trainingSeconds that judging took
    std::size_t views = 0;         // learnt
    std::size_t heldOut = 0;
    std::optional<double> error;       // mean over the held-out pictures, as they are now
    std::optional<double> shownError;  // of the shown model, over the same pictures
    // Since one that was shown had a smaller error than coarse pictures have (coarse_picture.h); nothing
    // while too few are held out.
    std::optional<bool> isSharp;
    std::optional<double> fallPerSecond;  // ErrorTrend
    std::uint64_t rounds = 0;
    bool noRoom = false;  // the device had no memory for more splats; training goes on with those there are
};

// Used by one thread at a time, the one that uses the device. Decisions go by numbers of steps and views.
// Only whether the error still falls goes by time: when it does not, learning rates settle early, and then
// the model pauses. What it learns is a function of the seed, of what it was offered after which step, and of
// when it settled and was paused.
class PeripheralModel {
  public:
    // Shows the start at once. usage and inputNotUsable as Trainer::create; outOfMemory.
    static Result<PeripheralModel> begin(const std::shared_ptr<gpu::Device>& device, const ModelStart& start,
                                         const PeripheralOptions& options);
    // Goes on with state() or lastGood() of another one, after its device was lost or its file was read
    // (peripheral_file.h), say, and shows what that showed. The trainer goes on to the same bits; whether it
    // had paused is found out again. Fails as Trainer::resume.
    static Result<PeripheralModel> resume(const std::shared_ptr<gpu::Device>& device,
                                          const PeripheralState& state, const PeripheralOptions& options);

    // Learns for about `budgetMs`, at least one step of training or one comparison, and pauses by itself;
    // `keepGoing` (may be empty) is asked after each. Does nothing while it is paused. deviceLost: shown()
    // and lastGood() are what is left. outOfMemory: it pauses, and goes on from lastGood() when it wakes.
    Result<void> step(double budgetMs, const std::function<bool()>& keepGoing = {});
    bool isPaused() const { return pause_ != Pause::none; }

    // The pose from which a new picture would teach it most (candidate_poses.h), of those views in which it
    // shows enough; never one that it has, or that was among the last eight it asked for. Nothing when it is
    // full or no view shows enough. Draws a few small pictures, more only where the first ones show too
    // little.
    Result<std::optional<CandidatePose>> wantedView();

    // Takes a picture of any field of view and size; a large one is reduced. The model learns from it if it
    // shows something new (admit), and then wakes. A few pictures are held out instead (held_out.h) if
    // `mayBeHeldOut` or fewer than two are; a model that paused as notJudged wakes when it can be judged.
    // Pass false for a view that a person looks at: the model should learn all of that. A picture of exactly
    // the same view as one that it learns from replaces that one if it has more samples. Fails as
    // Trainer::addView, and then nothing has changed.
    Result<Offered> offer(TracedView view, bool mayBeHeldOut = true);

    ShownModel shown() const { return {shown_, generation_}; }
    PeripheralReport report() const;

    // What resume needs; waits. lastGood: at most two seconds of training older, and on the host already.
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
    PeripheralState notes_;  // but for `training`, `heldOut` and models that are shown
    HeldOutPictures heldOut_;
    AskedViews asked_;
    std::shared_ptr<const splat::Splats> shown_;
    std::shared_ptr<const splat::Splats> best_;  // of what was shown
    std::uint64_t generation_;
    ErrorTrend trend_;
    bool isJudging_ = false;
    Pause pause_ = Pause::noViews;
    std::uint64_t rounds_ = 1;
    bool noRoom_ = false;
    bool isTaught_ = false;  // it did not begin as points
    bool wasSharp_ = false;
    bool isTorn_ = false;                   // a step failed: the trainer has to go back
    mutable std::vector<double> coverage_;  // of the views of the trainer, as far as it was needed
    double trainingSeconds_ = 0.0;
    double judgingSeconds_ = 0.0;
};

}  // namespace macula::hybrid
