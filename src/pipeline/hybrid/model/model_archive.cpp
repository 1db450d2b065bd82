#include "pipeline/hybrid/model/model_archive.h"

#include <thread>
#include <utility>

namespace macula::hybrid {

namespace {

constexpr std::chrono::milliseconds kStoreIsAskedEvery{2};

}  // namespace

ModelArchive::ModelArchive(std::shared_ptr<ModelShelf> shelf, std::shared_ptr<ModelStore> store,
                           const LiveModelOptions& options)
    : shelf_(std::move(shelf)),
      store_(std::move(store)),
      mostWait_(options.mostWaitForStore),
      leastBetween_(options.leastBetweenKeeping) {}

void ModelArchive::beginAsking() {
    askingSince_ = std::chrono::steady_clock::now();
}

std::optional<StoredModel> ModelArchive::answer(const std::string& key, bool isDrawn, bool hasOther,
                                                const std::function<bool()>& goesOn) {
    while (true) {
        StoredModel stored = whole_ ? *whole_ : store_->find(key);
        const bool isLate = std::chrono::steady_clock::now() - *askingSince_ > mostWait_;
        const bool isPending = stored.answer == StoredModel::Answer::pending ||
                               (stored.answer == StoredModel::Answer::drawable && isDrawn);
        if (!isPending || (isLate && hasOther)) return stored;
        if (!goesOn()) return std::nullopt;
        std::this_thread::sleep_for(kStoreIsAskedEvery);
    }
}

void ModelArchive::putWholeOnShelf() {
    if (whole_) shelf_->put(whole_->state);
}

void ModelArchive::put(PeripheralState state, double gain) {
    state.gain = gain;
    const auto kept = std::make_shared<const PeripheralState>(std::move(state));
    shelf_->put(kept);
    giveToStore(kept);
}

void ModelArchive::giveToStore(std::shared_ptr<const PeripheralState> state) {
    keptAt_ = std::chrono::steady_clock::now();
    const Kept now{.steps = state->training.steps, .generation = state->generation, .gain = state->gain};
    if (!store_ || now == kept_) return;
    kept_ = now;
    store_->keep(std::move(state));
}

void ModelArchive::putSometimes(const PeripheralModel& model, double gain) {
    if (!store_ || std::chrono::steady_clock::now() - keptAt_ < leastBetween_) return;
    PeripheralState state = model.lastGood();
    state.gain = gain;
    giveToStore(std::make_shared<const PeripheralState>(std::move(state)));
}

void ModelArchive::noteResumed(const PeripheralModel& model, double gain) {
    kept_ = {.steps = model.report().training.steps, .generation = model.shown().generation, .gain = gain};
    keptAt_ = std::chrono::steady_clock::now();
}

void ModelArchive::forget() {
    endAsking();
    dropWhole();
    kept_ = {};
    keptAt_ = std::chrono::steady_clock::now();
}

}  // namespace macula::hybrid
