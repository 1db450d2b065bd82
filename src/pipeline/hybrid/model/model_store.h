// Where peripheral models are kept for longer than the program runs, as a live model (live_model.h) sees it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "base/frames.h"
#include "pipeline/hybrid/model/peripheral_state.h"
#include "pipeline/splat/model/splats.h"

namespace macula::hybrid {

// What is known of the stored model of a key.
struct StoredModel {
    enum class Answer {
        pending,   // it is looked for
        none,      // there is none
        damaged,   // there was one, which is no longer what was saved
        warm,      // one under other lights, whose `splats` training begins with
        stale,     // one of another trainer or tracer: likewise
        drawable,  // `splats` are what was shown when it was saved, and can be shown; the state is read
        whole,     // and here is the state too
    } answer = Answer::pending;
    std::shared_ptr<const splat::Splats> splats{};  // valid; of warm, stale, drawable and whole
    std::uint64_t steps = 0;                        // of training
    double gain = 1.0;                              // PeripheralState::gain, and seenMm
    Box seenMm{};
    std::shared_ptr<const PeripheralState> state{};  // its key is the one asked for
};

// Both return at once, whatever the disk does. Called by the thread of the live model.
class ModelStore {
  public:
    ModelStore() = default;
    ModelStore(const ModelStore&) = delete;
    ModelStore& operator=(const ModelStore&) = delete;
    virtual ~ModelStore() = default;

    // Asked again and again, until the answer is neither pending nor drawable. `whole` may be given once
    // only: who gets it keeps it.
    virtual StoredModel find(const std::string& key) = 0;
    // Saves it under its key, training.options.key, in place of the one of before.
    virtual void keep(std::shared_ptr<const PeripheralState> state) = 0;
};

}  // namespace macula::hybrid
