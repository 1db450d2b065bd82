// The interface through which a live model (live_model.h) keeps peripheral models between runs.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "base/frames.h"
#include "pipeline/hybrid/model/peripheral_state.h"
#include "pipeline/splat/model/splats.h"

namespace macula::hybrid {

// What the store knows so far about the model of a key.
struct StoredModel {
    enum class Answer {
        pending,   // the store is looking
        none,      // there is none
        damaged,   // there was a model, but its data are damaged
        warm,      // one under other lights, whose `splats` training begins with
        stale,     // likewise one of another trainer or tracer version
        drawable,  // `splats`, as shown when the model was saved, can be drawn; the state is being read
        whole,     // the state is here too
    } answer = Answer::pending;
    std::shared_ptr<const splat::Splats> splats{};  // valid; set for warm, stale, drawable and whole
    std::uint64_t steps = 0;                        // of training
    double gain = 1.0;                              // PeripheralState::gain; likewise seenMm
    Box seenMm{};
    std::shared_ptr<const PeripheralState> state{};  // its key is the requested one
};

// Both functions return at once, however slow the disk is. Called by the thread of the live model.
class ModelStore {
  public:
    ModelStore() = default;
    ModelStore(const ModelStore&) = delete;
    ModelStore& operator=(const ModelStore&) = delete;
    virtual ~ModelStore() = default;

    // The caller polls this until the answer is neither pending nor drawable. `whole` may be given only once:
    // the caller must keep it.
    virtual StoredModel find(const std::string& key) = 0;
    // Saves the state under its key, training.options.key, in place of an older one.
    virtual void keep(std::shared_ptr<const PeripheralState> state) = 0;
};

}  // namespace macula::hybrid
