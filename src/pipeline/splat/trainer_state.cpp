// The trainer's state: out of it, and into another.
#include "base/check.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/splat/trainer.h"

namespace macula::splat {

Result<TrainingState> Trainer::state() const {
    TrainingState state{.options = options_, .steps = steps_};
    MACULA_TRY(state.splats, snapshot());
    MACULA_TRY(state.optimizer, optimizer_.download(count_));
    state.statistics.resize(count_);
    if (count_ > 0)
        MACULA_TRY_VOID(
            gpu::readInto(rasterizer_.statistics(), 0, std::as_writable_bytes(std::span(state.statistics))));
    for (const View& view : views_)
        state.views.push_back({.given = view.given, .loss = view.loss, .l1 = view.l1});
    return state;
}

Result<void> Trainer::keep() {
    MACULA_TRY(lastGood_, state());
    keptAt_ = std::chrono::steady_clock::now();
    return {};
}

Result<Trainer> Trainer::resume(const std::shared_ptr<gpu::Device>& device, const TrainingState& state) {
    MACULA_TRY_VOID(state.validate());
    MACULA_TRY(Trainer trainer, create(device, state.splats, state.options));
    MACULA_TRY_VOID(trainer.optimizer_.upload(state.optimizer));
    if (!state.statistics.empty())
        MACULA_TRY_VOID(
            gpu::uploadTo<shared::SplatStatistics>(trainer.rasterizer_.statistics(), state.statistics));
    for (const TrainingState::View& view : state.views) {
        MACULA_TRY_VOID(trainer.addView(view.given));
        trainer.views_.back().loss = view.loss;
        trainer.views_.back().l1 = view.l1;
    }
    trainer.steps_ = state.steps;
    trainer.lastGood_ = state;
    return trainer;
}

}  // namespace macula::splat
