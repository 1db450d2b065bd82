#include "pipeline/hybrid/model/model_shelf.h"

#include <algorithm>

#include "pipeline/splat/model/splat_components.h"

namespace macula::hybrid {

namespace {

std::uint64_t bytesOf(const splat::TrainingView& view) {
    return view.pixels.size() * sizeof(glm::vec4);
}

std::uint64_t numbersOf(const splat::Splats& splats) {
    return splats.size() * static_cast<std::uint64_t>(splat::componentCount(splats.shDegree));
}

}  // namespace

std::uint64_t bytesOf(const PeripheralState& state) {
    // Parameters, two moments of Adam, steps and statistics.
    std::uint64_t bytes = 12 * numbersOf(state.training.splats) + 20 * state.training.splats.size();
    for (const auto& shown : {state.shown, state.best})
        if (shown) bytes += 4 * numbersOf(*shown);
    for (const auto& view : state.training.views) bytes += bytesOf(*view.given);
    for (const auto& view : state.heldOut) bytes += bytesOf(*view);
    return bytes;
}

void ModelShelf::put(std::shared_ptr<const PeripheralState> state) {
    states_.remove_if(
        [&](const auto& other) { return other->training.options.key == state->training.options.key; });
    if (bytesOf(*state) > mostBytes_) return;
    states_.push_front(std::move(state));
    std::uint64_t bytes = 0;
    states_.erase(std::find_if(states_.begin(), states_.end(),
                               [&](const auto& kept) {
                                   bytes += bytesOf(*kept);
                                   return bytes > mostBytes_;
                               }),
                  states_.end());
}

std::shared_ptr<const PeripheralState> ModelShelf::find(const std::string& key) {
    const auto found = std::find_if(states_.begin(), states_.end(),
                                    [&](const auto& state) { return state->training.options.key == key; });
    if (found == states_.end()) return nullptr;
    states_.splice(states_.begin(), states_, found);
    return states_.front();
}

}  // namespace macula::hybrid
