// How a peripheral model begins, and how it resumes from a stored state.
#include <algorithm>
#include <utility>

#include "pipeline/hybrid/model/first_model.h"
#include "pipeline/hybrid/model/peripheral_model.h"
#include "pipeline/hybrid/model/training_rounds.h"

namespace macula::hybrid {

namespace {

splat::TrainerOptions firstRound(const std::string& key, const PeripheralOptions& options) {
    FirstModelOptions first;
    first.iterations = options.firstSteps;
    first.capacity = options.firstCapacity;
    first.sizePx = options.wanted.sizePx.y;
    first.trial = options.seed;
    // A start from points looks best at the size at which it is viewed; halved pictures would spoil that for
    // a while. Squared differences are never used.
    splat::TrainerOptions training = comparedAsJudged(trainerOptions(first));
    training.key = key;
    return training;
}

}  // namespace

PeripheralModel::PeripheralModel(std::shared_ptr<gpu::Device> device, const PeripheralOptions& options,
                                 splat::Trainer trainer, PeripheralState notes)
    : device_(std::move(device)),
      options_(options),
      trainer_(std::move(trainer)),
      notes_(std::move(notes)),
      asked_(options_.wanted.sizePx),
      shown_(std::make_shared<const splat::Splats>(trainer_.lastGood().splats)),
      best_(shown_),
      generation_(notes_.generation + 1),
      trend_(options_.trend),
      pause_(trainer_.viewCount() > 0 ? Pause::none : Pause::noViews) {}

Result<splat::Trainer> PeripheralModel::beginTrainer(const std::shared_ptr<gpu::Device>& device,
                                                     const ModelStart& start,
                                                     const PeripheralOptions& options) {
    if (!(start.seenMm.diagonal() > 0.0))
        return Error{ErrorCode::usage,
                     Text("There is nothing to be seen."),
                     {},
                     Text("Choose a preset that shows something of the series.")};
    splat::Splats splats = start.splats;
    splats.setShDegree(std::max(options.shDegree, splats.shDegree));
    return splat::Trainer::create(device, splats, firstRound(start.key, options));
}

Result<PeripheralModel> PeripheralModel::begin(const std::shared_ptr<gpu::Device>& device,
                                               const ModelStart& start, const PeripheralOptions& options) {
    MACULA_TRY(splat::Trainer trainer, beginTrainer(device, start, options));
    PeripheralState notes{.seenMm = start.seenMm};
    notes.first = trainer.lastGood().options;
    PeripheralModel model(device, options, std::move(trainer), std::move(notes));
    model.isTaught_ = start.isTaught;
    return model;
}

Result<PeripheralModel> PeripheralModel::resume(const std::shared_ptr<gpu::Device>& device,
                                                const PeripheralState& state,
                                                const PeripheralOptions& options) {
    splat::TrainingState training = state.training;
    training.options = comparedAsJudged(std::move(training.options));  // a file may end with squares
    MACULA_TRY(splat::Trainer trainer, splat::Trainer::resume(device, training));
    PeripheralState notes = state;
    if (notes.first.capacity == 0) notes.first = firstRound(state.training.options.key, options);
    notes.training = {};
    notes.heldOut.clear();
    notes.shown = notes.best = nullptr;
    PeripheralModel model(device, options, std::move(trainer), std::move(notes));
    if (state.shown) model.shown_ = state.shown;
    model.best_ = state.best ? state.best : model.shown_;
    MACULA_TRY_VOID(model.takeHeldOut(state.heldOut));
    return model;
}

Result<PeripheralState> PeripheralModel::state() const {
    PeripheralState state = lastGood();
    if (isTorn_) return state;
    MACULA_TRY(state.training, trainer_.state());
    return state;
}

PeripheralState PeripheralModel::lastGood() const {
    PeripheralState state = notes_;
    state.generation = generation_;
    state.training = trainer_.lastGood();
    for (const HeldOutPicture& h : heldOut_) state.heldOut.push_back(h.picture);
    state.shown = shown_;
    if (best_ != shown_) state.best = best_;
    return state;
}

}  // namespace macula::hybrid
