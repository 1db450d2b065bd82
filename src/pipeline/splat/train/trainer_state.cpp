// Saving the trainer's state, and resuming from one.
#include "base/check.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/splat/model/splat_components.h"
#include "pipeline/splat/train/trainer.h"

namespace macula::splat {

Result<TrainingState> Trainer::state() const {
    TrainingState state{.options = options_, .steps = steps_};
    MACULA_TRY(state.splats, snapshot());
    MACULA_TRY(state.optimizer, optimizer_.download(count_));
    state.statistics.resize(count_);
    if (count_ > 0)
        MACULA_TRY_VOID(
            gpu::readInto(rasterizer_.statistics(), 0, std::as_writable_bytes(std::span(state.statistics))));
    for (const TrainedView& view : views_)
        state.views.push_back({.given = view.given, .loss = view.loss, .l1 = view.l1});
    return state;
}

Result<void> Trainer::keep() {
    MACULA_TRY(lastGood_, state());
    keptAt_ = std::chrono::steady_clock::now();
    return {};
}

Result<void> Trainer::restore(const TrainingState& state) {
    MACULA_TRY_VOID(optimizer_.upload(state.optimizer));
    if (!state.statistics.empty())
        MACULA_TRY_VOID(gpu::uploadTo<shared::SplatStatistics>(rasterizer_.statistics(), state.statistics));
    steps_ = state.steps;
    return {};
}

Result<void> Trainer::goBack() {
    MACULA_TRY_VOID(parameters_.upload(componentsOf(lastGood_.splats)));
    count_ = static_cast<std::uint32_t>(lastGood_.splats.size());
    MACULA_TRY_VOID(restore(lastGood_));
    MACULA_CHECK_EQ(views_.size(), lastGood_.views.size());
    for (std::size_t i = 0; i < views_.size(); ++i) {
        views_[i].loss = lastGood_.views[i].loss;
        views_[i].l1 = lastGood_.views[i].l1;
    }
    views_.tryAllAgain();
    return {};
}

Result<Trainer> Trainer::resume(const std::shared_ptr<gpu::Device>& device, const TrainingState& state) {
    MACULA_TRY_VOID(state.validate());
    MACULA_TRY(Trainer trainer, create(device, state.splats, state.options));
    MACULA_TRY_VOID(trainer.restore(state));
    for (const TrainingState::View& view : state.views) {
        MACULA_TRY_VOID(trainer.addView(view.given));
        trainer.views_.last().loss = view.loss;
        trainer.views_.last().l1 = view.l1;
    }
    trainer.lastGood_ = state;
    return trainer;
}

// Makes a new trainer, but keeps the pictures, which may be most of what the device holds.
Result<void> Trainer::goOnWith(const TrainerOptions& options, int shDegree) {
    MACULA_TRY(TrainingState now, state());
    now.splats.setShDegree(shDegree);
    const std::size_t numbers = now.splats.size() * static_cast<std::size_t>(componentCount(shDegree));
    now.optimizer.first.resize(numbers, 0.0f);  // the coefficients of higher degree come last
    now.optimizer.second.resize(numbers, 0.0f);
    MACULA_TRY(Trainer other, create(device_, now.splats, options));
    MACULA_TRY_VOID(other.restore(now));
    now.options = other.options_;
    other.lastGood_ = std::move(now);
    other.views_ = std::move(views_);
    other.loss_ = std::move(loss_);
    other.views_.tryAllAgain();
    *this = std::move(other);
    return {};
}

}  // namespace macula::splat
